"""The gas program alone, on a small box, under mpirun."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml
from pathlib import Path

BIN = Path(sys.argv.pop(1) if len(sys.argv) > 1 else "build").resolve()

GAS = """\
[grid]
lo = [0, 0, 0]
hi = [0.1, 0.1, 0.2]
cells = @cells@
[time]
end = @end@
[boundary]
z_hi = "outlet"
[[inflow]]
side = "z_lo"
velocity = 1
[output]
every = @every@
"""


class Run:
    """A folder with gas.toml, removed at the end of a test; results are in `out`."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="gasgrain-test-"))
        self.out = self.folder / "out"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def snapshot_times(self):
        """As the file for ParaView lists them."""
        times = xml.parse(self.out / "gas.xdmf").getroot().findall("./Domain/Grid/Grid/Time")
        return [float(time.get("Value")) for time in times]

    def start(self, *options, ranks=1, end=0.02, every=0.0, cells="[8, 8, 16]", blocks=None,
              preload="", more=""):
        """The process: mpirun, or the program itself where `ranks` is 0. `blocks`: limit of a file's
        size, of 512 B; `preload`: a library that stands before the system's; `more`: of gas.toml,
        after [output]."""
        text = GAS
        for mark, value in {"end": end, "every": every, "cells": cells}.items():
            text = text.replace(f"@{mark}@", str(value))
        (self.folder / "gas.toml").write_text(text + more)
        limit = f"ulimit -f {blocks}; " if blocks else ""
        limit += f"export LD_PRELOAD={preload}; " if preload else ""
        # Only the ranks are limited, and not their shared memory, which is files too.
        environment = dict(os.environ, OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_btl="tcp,self",
                           OMP_NUM_THREADS="1")
        launch = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none",
                  "-np", str(ranks)] if ranks > 0 else []
        return subprocess.Popen(
            [*launch, "sh", "-c", limit + 'exec "$0" "$@"', str(BIN / "gasgrain-gas"),
             "gas.toml", "--out", str(self.out), *options],
            cwd=self.folder, env=environment, text=True, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def gas(self, *options, timeout=60, **choices):
        """(exit status, everything printed, seconds) of a run as of start()."""
        begin = time.monotonic()
        process = self.start(*options, **choices)
        try:
            text, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            text, _ = process.communicate()
            raise AssertionError(f"the run hung for {timeout} s:\n{text}") from None
        return process.returncode, text, time.monotonic() - begin

#!/usr/bin/python3
"""A disk that fills up while the gas runs: one message names file and cause, nothing hangs, and the
last good checkpoint is still there.

A limit of a file's size stands for the disk's end; where the test may mount one, a small disk is
filled as well.
"""

import shutil
import subprocess
import unittest

from gas_alone import BIN, Run

SOON = 15.0  # s; ranks that did not meet the error themselves are given 3 s


class Disk(unittest.TestCase):
    def expect_error(self, result, *words):
        status, text, seconds = result
        self.assertNotEqual(status, 0, text)
        self.assertLess(seconds, SOON, text)
        messages = [line for line in text.splitlines() if "gasgrain-gas: error:" in line]
        self.assertEqual(len(messages), 1, text)
        for word in words:
            self.assertIn(word, messages[0])

    def expect_fine(self, result):
        status, text, _ = result
        self.assertEqual(status, 0, text)

    def test_no_room_for_a_checkpoint(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.expect_fine(run.gas(ranks=ranks))
                file = run.out / "gas.checkpoint.h5"
                before = file.read_bytes()
                restart = ("--restart", str(file))
                self.expect_error(run.gas(*restart, ranks=ranks, end=0.04, blocks=200),
                                  f"{file}.new cannot be written", "limit of a file's size")
                self.assertEqual(file.read_bytes(), before)
                self.assertFalse(file.with_name(file.name + ".new").exists())
                self.expect_fine(run.gas(*restart, ranks=ranks, end=0.04))

    def test_no_room_for_a_snapshot(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.expect_error(run.gas(ranks=ranks, every=0.005, blocks=300),
                                  f"{run.out}/gas.h5 cannot be written", "limit of a file's size")

    def test_writes_that_fail_without_a_warning(self):
        # 3 blocks: the head of the file; 64, 200: within a field.
        preload = next(BIN.rglob("libunknown_room.so"))
        for ranks in (1, 2):
            for blocks in (3, 64, 200):
                with self.subTest(ranks=ranks, blocks=blocks), Run() as run:
                    self.expect_fine(run.gas(ranks=ranks))
                    file = run.out / "gas.checkpoint.h5"
                    before = file.read_bytes()
                    restart = ("--restart", str(file))
                    self.expect_error(run.gas(*restart, ranks=ranks, end=0.04, blocks=blocks,
                                              preload=preload),
                                      f"{file}.new: cannot", ": File too large.")
                    self.assertEqual(file.read_bytes(), before)
                    self.expect_fine(run.gas(*restart, ranks=ranks, end=0.04))

    def test_a_checkpoint_that_is_cut_short(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.expect_fine(run.gas(ranks=ranks))
                file = run.out / "gas.checkpoint.h5"
                file.write_bytes(file.read_bytes()[:-1000])
                self.expect_error(run.gas("--restart", str(file), ranks=ranks, end=0.04),
                                  f"{file} cannot be opened: it is cut short or damaged")

    def test_no_room_for_the_history(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                self.expect_error(run.gas(ranks=ranks, end=1, blocks=1),
                                  f"{run.out}/history.csv: cannot be written: File too large.")

    def test_a_full_device_in_place_of_the_history(self):
        with Run() as run:
            run.out.mkdir()
            (run.out / "history.csv.new").symlink_to("/dev/full")
            self.expect_error(run.gas(), f"{run.out}/history.csv: cannot be written")

    def test_a_folder_that_cannot_be_made(self):
        with Run() as run:
            run.out.write_text("in the way")
            self.expect_error(run.gas(), str(run.out))

    def test_a_disk_that_is_full(self):
        with Run() as run:
            disk = run.folder / "disk"
            disk.mkdir()
            if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", str(disk)],
                              capture_output=True, check=False).returncode != 0:
                self.skipTest("may not mount a small disk")
            try:
                run.out = disk / "out"
                for ranks in (1, 2):
                    shutil.rmtree(run.out, ignore_errors=True)
                    self.expect_error(run.gas(ranks=ranks, every=0.002),
                                      f"{run.out}/gas.h5 cannot be written", "are free on the disk")
                    shutil.rmtree(run.out)
                    (disk / "filler").write_bytes(bytes(60000))
                    self.expect_error(run.gas(ranks=ranks),
                                      f"{run.out}/gas.checkpoint.h5.new cannot be written",
                                      "are free on the disk")
                    self.assertFalse((run.out / "gas.checkpoint.h5.new").exists())
                    (disk / "filler").unlink()
            finally:
                subprocess.run(["umount", str(disk)], check=False)


if __name__ == "__main__":
    unittest.main(verbosity=2)

#!/usr/bin/python3
"""Who may include whom: the folders' order of dependence, checked over the real tree.

Paths of ours are written from the project's root. A quoted name that is no file of ours is a header
of the DEM host.
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
FOLDERS = ("coupling", "fix_cfd_coupling", "gas_solver", "tools", "tests")

BASE = "coupling/base/"
EXCHANGE = "coupling/exchange/"
TRANSPORT = "coupling/transport/"
PHYSICS = "fix_cfd_coupling/dem_physics/"
# Compiled with the headers of either host, and with its dialect's of the same names.
FIXES = "fix_cfd_coupling/fixes/"
HOSTS = ("fix_cfd_coupling/liggghts/", "fix_cfd_coupling/lammps/")
SEES_HOST = (*HOSTS, FIXES)

# (where, what of ours it may include besides its own folder); the first that fits counts.
RULES = (
    (BASE, ()),
    (EXCHANGE, (BASE,)),
    (TRANSPORT, (BASE, EXCHANGE)),
    ("coupling/", (BASE, EXCHANGE, TRANSPORT)),
    (PHYSICS, (BASE,)),
    (FIXES, (BASE, EXCHANGE, TRANSPORT, "coupling/", PHYSICS)),
    (HOSTS[0], (BASE, EXCHANGE, TRANSPORT, "coupling/", PHYSICS, FIXES)),
    (HOSTS[1], (BASE, EXCHANGE, TRANSPORT, "coupling/", PHYSICS, FIXES)),
    ("gas_solver/", (BASE,)),
    ("tools/", (BASE, EXCHANGE, PHYSICS, "gas_solver/")),
    ("tests/", (BASE, EXCHANGE, TRANSPORT, "coupling/", PHYSICS, "gas_solver/", "tools/")),
)
# The gas solver meets the coupling in its main and in its ports.
GAS_MEETS_COUPLING = re.compile(
    r"gas_solver/(gas_main|coupling_port|coupled_gas_port|inner_gas_port)\.(h|cpp)")

# What of others the base may lean on: Eigen and MPI, and the two libraries behind its messages and
# its input files. A name without an extension is the standard library's.
BASE_LIBRARIES = re.compile(r"Eigen/.+|mpi\.h|fmt/.+|toml\+\+/.+|[a-z_]+")


def own_folder(file):
    """'gas_solver/' for gas_solver/grid/halo.h: the deepest folder that a rule names."""
    return next((where for where, _ in RULES if file.startswith(where)), "")


def faults_of_file(root, file):
    text = (root / file).read_text(encoding="utf-8")
    where = own_folder(file)
    allowed = dict(RULES).get(where, ())
    meets_coupling = GAS_MEETS_COUPLING.fullmatch(file)
    for match in INCLUDE.finditer(text):
        quoted, angled = match.groups()
        place = f"{file}:{text.count(chr(10), 0, match.start()) + 1}: "
        if angled:
            if where == BASE and not BASE_LIBRARIES.fullmatch(angled):
                yield place + f"coupling/base may not lean on <{angled}>"
            continue
        if not (root / quoted).is_file():
            if where not in SEES_HOST:
                yield place + f'"{quoted}" is no file of ours, and only host folders see the host'
            continue
        target = own_folder(quoted)
        if target in HOSTS and target != where:
            yield place + f"nobody includes {target}"
        elif target != where and target not in allowed and not (
                meets_coupling and target.startswith("coupling/")):
            yield place + f"{where} may not include {target}"


def source_files(root):
    for folder in FOLDERS:
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in (".h", ".cpp"):
                yield file.relative_to(root).as_posix()


def faults(root):
    return [fault for file in source_files(root) for fault in faults_of_file(root, file)]


class IncludeRules(unittest.TestCase):
    def test_the_tree_keeps_the_rules(self):
        self.assertGreater(len(list(source_files(ROOT))), 10, f"{ROOT} is not the source tree")
        self.assertEqual("\n".join(faults(ROOT)), "")

    def verdict(self, **files):
        """Faults of a tree with these files: a path with __ for / and ___ for the last dot."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                file = Path(folder) / name.replace("___", ".").replace("__", "/")
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text + "\n")
            return faults(Path(folder))

    def assert_caught(self, words, **files):
        found = self.verdict(**files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_base_that_includes_exchange_is_caught(self):
        self.assert_caught("coupling/base/a.h:2: coupling/base/ may not include coupling/exchange/",
                           coupling__exchange__b___h="",
                           coupling__base__a___h='\n#include "coupling/exchange/b.h"')

    def test_base_that_leans_on_a_further_library_is_caught(self):
        self.assert_caught("may not lean on <hdf5.h>",
                           coupling__base__a___cpp="#include <vector>\n#include <hdf5.h>")

    def test_exchange_that_includes_transport_is_caught(self):
        self.assert_caught("coupling/exchange/ may not include coupling/transport/",
                           coupling__transport__b___h="",
                           coupling__exchange__a___h='#include "coupling/transport/b.h"')

    def test_gas_solver_that_includes_the_coupling_is_caught_but_for_its_main_and_ports(self):
        line = '#include "coupling/transport/b.h"'
        self.assert_caught("gas_solver/ may not include coupling/transport/",
                           coupling__transport__b___h="",
                           gas_solver__grid__a___h=line,
                           gas_solver__gas_main___cpp=line,
                           gas_solver__coupling_port___cpp=line)

    def test_a_further_port_is_caught(self):
        self.assert_caught("gas_solver/ may not include coupling/transport/",
                           coupling__transport__b___h="",
                           gas_solver__a_port___h='#include "coupling/transport/b.h"')

    def test_a_host_header_outside_of_the_host_folders_is_caught(self):
        self.assert_caught('"fix.h" is no file of ours',
                           fix_cfd_coupling__dem_physics__a___h='#include "fix.h"',
                           fix_cfd_coupling__liggghts__a___h='#include "fix.h"')

    def test_an_include_of_a_host_folder_is_caught(self):
        self.assert_caught("nobody includes fix_cfd_coupling/liggghts/",
                           fix_cfd_coupling__liggghts__a___h="",
                           fix_cfd_coupling__lammps__b___h='#include "fix_cfd_coupling/liggghts/a.h"')

    def test_fixes_that_include_a_host_folder_are_caught_and_those_that_include_a_dialect_are_not(self):
        self.assert_caught("nobody includes fix_cfd_coupling/liggghts/",
                           fix_cfd_coupling__liggghts__a___h="",
                           fix_cfd_coupling__fixes__b___h='#include "fix_cfd_coupling/liggghts/a.h"',
                           fix_cfd_coupling__fixes__c___h='#include "dialect_fix.h"\n#include "fix.h"')

    def test_physics_that_includes_a_fix_is_caught_and_a_host_folder_that_does_is_not(self):
        line = '#include "fix_cfd_coupling/fixes/a.h"'
        self.assert_caught("dem_physics/ may not include fix_cfd_coupling/fixes/",
                           fix_cfd_coupling__fixes__a___h="",
                           fix_cfd_coupling__dem_physics__b___h=line,
                           fix_cfd_coupling__lammps__b___h=line)


if __name__ == "__main__":
    unittest.main()

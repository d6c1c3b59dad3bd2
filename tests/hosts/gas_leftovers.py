#!/usr/bin/python3
"""What a killed run leaves in shared memory does not stop the next one."""

import os
import unittest
from pathlib import Path

from gas_alone import Run

# Open MPI's semaphore of a file of this name, taken by a program that is no more (see
# coupling/base/file_locks.h). One of an earlier kill may be there already.
SEMAPHORE = Path("/dev/shm/sem.OMPIO_gas.h5")


class Leftovers(unittest.TestCase):
    def setUp(self):
        self.mine = not SEMAPHORE.exists()
        if self.mine:
            SEMAPHORE.write_bytes(bytes(32))

    def tearDown(self):
        if self.mine and SEMAPHORE.exists():
            os.remove(SEMAPHORE)

    def test_a_taken_semaphore_does_not_stop_a_run(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), Run() as run:
                status, text, _ = run.gas(ranks=ranks, every=0.01, timeout=30)
                self.assertEqual(status, 0, text)
                self.assertTrue((run.out / "gas.h5").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)

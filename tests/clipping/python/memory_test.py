# SPDX-License-Identifier: GPL-3.0-or-later
"""The memory of results that are given back: only its own pages may be left to the system."""
import re
import sys
import unittest

import numpy as np

import clearcut

WINDOW = (-100, -75, 100, 75)


def lazily_freed_beside_others():
    """How many kB of the heap, in which other memory is, the system may take although nobody freed it."""
    with open("/proc/self/smaps") as file:
        parts = re.split(r"^(?=[0-9a-f]+-[0-9a-f]+ )", file.read(), flags=re.M)
    heap = [part for part in parts if "[heap]" in part.partition("\n")[0]]
    return sum(int(kilobytes) for part in heap for kilobytes in re.findall(r"^LazyFree: +(\d+) kB", part, re.M))


def clip_and_give_back(rows, dtype):
    big = np.ones(1_000_000)  # 8 MB: once it is freed, malloc takes blocks of up to 8 MB from the heap
    del big
    lines = np.full((rows, 4), 1, dtype)
    found = clearcut.clip(lines, WINDOW)
    del found


@unittest.skipUnless(sys.platform == "linux", "only Linux tells which pages are freed lazily")
class Memory(unittest.TestCase):
    def test_other_memory_is_never_freed(self):
        """The rows whose results are as large as the smallest large block, and those beside them."""
        for dtype, bytes_of_piece in ((np.float64, 40), (np.float32, 24)):
            limit = 4 * 2**20 // bytes_of_piece
            for rows in range(limit - 4, limit + 4):
                with self.subTest(rows=rows, dtype=dtype):
                    clip_and_give_back(rows, dtype)
                    self.assertEqual(lazily_freed_beside_others(), 0)


if __name__ == "__main__":
    unittest.main()

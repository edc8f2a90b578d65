# SPDX-License-Identifier: MIT
"""Clips arrays that are larger than memory, or on several computers, with Dask. Needs dask; clusters need distributed.

Each chunk is clipped on its own by `clearcut.clip`, on the worker that has it. So a worker that is lost loses nothing:
Dask clips its chunks again elsewhere, and the result has the same bits.

>>> import dask.array as da, numpy as np, clearcut.dask
>>> lines = da.from_array(np.array([[-5., 5., 15., 5.], [20., 20., 30., 30.], [1., 1., 2., 2.]]), chunks=(2, 4))
>>> pieces = clearcut.dask.clip(lines, (0, 0, 10, 10))
>>> pieces.segments.compute(scheduler="sync")
array([[ 0.,  5., 10.,  5.],
       [ 1.,  1.,  2.,  2.]])
>>> pieces.source.compute(scheduler="sync")
array([0, 2])

`python3 -m clearcut.dask --help` is the same as a program.
"""
try:
    import dask as _dask
    import dask.array as _array
except ImportError:
    raise ImportError("clearcut.dask needs dask (Debian: python3-dask)") from None

from ._arrays import Pieces, clip
from ._csv import read_csv
from ._files import clip_to_files
from ._grid import grid
from ._npy import read_npy
from ._tiles import clip_at_windows, clip_to_tiles

__all__ = ["Pieces", "clip", "clip_at_windows", "clip_to_files", "clip_to_tiles", "grid", "read_csv", "read_npy"]

# SPDX-License-Identifier: CC0-1.0
"""Smooth random numbers that are the same on every machine: gradient noise over an integer hash."""

from functools import lru_cache
from math import cos, floor, pi, sin

_GRADIENTS = [(cos(2 * pi * k / 64), sin(2 * pi * k / 64)) for k in range(64)]


def chance(i, j, seed=0):
    """An integer below 2^32 for a pair of integers."""
    h = (i * 374761393 + j * 668265263 + seed * 2246822519) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 2654435761) & 0xFFFFFFFF
    return h ^ (h >> 15)


def unit(i, j, seed=0):
    """A number from 0 to 1 for a pair of integers."""
    return chance(i, j, seed) / 4294967296


@lru_cache(maxsize=None)
def _gradient(i, j, seed):
    return _GRADIENTS[chance(i, j, seed) & 63]


def noise(x, y, seed=0):
    """About -0.7 to 0.7, zero at integer coordinates."""
    i, j = floor(x), floor(y)
    u, v = x - i, y - j
    g00 = _gradient(i, j, seed)
    g10 = _gradient(i + 1, j, seed)
    g01 = _gradient(i, j + 1, seed)
    g11 = _gradient(i + 1, j + 1, seed)
    su, sv = u * u * u * (u * (6 * u - 15) + 10), v * v * v * (v * (6 * v - 15) + 10)
    low = g00[0] * u + g00[1] * v
    low += su * (g10[0] * (u - 1) + g10[1] * v - low)
    high = g01[0] * u + g01[1] * (v - 1)
    high += su * (g11[0] * (u - 1) + g11[1] * (v - 1) - high)
    return low + sv * (high - low)


def fractal(x, y, octaves, seed=0):
    """A sum of noises, each finer than the one before."""
    total, size = 0, 1
    for octave in range(octaves):
        total += size * noise(x, y, seed + octave)
        x, y, size = 2.03 * x + 17.3, 2.03 * y - 9.1, size / 2
    return total


def ridged(x, y, octaves, seed=0):
    """0 to 1, with sharp crests; finer crests sit on higher ground only."""
    total, size, weight, sum_of_sizes = 0, 1, 1, 0
    for octave in range(octaves):
        crest = max(0.0, 1 - 1.7 * abs(noise(x, y, seed + octave))) ** 2 * weight
        total += size * crest
        sum_of_sizes += size
        weight = min(1.0, 1.6 * crest)
        x, y, size = 2.07 * x + 5.2, 2.07 * y + 1.3, size * 0.5
    return total / sum_of_sizes

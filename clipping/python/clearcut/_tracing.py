# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import Any, Sequence

from . import _clearcut


def algorithms() -> list[dict[str, Any]]:
    """Every algorithm, each as a dict: key, abbreviation, name, year, idea, ulps (the bound of its error, in units in
    the last place of the largest coordinate), and which forms it has: published, polygon, line, ray.

    >>> import clearcut
    >>> [row["key"] for row in clearcut.algorithms() if row["line"]]
    ['liang-barsky', 'cyrus-beck', 'skala', 'matthes-drakopoulos']
    """
    return _clearcut.algorithms()


def trace(segment: Sequence[float], window: Sequence[float], algorithm: str = "exact",
          form: str = "corrected") -> list[dict[str, Any]]:
    """How an algorithm clips one segment, step by step.

    segment: (x1, y1, x2, y2); window: (xmin, ymin, xmax, ymax), in the same unit.
    algorithm: a key or abbreviation of `algorithms()`.
    form: "corrected", or "published", as its authors printed it.

    Each step is a dict: what ("test", "let", "cut", "accept", "reject" or "give up"), holds (the result of a test),
    name (of the variable that "let" assigns), line and code (of the pseudo-code), segment (what is left of it after
    the step), edge ("left", "right", "bottom" for ymin, "top" for ymax, or ""), and values (the variables that were
    assigned since the step before).

    >>> import clearcut
    >>> steps = clearcut.trace((-5, 5, 15, 5), (0, 0, 10, 10), "cohen-sutherland")
    >>> [step["what"] for step in steps if step["what"] != "let" and step["what"] != "test"]
    ['cut', 'cut', 'accept']
    >>> steps[-1]["segment"]
    (0.0, 5.0, 10.0, 5.0)
    """
    return _clearcut.trace(segment, window, algorithm, form)

# SPDX-License-Identifier: MIT
"""A plug-in for vpype: `vpype read drawing.svg clearcut crop 10mm 10mm 180mm 120mm write cropped.svg`.

Needs vpype. Installed together, vpype finds the command by itself (entry point vpype.plugins).
"""
from __future__ import annotations

from typing import Any

import click

try:
    from vpype_cli import LengthType, layer_processor
except ImportError:  # before vpype 1.9
    from vpype import LengthType, layer_processor  # type: ignore[no-redef]

from ._layers import cropped


@click.command()
@click.argument("action", type=click.Choice(["crop"]))
@click.argument("x", type=LengthType())
@click.argument("y", type=LengthType())
@click.argument("width", type=LengthType())
@click.argument("height", type=LengthType())
@layer_processor
def clearcut(lines: Any, action: str, x: float, y: float, width: float, height: float) -> Any:
    """Crop the geometries exactly.

    `clearcut crop X Y WIDTH HEIGHT` keeps what is inside the rectangle with the corner (X, Y), bit for bit: no point is
    outside, and paths stay unbroken at their corners, closed ones also at their start. All arguments understand units.
    """
    if width < 0 or height < 0:
        raise click.BadParameter(f"WIDTH and HEIGHT must not be negative, but they are {width:g} and {height:g}")
    return cropped(lines, (x, y, x + width, y + height))


clearcut.help_group = "Plugins"  # type: ignore[attr-defined]

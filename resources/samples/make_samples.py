#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Makes the sample drawings and their index: make_samples.py [--check]

With --check nothing is written: the script names the files that would change and exits with 1.
It needs Python 3.9 and its standard library, and uses neither unseeded random numbers nor the clock.
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True

from drawings.hilbert import hilbert
from drawings.landscape import landscape
from drawings.paper import nine_regions, random_lines, rejected_lines
from drawings.rosette import rosette
from drawings.street_map import street_map

HERE = Path(__file__).parent

# In the order in which the program offers them.
SAMPLES = {
    "rosette": rosette,
    "landscape": landscape,
    "street-map": street_map,
    "hilbert": hilbert,
    "random-lines": random_lines,
    "nine-regions": nine_regions,
    "rejected-lines": rejected_lines,
}


def files():
    """Name and text of every file that is generated."""
    index = "key\ttitle\tfile\n"
    for key, draw in SAMPLES.items():
        art = draw()
        index += f"{key}\t{art.title}\t{key}.svg\n"
        yield f"{key}.svg", art.svg()
    yield "index.txt", index


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__.splitlines()[0])
    stale = []
    for name, text in files():
        path = HERE / name
        if arguments:
            if not path.exists() or path.read_bytes() != text.encode():
                stale.append(name)
        else:
            path.write_bytes(text.encode())
    if stale:
        sys.exit("Not as make_samples.py makes them: " + ", ".join(stale))


main(sys.argv[1:])

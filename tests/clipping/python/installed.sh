#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installed.sh PYTHON SOURCE WORK [BUILD]: installs clipping/python with pip into a new environment below WORK, without a
# network, and clips there. With BUILD it takes the extension that is built there; otherwise pip compiles the library, for
# minutes.
set -euo pipefail
python=$1 source=$2 work=$3
[ $# -lt 4 ] || export CLEARCUT_BUILD=$4
rm -rf "$work"
mkdir -p "$work"
missing=$("$python" -c 'import importlib.util
print(*(name for name in ("ensurepip", "setuptools", "wheel") if not importlib.util.find_spec(name)))')
if [ -n "$missing" ]; then
    echo "Skipped: Python lacks $missing (Debian: python3-venv, python3-setuptools, python3-wheel)"
    exit 0
fi
"$python" -m venv --system-site-packages "$work/venv" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cp -r "$source/clipping" "$work/clipping" # pip writes into the folder
cd "$work/clipping/python"
"$work/venv/bin/pip" install --no-build-isolation --no-index . >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cd /
"$work/venv/bin/python" - "$work/venv" <<'EOF'
import sys
import numpy as np, clearcut
assert clearcut.__file__.startswith(sys.argv[1]), clearcut.__file__
a = np.random.default_rng(1).uniform(-200, 200, (300_000, 4))
found = clearcut.clip(a, (-100, -75, 100, 75))
assert len(found.source) > 100_000 and found.segments.max() <= 100
print("installed", clearcut.__version__, "in", clearcut.__file__)
EOF

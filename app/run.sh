#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds Clearcut and opens the editor: app/run.sh [FILE]. Installs what is missing.
# Without a display it cuts a drawing with every algorithm, and shows what that took.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(dirname "$here")
file=$(realpath -- "${1:-$root/resources/samples/rosette.svg}")

bash "$here/install_packages.sh" g++ cmake ninja-build qt6-base-dev "?libqt6opengl6-dev" libqt6svg6-dev libgif-dev libexpat1-dev zlib1g-dev hershey-fonts-data libglm-dev libboost-dev
cd "$root"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
[ -x build/release/clearcut ] || echo "Building (the first time takes a few minutes)"
if ! { cmake --preset release && cmake --build --preset release --target clearcut; } >"$log" 2>&1; then
    cat "$log" >&2
    exit 1
fi
clearcut=build/release/clearcut

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    exec "$clearcut" "$file"
fi

out=build/without-display
mkdir -p "$out"
name=$(basename "${file%.*}")
echo "No display: cutting $file at its clip windows, or else at its page."
for algorithm in $("$clearcut" algorithms --format csv | tail -n +2 | cut -d, -f1); do
    "$clearcut" clip "$file" -a "$algorithm" -o "$out/$name-$algorithm.svg" --quiet
done
"$clearcut" clip "$file" -o "$out/$name-cut.png" --dpi 150 --quiet
echo "The cut drawings (SVG, one an algorithm, and a PNG) are in $root/$out:"
ls -1 "$out"
echo
"$clearcut" bench --lines 200000 --runs 5

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds a preset and runs its tests, with or without a display: tests/run.sh [PRESET [CTEST ARGUMENT...]]
# The preset is `release`; what is missing is installed.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
preset=${1:-release}
shift || true

# The program's own packages (boost: also the oracle's exact numbers); xvfb, xauth: tests with OpenGL;
# pkgconf: a program is built by it on the installed library; dpkg-dev: our Debian packages;
# libtbb-dev: the library with threads; python3-*, pybind11-dev: the Python module and its tests;
# parallel: the example with GNU parallel;
# fonts-dejavu-core: the font of windows in tests (fonts.conf);
# python3-pyatspi, at-spi2-core, dbus, xdotool: a screen reader's ears, and keys;
# librsvg2-bin, poppler-utils, texlive-latex-recommended, python3-ezdxf: independent readers of the files we write.
case $preset in
tidy) more=(clang-tidy) ;;
fuzz) more=(clang "?libclang-rt-14-dev") ;; # the latter: libFuzzer on Debian 12
deep | coverage) more=(qt6-l10n-tools) ;; # the test of texts
*) more=() ;;
esac
bash "$root/app/install_packages.sh" "${more[@]}" g++ cmake ninja-build qt6-base-dev "?libqt6opengl6-dev" libqt6svg6-dev libgif-dev libexpat1-dev zlib1g-dev hershey-fonts-data libglm-dev \
    libboost-dev libtbb-dev pkgconf dpkg-dev python3-dev pybind11-dev python3-numpy python3-setuptools python3-wheel python3-venv python3-pip python3-shapely python3-dask python3-distributed python3-ezdxf parallel xvfb xauth python3-pyatspi at-spi2-core dbus xdotool fonts-dejavu-core librsvg2-bin poppler-utils texlive-latex-recommended
cd "$root"
export QT_LOGGING_RULES='*.debug=false'
cmake --preset "$preset"
cmake --build --preset "$preset"
runtime=$(mktemp -d)
trap 'rm -rf "$runtime"' EXIT
chmod 700 "$runtime"
XDG_RUNTIME_DIR=$runtime XDG_CONFIG_HOME=$runtime/config XDG_STATE_HOME=$runtime/state ctest --preset "$preset" -j "$(nproc)" "$@"
if [[ $preset == deep ]]; then # once without unity builds and precompiled headers, which hide a missing #include
    cmake --preset debug
    time cmake --build --preset debug
fi

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the release preset and runs every test. tests/run.sh [PRESET] [CTEST ARGUMENTS]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}; shift || true
cmake --preset "$preset" && cmake --build --preset "$preset" && ctest --preset "$preset" -j "$(nproc)" "$@"

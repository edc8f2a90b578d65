#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What of clipping/ the library's tests reach: tests/coverage.sh [GCOVR ARGUMENT...]
# Fails unless it is every line and 95 % of the branches. The lines not reached are listed, and
# build/coverage/report/index.html shows them. Not counted are:
#  - kernels for instructions that this processor lacks (named below), and
#  - failed asserts, and the branches that the compiler adds for exceptions, which nothing in
#    clipping/ throws (the preset compiles it with -DNDEBUG -fno-exceptions), or on lines without
#    code (--exclude-throw-branches, --exclude-unreachable-branches).
set -euo pipefail
cd "$(dirname "$0")/.."
bash app/install_packages.sh g++ cmake ninja-build qt6-base-dev "?libqt6opengl6-dev" libqt6svg6-dev libgif-dev libexpat1-dev zlib1g-dev hershey-fonts-data libglm-dev \
    libboost-dev xvfb gcovr
build=build/coverage

processor=$(grep -m 1 ^flags /proc/cpuinfo || true)
left_out=()
leave_out_without() { # FILE INSTRUCTION...
    for instruction in "${@:2}"; do
        if [[ " $processor " != *" $instruction "* ]]; then
            echo "Left out: clipping/batch/$1, as this processor has no $instruction"
            left_out+=(--exclude "clipping/batch/$1")
            return
        fi
    done
}
leave_out_without avx2.cpp avx2 fma
leave_out_without avx512.cpp avx512f avx512dq avx512vl

cmake --preset coverage
cmake --build --preset coverage
find $build -name '*.gcda' -delete
QTEST_FUNCTION_TIMEOUT=3000000 ctest --preset coverage -j "$(nproc)"
mkdir -p $build/report
gcovr --root . --object-directory $build --filter clipping/ "${left_out[@]}" \
    --exclude-throw-branches --exclude-unreachable-branches --sort-uncovered \
    --txt --html-details $build/report/index.html --json $build/report/lines.json \
    --print-summary --fail-under-line 100 --fail-under-branch 95 "$@" $build

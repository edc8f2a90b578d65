#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Kills a process that draws so many times at random moments (1,000 without an argument), and
# recovers its drawing each time.
set -e
build=${BUILD:-build/release}
cmake --build "$build" --target app.recovery.kill_test
CLEARCUT_KILLS=${1:-1000} QTEST_FUNCTION_TIMEOUT=100000000 "$build/tests/app.recovery.kill_test"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Have the tests of clipping/ teeth? Makes small faults in the algorithms, one at a time, and runs the
# tests against each: tests/clipping/mutants.sh [KEY...]
# Prints who killed what; ends with 1 if a mutant lives. The faults are in mutants.txt beside this.
# They take some minutes, which is why tests/run.sh leaves them out: run this by hand after a change
# to an algorithm or to its tests. Needs what tests/run.sh installs.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/release
tests=(published contract uses) # the quickest first
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --preset release -S "$root" >"$work/log" || { cat "$work/log"; exit 1; }
for test in "${tests[@]}"; do
    cmake --build "$build" --target "clipping.${test}_test" >"$work/log" || { cat "$work/log"; exit 1; }
done
# A test that fails by itself, or takes too long here, would seem to kill everything.
for test in "${tests[@]}"; do
    timeout 120 "$build/tests/clipping.${test}_test" >"$work/log" 2>&1 || {
        echo "clipping.${test}_test fails without a mutant, or takes more than two minutes."
        exit 1
    }
done

# Links a test with the mutant before the library, which then keeps its own object to itself.
link() { # TEST
    local line
    line=$(ninja -C "$build" -t commands "clipping.${1}_test" | tail -n 1)
    line=${line/" -o tests/clipping.${1}_test "/" $work/mutant.o -o $work/$1 "}
    (cd "$build" && eval "$line")
}

# The first test that fails, or nothing.
killer() {
    local test found
    for test in "${tests[@]}"; do
        link "$test"
        found=$(timeout 120 "$work/$test" 2>&1 | grep -m 1 -o 'FAIL! *: [^(]*([^)]*)' || true)
        if [[ $found ]]; then
            echo "${found#*: }"
            return
        elif ! timeout 120 "$work/$test" >/dev/null 2>&1; then
            echo "$test: crashed, or did not end"
            return
        fi
    done
}

alive=0 total=0
while IFS= read -r entry; do
    [[ $entry && $entry != \#* ]] || continue
    key=${entry%%: *} change=${entry#*: }
    [[ $# == 0 || " $* " == *" $key "* ]] || continue
    from=${change%% => *} to=${change#* => }
    source=$root/clipping/algorithms/${key//-/_}.cpp
    text=$(<"$source")
    [[ $text == *"$from"* ]] || { echo "not in $source: $from"; exit 1; }
    printf '%s\n' "${text/"$from"/"$to"}" >"$work/mutant.cpp"
    total=$((total + 1))
    if ! c++ -std=c++20 -O2 -w -ffp-contract=off -I "$root" -c "$work/mutant.cpp" -o "$work/mutant.o"; then
        echo "does not compile: $entry"
        exit 1
    fi
    verdict=$(killer)
    [[ $verdict ]] || alive=$((alive + 1))
    printf '%-32s %-60s %s\n' "$key" "$from => $to" "${verdict:-LIVES}"
done <"$here/mutants.txt"
echo "$((total - alive)) of $total mutants killed"
((alive == 0))

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Have the tests of clipping/ teeth? Makes small faults in the algorithms, one at a time, and runs the
# tests against each: tests/clipping/mutants.sh [KEY...]
# Prints who killed what; ends with 1 if a mutant lives. The faults are in mutants.txt beside this.
# Each takes half a minute, which is why tests/run.sh leaves them out: run this by hand after a change
# to an algorithm or to its tests. Needs what tests/run.sh installs. `mutants.sh --check` only looks
# whether each fault still has its place in the sources; a test calls it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/release
# The file of a key: an algorithm's, or with its folder and, if a header, its ending.
setFile() { # KEY
    file=${1//-/_}
    [[ $file != lines_and_rays/* ]] || file=algorithms/$file
    [[ $file == */* || $file == *.h || $file == polyline_runs || $file == turned_window ]] || file=algorithms/$file
    [[ $file == *.h ]] || file+=.cpp
    file=clipping/$file
}

# Reads an entry "KEY[@FORM]: FROM => TO" into key, file, from, to, and the text before and after the
# form's code.
declare -A texts
place() { # ENTRY
    local change=${1#*: } part text
    key=${1%%: *} part=${key#*@} key=${key%@*}
    from=${change%% => *} to=${change#* => } before=
    setFile "$key"
    [[ ${texts[$file]-} ]] || texts[$file]=$(<"$root/$file")
    text=${texts[$file]}
    [[ $part == "$key" ]] || before=${text%%"$part"Code*}
    after=${text#"$before"}
    [[ $after == *"$from"* ]] || { echo "not in $file: $from"; return 1; }
}
if [[ ${1-} == --check ]]; then
    lost=0
    while IFS= read -r entry; do place "$entry" || lost=1; done < <(grep -v '^\(#\|$\)' "$here/mutants.txt")
    exit "$lost"
fi

# What tests a file: the quickest first.
testsOf() { # KEY
    case $1 in
    batch/*) echo batch.kernels polygon.exact ;;
    box/*) echo box.box ;;
    region/convex) echo region.convex region.region ;;
    region/beside.h | region/edge-tree*) echo region.edge_tree region.grid ;;
    region/box-part) echo region.box_part ;;
    winding-number | region/winding-number) echo algorithms.winding_number ;;
    polygon/exact | polygon/winding-number | polygon/exact-ends* | polygon/edge-table | exact/meeting* | exact/quotient) echo polygon.exact ;;
    polygon/line-or-ray) echo polygon.line_or_ray ;;
    turned-window) echo turned_window ;;
    polygon/* | exact/turn*) echo polygon.polygon fingerprints ;;
    polyline-clipper.h | polyline_runs) echo polyline ;;
    exact) echo algorithms.exact contract uses ;;
    algorithms/sobkow-pospisil-yang.h) echo published contract uses ;;
    algorithms/skala.h) echo contract uses lines_and_rays ;;
    part.h | algorithms/*.h) echo box.box contract uses lines_and_rays ;;
    lines-and-rays/*) echo lines_and_rays ;;
    midpoint-subdivision) echo algorithms.midpoint_subdivision published contract box.box uses ;;
    cohen-sutherland | liang-barsky | cyrus-beck) echo published contract box.box uses ;;
    *) echo published contract uses lines_and_rays ;;
    esac
}
isWanted() { # KEY: on the command line, or nothing is there
    [[ -z $wanted || " $wanted " == *" $1 "* ]]
}
wanted=$*
mapfile -t tests < <(sed -n 's/^\([^#@: ]*\)[^#: ]*: .*/\1/p' "$here/mutants.txt" | sort -u | while read -r key; do
    if isWanted "$key"; then testsOf "$key" | tr ' ' '\n'; fi
done | sort -u)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --preset release -S "$root" >"$work/log" || { cat "$work/log"; exit 1; }
cmake --build "$build" --target clipping.tests >"$work/log" || { cat "$work/log"; exit 1; }
# A test that fails by itself would seem to kill everything; one that takes three times as long with
# a mutant as without is taken for one that never ends.
declare -A limit
for test in "${tests[@]}"; do
    begun=$SECONDS
    timeout 900 "$build/tests/clipping.tests" "clipping.${test}_test" >"$work/log" 2>&1 || {
        echo "clipping.${test}_test fails without a mutant, or takes more than 15 minutes."
        exit 1
    }
    limit[$test]=$((3 * (SECONDS - begun) + 30))
done

# The sources of the library that include a header, by way of others, too.
includersOf() { # FILE
    local file
    grep -rl --exclude-dir=python --include="*.cpp" "\"$1\"" "$root/clipping" || true
    for file in $(grep -rl --exclude-dir=python --include="*.h" "\"$1\"" "$root/clipping"); do
        includersOf "clipping/${file#"$root/clipping/"}"
    done
}

# Compiles a mutant: itself, or what includes it, with it in the place of the header.
compile() { # FILE
    local source sources=("$work/tree/$1")
    [[ $1 != *.h ]] || mapfile -t sources < <(includersOf "$1" | sort -u)
    rm -f "$work"/mutant*.o
    for source in "${sources[@]}"; do
        c++ -std=c++20 -O2 -w -ffp-contract=off -I "$work/tree" -I "$root" -c "$source" \
            -o "$work/mutant${source//\//_}.o" || return 1
    done
}

# Links the tests with the mutant before the library, which then keeps its own objects to itself.
link() {
    local line
    line=$(ninja -C "$build" -t commands clipping.tests | tail -n 1)
    line=${line/" -o tests/clipping.tests "/" $work/mutant*.o -o $work/tests "}
    (cd "$build" && eval "$line")
}

# The first test that fails, or nothing.
killer() { # KEY
    local test found
    link || { echo "does not link: $1" >&2; exit 1; }
    for test in $(testsOf "$1"); do
        # grep stops at the first failure, and the test dies of the closed pipe: no report of that as a crash.
        found=$(timeout "${limit[$test]}" "$work/tests" "clipping.${test}_test" -nocrashhandler 2>&1 | grep -m 1 -o 'FAIL! *: [^(]*([^)]*)' || true)
        if [[ $found ]]; then
            echo "${found#*: }"
            return
        elif ! timeout "${limit[$test]}" "$work/tests" "clipping.${test}_test" -nocrashhandler >/dev/null 2>&1; then
            echo "$test: crashed, or did not end"
            return
        fi
    done
}

alive=0 total=0
while IFS= read -r entry; do
    [[ $entry && $entry != \#* ]] || continue
    isWanted "${entry%%[@:]*}" || continue
    place "$entry" || exit 1
    rm -rf "$work/tree"
    mkdir -p "$work/tree/$(dirname "$file")"
    printf '%s\n' "$before${after/"$from"/"$to"}" >"$work/tree/$file"
    total=$((total + 1))
    if ! compile "$file"; then
        echo "does not compile: $entry"
        exit 1
    fi
    verdict=$(killer "$key")
    [[ $verdict ]] || alive=$((alive + 1))
    printf '%-32s %-60s %s\n' "$key" "$from => $to" "${verdict:-LIVES}"
done <"$here/mutants.txt"
echo "$((total - alive)) of $total mutants killed"
((alive == 0))

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whether two builds show and write the same: same_pictures.sh BEFORE AFTER [FOLDER]
# BEFORE and AFTER hold the programs `clearcut` and `benchmarks.pictures`, or are build folders. What
# differs is named, and kept in FOLDER.
set -uo pipefail
if [ $# -lt 2 ]; then
  sed -n 's/^# //p' "$0" >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
kept=${3:-$(mktemp -d)}
export LANG=C.UTF-8 QT_SCALE_FACTOR=1 QT_LOGGING_RULES='*.debug=false'
drawings=("$root"/resources/samples/*.svg "$root"/tests/app/formats/data/*.svg
  "$root"/tests/app/formats/data/earlier/*.svg "$root"/tests/ui/canvas/styles.svg)

program() { # FOLDER NAME
  [ -x "$1/$2" ] && echo "$1/$2" || echo "$1/tests/benchmarks/$2"
}

# Writes everything that a build makes of a drawing, with what it says and its exit codes.
write_all() { # BUILD DRAWING FOLDER
  local clearcut keep type
  clearcut=$(program "$1" clearcut)
  say() { "$clearcut" "$@" > "$name" 2> "$name.errors"; echo $? >> "$name.errors"; }
  for type in svg csv pdf png; do
    for keep in inside outside; do
      name=$3/clip-$keep.$type say clip "$2" --keep $keep --to $type -o -
    done
    name=$3/convert.$type say convert "$2" --to $type -o -
  done
  name=$3/info.txt say info "$2"
  name=$3/compare.txt say compare "$2" -a kwc:published
  "$(program "$1" benchmarks.pictures)" "$2" "$3" 2>&1 || echo "failed: $1" > "$3/pictures.txt"
}

differing=0
for drawing in "${drawings[@]}"; do
  [ -e "$drawing" ] || continue
  made=$kept/$(basename "$drawing" .svg)
  mkdir -p "$made/before" "$made/after"
  write_all "$1" "$drawing" "$made/before" &
  write_all "$2" "$drawing" "$made/after"
  wait
  if diff -rq "$made/before" "$made/after"; then
    echo "$(basename "$drawing"): $(ls "$made/after" | grep -vc errors) files, all the same"
    rm -r "$made"
  else
    differing=$((differing + 1))
  fi
done
[ $differing -eq 0 ] && rmdir "$kept" 2> /dev/null
exit $((differing > 0))

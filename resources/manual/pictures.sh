#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pictures.sh CLEARCUT: paints the manual's pictures anew with this program. pictures.txt holds a name and the program's
# arguments in each line.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/../.."
export QT_QPA_PLATFORM=offscreen XDG_CONFIG_HOME=$(mktemp -d) XDG_STATE_HOME=$(mktemp -d)
trap 'rm -rf "$XDG_CONFIG_HOME" "$XDG_STATE_HOME"' EXIT
while read -r name arguments; do
  # shellcheck disable=SC2086 # arguments are words
  "$program" --screenshot "resources/manual/pictures/$name.png" $arguments
done < resources/manual/pictures.txt

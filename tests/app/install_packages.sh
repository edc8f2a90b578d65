#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/app/install_packages.sh SCRIPT: what app/install_packages.sh installs, where g++ is installed, and a package
# that provides libqt6svg6-dev. All programs that it calls are replaced by such that write down how they are called.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/dpkg-query" <<'END'
#!/bin/sh
for last; do :; done
case $last in
g++) printf installed ;;
-f=*) printf 'installed: libqt6svg6-dev (= 6.4.2-2), other-dev\nnot-installed: removed-dev\n' ;;
*) exit 1 ;;
esac
END
printf '#!/bin/sh\necho "$@" >>%s/calls\n' "$work" >"$work/apt-get"
printf '#!/bin/sh\n[ "$1" != -n ] || shift\nexec "$@"\n' >"$work/sudo"
printf '#!/bin/sh\n' >"$work/apt-cache"
chmod +x "$work"/*

# expect CALLS PACKAGE...: the calls of apt-get that these packages need.
expect() {
    : >"$work/calls"
    PATH=$work:$PATH bash "$script" "${@:2}" >/dev/null
    [ "$(cat "$work/calls")" = "$1" ] || { echo "For ${*:2}: $(cat "$work/calls")" >&2; exit 1; }
}
script=$1
expect "" g++ libqt6svg6-dev other-dev "?libqt6svg6-dev"
expect "-qq update
-qq install -y --no-install-recommends removed-dev" g++ libqt6svg6-dev removed-dev

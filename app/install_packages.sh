#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_packages.sh PACKAGE...: installs those Debian or Ubuntu packages that are missing, and says
# so first. ?PACKAGE is one that only some releases have (elsewhere it is a part of another).
# Without root and sudo it prints the line to run, and ends with 1.
set -euo pipefail

# One package can be another's new name: Debian's qt6-svg-dev provides libqt6svg6-dev.
provided=$(dpkg-query -W -f='${db:Status-Status}: ${Provides}\n' 2>/dev/null | sed -n 's/^installed: //p' |
    tr ',' '\n' | sed 's/^ *//; s/ .*//' || true)
installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ] ||
        grep -qxF -- "$1" <<<"$provided"
}
known() { [ -n "$(apt-cache show --no-all-versions "$1" 2>/dev/null | head -n 1)" ]; }

missing=() sometimes=()
for package in "$@"; do
    case $package in
    \?*) installed "${package#?}" || sometimes+=("${package#?}") ;;
    *) installed "$package" || missing+=("$package") ;;
    esac
done
for package in "${sometimes[@]}"; do
    ! known "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
    as_root=()
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; then
    as_root=(sudo)
else
    echo "Packages are missing, and neither root nor sudo is at hand. Run this as root:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt_get() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq "$@" >"$log" 2>&1 && return
    cat "$log" >&2
    echo "apt-get $1 failed; its own words stand above. Mend that and run this again." >&2
    exit 1
}
apt_get update
for package in "${sometimes[@]}"; do # a bare machine knows its packages only now
    if known "$package" && [[ " ${missing[*]} " != *" $package "* ]]; then missing+=("$package"); fi
done
echo "Installing: ${missing[*]}"
apt_get install -y --no-install-recommends "${missing[@]}"

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# paste_in_inkscape.sh COPY PAGE: pastes the drawing COPY in place into PAGE, with Inkscape's own window, and saves PAGE.
# Needs a display and a session bus of its own (xvfb-run dbus-run-session).
export HOME=$PWD XDG_CONFIG_HOME=$PWD/config
xclip -selection clipboard -t image/svg+xml -i "$1"
before=$(stat -c %Y.%s "$2")
inkscape "$2" > /dev/null 2>&1 &
inkscape=$!

# The window's actions are there as soon as it is.
act() {
  gdbus call --session --dest org.inkscape.Inkscape --object-path "/org/inkscape/Inkscape$1" \
    --method org.gtk.Actions.Activate "$2" '[]' '{}' > /dev/null 2>&1
}
until_done() {
  for _ in $(seq 400); do
    "$@" && return
    sleep 0.1
  done
  return 1
}
is_saved() {
  act /window/1 document-save
  [ "$(stat -c %Y.%s "$2")" != "$before" ] && grep -q '</svg>' "$2"
}

until_done act /window/1 paste-in-place && until_done is_saved "$@"
done=$?
act "" quit-immediate || kill $inkscape
exit $done

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a screen reader gets of the editor: screen_reader.py XVFB_RUN DBUS_RUN_SESSION CLEARCUT DRAWING

Starts the program, with a clip window in its drawing, in a display and a session of its own, and uses it by the
keyboard alone (xdotool), while it listens on the accessibility bus as a screen reader does (pyatspi). Prints what is
missing, and ends with 1 if anything is.
"""
import os
import signal
import subprocess
import sys
import tempfile
import time

import pyatspi
from gi.repository import GLib

PATIENCE = 60  # seconds; only a failure waits so long

# What one uses: each has a name. Those that are a part of another one have it there.
CONTROLS = {"push button", "toggle button", "check box", "radio button", "spin button", "combo box", "text", "list",
            "list item", "tree item", "table", "table cell", "page tab", "page tab list", "menu item", "slider",
            "canvas", "tool bar", "link"}
ROWS = {"list item", "tree item", "table cell"}
INSIDE = {"spin button", "combo box"}
# What takes keys and is nothing of these says nothing of what it is for.
MEANINGLESS = {"filler", "unknown", "invalid", "redundant object"}


class Missing(Exception):
    pass


class Reader:
    """Listens, and knows the program's tree."""

    def __init__(self):
        self.heard, self.focused, self.missing = [], [], []
        self.program = self.application = self.drawing = None

    def start(self, program, drawing):
        for event in ("object:state-changed:focused", "object:property-change:accessible-name",
                      "object:property-change:accessible-description", "object:announcement"):
            pyatspi.Registry.registerEventListener(self.hear, event)
        self.program = subprocess.Popen([program, "--renderer", "raster", drawing])
        self.wait(lambda: self.find_application() is not None, "the program on the bus")
        self.application = self.find_application()
        self.wait(lambda: self.first("Drawing", "canvas"), "the drawing, a canvas")
        self.drawing = self.first("Drawing", "canvas")
        self.wait(lambda: has(self.application[0], "showing"), "the window")
        # No window manager is here to do it.
        subprocess.run(["xdotool", "search", "--onlyvisible", "--name", " – Clearcut$", "windowfocus"], check=True)
        self.wait(lambda: has(self.application[0], "active"), "the active window")
        self.drawing.queryComponent().grabFocus()
        self.wait(lambda: has(self.drawing, "focused"), "the focus")

    def find_application(self):
        if self.program.poll() is not None:
            raise Missing("the program, which has ended")
        desktop = pyatspi.Registry.getDesktop(0)
        return next((one for one in desktop if one and one.name == "Clearcut" and one.childCount > 0), None)

    def hear(self, event):
        try:
            if event.type == "object:state-changed:focused":
                if event.detail1:
                    self.focused.append(event.source)
            elif event.type == "object:announcement":
                self.heard.append(event.any_data)
            elif has(event.source, "focused"):  # of others a screen reader says nothing
                self.heard.append(event.source.name if event.type.endswith("name") else event.source.description)
        except GLib.Error:
            pass  # it is gone

    def wait(self, condition, what):
        """Handles events until the condition holds."""
        context, end = GLib.MainContext.default(), time.monotonic() + PATIENCE
        while True:
            while context.iteration(False):
                pass
            try:
                if condition():
                    return
            except (GLib.Error, IndexError):
                pass  # what was asked is gone, or not yet there
            if time.monotonic() > end:
                raise Missing(what + (f"; last heard: {self.heard[-3:]}" if self.heard else ""))
            time.sleep(0.01)

    def key(self, *names):
        self.heard.clear()
        self.focused.clear()
        subprocess.run(["xdotool", "key", *names], check=True)

    def hears(self, key, words):
        """After this key the listener is told of something with these words."""
        self.key(key)
        self.wait(lambda: any(words in text for text in self.heard), f"“{words}” after {key}")

    def shown(self, one=None):
        """All that is on the screen."""
        for child in parts(self.application if one is None else one):
            if has(child, "showing"):
                yield child
                yield from self.shown(child)

    def first(self, name, role):
        return next((one for one in self.shown() if one.name.startswith(name) and one.getRoleName() == role), None)

    def entry(self, *names):
        """The entry of a menu, shown or not."""
        one = next(part for part in self.shown() if part.getRoleName() == "menu bar")
        for name in names:
            inside = one if one.getRoleName() == "menu bar" else one[0]
            one = next((part for part in parts(inside) if part.name.replace("&", "") == name), None)
            if one is None:
                return None
        return one

    def check(self, condition, text):
        if not condition and text not in self.missing:
            self.missing.append(text)


def parts(one):
    return [part for part in one if part is not None]


def has(one, state):
    return one is not None and state in map(pyatspi.stateToString, one.getState().getStates())


def said(one):
    parent = one.parent
    return f"{one.getRoleName()} “{one.name}” in {parent.getRoleName()} “{parent.name}”"


def faults_of(one, role):
    """What a screen reader cannot say of it."""
    # Qt keeps the tab bars of places that are gone.
    is_gone = role == "page tab list" and all(part.getRoleName() != "page tab" for part in parts(one))
    if role in CONTROLS and not is_gone and not one.name.strip():
        yield f"no name: {said(one)}"
    if role == "combo box":  # its name is what is chosen
        labels = [relation for relation in one.getRelationSet()
                  if relation.getRelationType() == pyatspi.RELATION_LABELLED_BY]
        if not labels and not one.description:
            yield f"no label: {said(one)}"
    if has(one, "focusable") and role in MEANINGLESS:
        yield f"takes keys, but no role: {said(one)}"


def check_names(reader, where):
    faults = []

    def look():  # again, if something goes meanwhile
        faults.clear()
        controls = 0
        for one in reader.shown():
            role = one.getRoleName()
            if one.parent is not None and one.parent.getRoleName() in INSIDE:
                continue
            controls += role in CONTROLS
            faults.extend(faults_of(one, role))
        return controls > 20
    reader.wait(look, f"{where}: more than 20 controls")
    for fault in faults:
        reader.check(False, f"{where}: {fault}")


def stops_by(reader, key):
    """What gets the focus by this key, again and again."""
    last = reader.drawing
    for _ in range(150):
        reader.key(key)
        stops = []
        def arrives():
            stops[:] = [one for one in reader.focused if one.getRoleName() not in ROWS]  # a row comes after its list
            return stops
        reader.wait(arrives, f"the focus, by {key} from {said(last)}")
        last = stops[-1]
        yield last
    raise Missing(f"a way back to the drawing by {key}")


def check_stops(reader):
    """Tab goes through the window and returns; Shift+Tab goes the same way back."""
    def way(key):
        stops = []
        for stop in stops_by(reader, key):
            reader.check(stop.name, f"{key}: no name: {said(stop)}")
            reader.check(stop.getRoleName() not in MEANINGLESS, f"{key}: no role: {said(stop)}")
            stops.append(stop)
            if stop == reader.drawing:
                return stops

    forth, back = way("Tab"), way("shift+Tab")
    reader.check(len(forth) > 20, f"only {len(forth)} stops")
    reader.check(abs(len(forth) - len(back)) <= 2, f"{len(forth)} stops forth, {len(back)} back")


def check_rows(reader, name, enough, words):
    """The rows of a list are read, with what is seen of them."""
    rows = parts(reader.first(name, "list"))
    reader.check(len(rows) >= enough, f"{name}: {len(rows)} rows")
    for row in rows:
        reader.check(row.name and any(word in row.name for word in words), f"{name}: {said(row)}")
    reader.check(any(has(row, "selected") for row in rows), f"{name}: no row is selected")


def check_layers(reader):
    layers = reader.first("Layers", "list")
    next(stop for stop in stops_by(reader, "Tab") if stop == layers)
    reader.wait(lambda: reader.focused[-1].getRoleName() in ROWS, "the current row of Layers")
    row, before = reader.focused[-1], layers.childCount
    reader.check("closed" in row.name, f"not closed: {said(row)}")
    reader.key("Right")
    reader.wait(lambda: "open" in row.name and layers.childCount > before, "an open layer")
    reader.key("Down")
    reader.wait(lambda: reader.focused and "selected" in reader.focused[-1].name, "a selected row")
    reader.key("Left", "Left")
    reader.wait(lambda: layers.childCount == before, "a closed layer")
    reader.key("Escape")
    reader.wait(lambda: has(reader.drawing, "focused"), "Esc to the drawing")


def check_selection(reader):
    reader.hears("ctrl+a", "objects, selected")
    reader.hears("Escape", "nothing selected")
    reader.hears("w", ", clip window")
    reader.wait(lambda: any(one.getRoleName() == "tool bar" and one.name.endswith(", clip window")
                            for one in reader.shown()), "the capsule, a tool bar")
    reader.key("Escape", "v")


def in_own_session(xvfb_run, dbus_run_session, *arguments):
    """Runs this script there. What D-Bus has started may outlive its session, and would keep a pipe open."""
    with tempfile.TemporaryFile() as output:
        session = subprocess.Popen(
            [xvfb_run, "-a", "-s", "-screen 0 1440x900x24 -nolisten tcp", dbus_run_session, "--",
             sys.executable, __file__, *arguments], stdout=output, stderr=output, start_new_session=True)
        result = session.wait()
        try:
            os.killpg(session.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # nothing is left
        output.seek(0)
        if result:
            print(output.read().decode(errors="replace"))
    return result


def listen(program, drawing):
    with tempfile.TemporaryDirectory() as folder:
        for variable in ("XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"):
            os.environ[variable] = folder
        os.environ["QT_LINUX_ACCESSIBILITY_ALWAYS_ON"] = "1"
        reader = Reader()
        try:
            reader.start(program, drawing)
            for number, name in enumerate(("Draw", "Cut", "Compare", "Learn"), 1):
                reader.key(f"ctrl+alt+{number}")
                reader.wait(lambda: has(reader.entry("View", "Workspace", name), "checked"), f"the workspace {name}")
                check_names(reader, name)
            reader.key("ctrl+alt+2")
            reader.wait(lambda: reader.first("Clip windows", "list"), "the list of clip windows")
            check_rows(reader, "Clip windows", 1, ("adds", "cuts out", "intersects"))
            check_rows(reader, "Layers", 2, ("shown", "hidden"))
            check_layers(reader)
            check_selection(reader)
            check_stops(reader)
        except Missing as missing:
            reader.missing.append(f"Waited in vain for {missing}.")
        finally:
            if reader.program:
                reader.program.kill()
                reader.program.wait()
    print("\n".join(reader.missing))
    return 1 if reader.missing else 0


if __name__ == "__main__":
    sys.exit(listen(*sys.argv[1:]) if len(sys.argv) == 3 else in_own_session(*sys.argv[1:]))

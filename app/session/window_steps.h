// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/session/session.h"

#include <functional>

// Undoable steps on the clip windows. "The window" is the one that tools act on
// (Session::windowNumber).

namespace app {

/// The windows after the window got this shape; without one, a window more.
ClipWindows withShape(const Session& session, const WindowShape& shape);

/// Gives the window this shape; without one, adds a window.
void setWindowShape(Session& session, const WindowShape& shape, const QString& text,
                    Merging merging = Merging::Never);
/// The key of the shape that is drawn next; it outlives the session.
void setNextWindow(Session& session, std::string_view kind);
/// The windows after a window of this shape was drawn, and its number.
struct DrawnWindow {
    ClipWindows windows;
    std::size_t number;
};
DrawnWindow withDrawn(const Session& session, const WindowShape& shape);
/// Draws it, and chooses it. Refused if there is no room for it.
void drawWindow(Session& session, const WindowShape& shape);

/// Chooses the next visible window of the list (`step` 1), or the previous one (-1); after the last
/// the first. False: there is no other one.
bool chooseNeighbour(Session& session, int step);

void moveWindow(Session& session, const Point& by, Merging merging = Merging::Never);

/// Adds windows after the others, in one step, and chooses the last of them. If the drawing has not
/// room for all, nothing changes and `Session::refused` says so.
bool addWindows(Session& session, std::vector<ClipWindow> windows, const QString& text);
bool addWindow(Session& session, ClipWindow window);
void removeWindow(Session& session);
/// Moves a window to another place of the list and chooses it there.
void reorderWindow(Session& session, std::size_t from, std::size_t to);
/// Changes the name, the operation, the visibility or the colour of one window.
void changeWindow(Session& session, std::size_t number, const QString& text,
                  const std::function<void(ClipWindow&)>& change);

/// Sets the operation of a window. The step is called "Cut out Star 2". Refused where there is no
/// window above for it (whyNot()).
void setWindowOperation(Session& session, std::size_t number, WindowOperation operation);

/// One clip window for each selected object that encloses an area. Open paths are closed.
std::vector<ClipWindow> windowsOfSelection(const Session& session);
/// Adds them in one step. `Session::refused` says how many objects were left out, and why.
void addWindowsOfSelection(Session& session);
/// Adds the window's shape as an object of the current layer, in the pen's style, and selects it.
void windowToPath(Session& session);

} // namespace app

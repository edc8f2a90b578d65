// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/session/session.h"

// Clip windows in words.

namespace app {

/// "Rectangle", "Ellipse" …: what a window without a name is called.
QString nameOf(const WindowShape& shape);
/// The window's name, or that of its shape.
QString nameOf(const ClipWindow& window);
/// "Star 2": what a window is called that is added to others: its shape, and a number that is
/// larger than theirs.
QString numberedName(const WindowShape& shape, int number);
int numberForNew(const ClipWindows& others);
/// The name of a window with another shape, which a name that was made so follows.
QString nameAfter(const ClipWindow& before, const WindowShape& shape);
/// The kind of an object and its id, if it has one: `Ellipse “sun”`, "Line".
QString nameOf(const ObjectView& object);
/// The key of the icon of a shape, and of an object.
std::string_view iconOf(const WindowShape& shape);
std::string_view iconOf(const ObjectView& object);

/// The formula of the windows that have an effect: "Old town − Market hall + Star"; "everything −
/// Market hall" if the first one does not add. Empty without a visible window.
QString resultOf(const ClipWindows& windows);
/// "without effect: Star 2 replaces it"; empty for any other window.
QString replacedText(const ClipWindows& windows, std::size_t number);
/// Why a window cannot get an operation: "No clip window is above Star 2."; empty
/// if it can, or has it.
QString whyNot(const ClipWindows& windows, std::size_t number, WindowOperation operation);

// Where the algorithms of an open drawing are compared, in words.

/// The name of the clip window, if it does not alone decide what of the drawing is kept: then the
/// numbers of a comparison are not those of the picture. Empty otherwise.
QString comparedName(const Session& session);

/// The name of what keys act on, for screen readers: "Star 2, clip window" if that is the clip
/// window, else "3 objects, selected", "nothing selected".
QString chosenText(const Session& session, bool forWindow);

/// For captions: that nothing is compared, and why; that the drawing is compared at the page, or
/// inside one of its clip windows. Empty if that is the only one.
QString comparedText(const Session& session);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given_value.h"
#include "app/document/clip_windows.h"
#include "app/formats/format.h"

#include <span>

namespace app {

/// A way to give a clip window on the command line.
struct WindowForm {
    std::string_view key;   ///< before a colon, "circle"; "" for a rectangle and "page"
    std::string_view usage; ///< "circle:CX,CY,R"
    /// The windows that `text`, the value after the colon, stands for: at least one. Throws
    /// WrongUsage or Failure.
    std::vector<ClipWindow> (*windows)(const GivenValue& value, const QString& text,
                                       const Imported& imported);
    bool needsDrawing = false; ///< looks into the drawing, not only at its unit
};

/// Every form, in the order of the help.
std::span<const WindowForm> windowForms();

/// Whether the form of this value needs the whole drawing.
bool needsDrawing(const GivenValue& value);

/// The windows that a value stands for, "circle:50mm,50mm,20mm". Throws WrongUsage or Failure.
std::vector<ClipWindow> windowsOf(const GivenValue& value, const Imported& imported);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/crop_to_window.h"

#include <QCoreApplication>

namespace app {

CropToWindow::CropToWindow(Drawing& drawing, const CutOptions& options)
    : UndoCommand(row, QCoreApplication::translate("Commands", "Crop to window")), drawing_(drawing)
{
    Cut result = cut(drawing.sheet(), options);
    counts_ = result.counts;
    patches_.push_back({0, drawing.sheet().shapes.size(), std::move(result.sheet.shapes)});
}

} // namespace app

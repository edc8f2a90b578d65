// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace ui {

std::span<const ToolInfo> tools()
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Tools", text); };
    const auto none = [] { return std::make_unique<Tool>(); };
    // THE CATALOGUE. To add a tool: write its file, declare its maker above, and add its row here.
    static const std::array all{
        ToolInfo{"select", tr("Select"),
                 tr("Click a line to select it, drag to box-select. Shift adds."),
                 QKeySequence("V"), none},
        ToolInfo{"hand", tr("Hand"), tr("Drag to move the view."), QKeySequence("H"), none},
        ToolInfo{"zoom", tr("Zoom"), tr("Drag to zoom to a rectangle, click to zoom in, Alt: out."),
                 QKeySequence("Z"), none},
        ToolInfo{"line", tr("Line"), tr("Drag to draw a line. Shift: 15° steps."),
                 QKeySequence("L"), none},
        ToolInfo{"polyline", tr("Polyline"),
                 tr("Click the corners. Enter or double-click ends, Backspace takes one back, Esc "
                    "cancels."),
                 QKeySequence("P"), none},
        ToolInfo{"pencil", tr("Pencil"), tr("Drag to draw freehand."), QKeySequence("B"), none},
        ToolInfo{"rectangle", tr("Rectangle"),
                 tr("Drag to draw a rectangle. Shift: square, Alt: from the centre."),
                 QKeySequence("R"), none},
        ToolInfo{"ellipse", tr("Ellipse"),
                 tr("Drag to draw an ellipse. Shift: circle, Alt: from the centre."),
                 QKeySequence("E"), none},
        ToolInfo{"window", tr("Clip window"), tr("Drag to draw a clip window, Shift: square"),
                 QKeySequence("W"), none},
    };
    return all;
}

const ToolInfo* findTool(std::string_view key)
{
    const auto all = tools();
    const auto found = std::ranges::find(all, key, &ToolInfo::key);
    return found == all.end() ? nullptr : &*found;
}

} // namespace ui

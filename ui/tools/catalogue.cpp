// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace ui {

// Each is defined in the file of its name, KEY_tool.cpp.
std::unique_ptr<Tool> makeSelectTool();
std::unique_ptr<Tool> makeNodesTool();
std::unique_ptr<Tool> makeHandTool();
std::unique_ptr<Tool> makeZoomTool();
std::unique_ptr<Tool> makeLineTool();
std::unique_ptr<Tool> makePolylineTool();
std::unique_ptr<Tool> makePenTool();
std::unique_ptr<Tool> makeArcTool();
std::unique_ptr<Tool> makePencilTool();
std::unique_ptr<Tool> makeRectangleTool();
std::unique_ptr<Tool> makeEllipseTool();
std::unique_ptr<Tool> makePolygonTool();
std::unique_ptr<Tool> makeStarTool();
std::unique_ptr<Tool> makeTextTool();
std::unique_ptr<Tool> makeWindowTool();

std::span<const ToolInfo> tools()
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Tools", text); };
    // THE CATALOGUE. To add a tool: write its file, declare its maker above, and add its row here.
    static const std::array all{
        ToolInfo{"select", tr("Select"),
                 tr("Click an object, or drag a box. Shift adds. Double click: show nodes, or enter a "
                    "group."),
                 QKeySequence("V"), makeSelectTool},
        ToolInfo{"nodes", tr("Nodes"),
                 tr("Click a path, then drag its nodes, handles and segments. Double click on it: add a "
                    "node."),
                 QKeySequence("N"), makeNodesTool},
        ToolInfo{"hand", tr("Hand"), tr("Drag to move the view."), QKeySequence("H"), makeHandTool},
        ToolInfo{"zoom", tr("Zoom"),
                 tr("Drag a rectangle to zoom to it. Click to zoom in, Alt+click to zoom out."),
                 QKeySequence("Z"), makeZoomTool},
        ToolInfo{"line", tr("Line"),
                 tr("Click points, or drag. Type a length, Tab, an angle, Enter. Esc: begin another "
                    "line, Shift: 15° steps."),
                 QKeySequence("L"), makeLineTool, ToolInfo::Group::New},
        ToolInfo{"polyline", tr("Polyline"),
                 tr("Click corners, or type a length, Tab, an angle, Enter. Ctrl+Z: corner back, Esc: "
                    "end."),
                 QKeySequence("P"), makePolylineTool},
        ToolInfo{"pen", tr("Pen"),
                 tr("Click: corner, drag: symmetric node, S: smooth, Alt: cusp. Click the start to "
                    "close. Esc: end."),
                 QKeySequence("D"), makePenTool},
        ToolInfo{"arc", tr("Arc"),
                 tr("Click the start, the end and a point on the arc. C, or Alt at the first click: by "
                    "its centre."),
                 QKeySequence("A"), makeArcTool},
        ToolInfo{"pencil", tr("Pencil"), tr("Drag to draw freehand. Then Enter, a tolerance, Enter: how smooth it is."), QKeySequence("B"),
                 makePencilTool},
        ToolInfo{"rectangle", tr("Rectangle"),
                 tr("Drag, or type a width, Tab, a height, Tab, a corner radius, Enter. Shift: square, "
                    "Alt: centre."),
                 QKeySequence("R"), makeRectangleTool},
        ToolInfo{"ellipse", tr("Ellipse"),
                 tr("Drag, or type a width, Tab, a height, Enter. Shift: circle, Alt: from the centre."),
                 QKeySequence("E"), makeEllipseTool},
        ToolInfo{"polygon", tr("Polygon"),
                 tr("Drag from the centre to a corner. Up, Down: corners, Shift: 15° steps, Alt: to a "
                    "side."),
                 QKeySequence("Y"), makePolygonTool},
        ToolInfo{"star", tr("Star"),
                 tr("Drag from the centre to a point. Up, Down: number of points, Shift: 15° steps. "
                    "Tab: numbers."),
                 QKeySequence("S"), makeStarTool},
        ToolInfo{"text", tr("Text"),
                 tr("Click where the text begins, or a text to edit it. Enter: end, Shift+Enter: new "
                    "line."),
                 QKeySequence("T"), makeTextTool},
        ToolInfo{"window", tr("Clip window"), tr("Drag beside the windows to draw one, or a window to move it. Click: choose a window."),
                 QKeySequence("W"), makeWindowTool, ToolInfo::Group::New},
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

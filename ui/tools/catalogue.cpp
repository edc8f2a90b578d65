// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/tools/tool.h"

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
    // THE CATALOGUE. To add a tool: write its file, declare its maker above, and add its row here.
    static const std::array all{
        ToolInfo{
            "select", Text::tr("Select"),
            Text::tr(
                "Click an object, or drag a box. Shift adds. Double click: show nodes, or enter a "
                "group."),
            QKeySequence("V"), makeSelectTool, ToolInfo::Group::Same, ToolInfo::Options::Arranging},
        ToolInfo{"nodes", Text::tr("Nodes"),
                 Text::tr("Click a path, then drag its nodes, handles and segments. Double click "
                          "on it: add a "
                          "node."),
                 QKeySequence("N"), makeNodesTool, ToolInfo::Group::Same, ToolInfo::Options::Nodes},
        ToolInfo{"hand", Text::tr("Hand"), Text::tr("Drag to move the view."), QKeySequence("H"),
                 makeHandTool, ToolInfo::Group::Same, ToolInfo::Options::View},
        ToolInfo{
            "zoom", Text::tr("Zoom"),
            Text::tr("Drag a rectangle to zoom to it. Click to zoom in, Alt+click to zoom out."),
            QKeySequence("Z"), makeZoomTool, ToolInfo::Group::Same, ToolInfo::Options::View},
        ToolInfo{"line", Text::tr("Line"),
                 Text::tr("Click points, or type x,y, Enter, length, Tab, angle, Enter. Shift: "
                          "15°, Esc: next "
                          "line."),
                 QKeySequence("L"), makeLineTool, ToolInfo::Group::New},
        ToolInfo{"polyline", Text::tr("Polyline"),
                 Text::tr("Click corners, or type x,y, Enter, length, Tab, angle, Enter. Ctrl+Z: "
                          "back, Esc: end."),
                 QKeySequence("P"), makePolylineTool},
        ToolInfo{"pen", Text::tr("Pen"),
                 Text::tr("Click: corner, drag: symmetric, S: smooth, Alt: cusp. Click the start: "
                          "close. Esc: "
                          "end."),
                 QKeySequence("D"), makePenTool},
        ToolInfo{
            "arc", Text::tr("Arc"),
            Text::tr("Click the start, the end and a point on the arc. C, or Alt at first: by its "
                     "centre."),
            QKeySequence("A"), makeArcTool},
        ToolInfo{
            "pencil", Text::tr("Pencil"),
            Text::tr("Drag to draw freehand. Then Enter, a tolerance, Enter: how smooth it is."),
            QKeySequence("B"), makePencilTool},
        ToolInfo{"rectangle", Text::tr("Rectangle"),
                 Text::tr("Drag, or type x,y, Enter, width, Tab, height, Tab, corner radius, "
                          "Enter. Shift: square."),
                 QKeySequence("R"), makeRectangleTool},
        ToolInfo{
            "ellipse", Text::tr("Ellipse"),
            Text::tr("Drag, or type x,y, Enter, width, Tab, height, Enter. Shift: circle, Alt: "
                     "centre."),
            QKeySequence("E"), makeEllipseTool},
        ToolInfo{
            "polygon", Text::tr("Polygon"),
            Text::tr(
                "Drag from the centre to a corner. Up, Down: corners, Shift: 15° steps, Alt: to a "
                "side."),
            QKeySequence("Y"), makePolygonTool},
        ToolInfo{
            "star", Text::tr("Star"),
            Text::tr("Drag from the centre to a point. Up, Down: points, Shift: 15° steps, Tab: "
                     "numbers."),
            QKeySequence("S"), makeStarTool},
        ToolInfo{
            "text", Text::tr("Text"),
            Text::tr(
                "Click where the text begins, or a text to edit it. Enter: end, Shift+Enter: new "
                "line."),
            QKeySequence("T"), makeTextTool},
        ToolInfo{"window", Text::tr("Clip window"),
                 Text::tr("Drag beside the windows to draw one, or a window to move it. Click: "
                          "choose a window."),
                 QKeySequence("W"), makeWindowTool, ToolInfo::Group::New,
                 ToolInfo::Options::Window},
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

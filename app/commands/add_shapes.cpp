// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_shapes.h"

namespace app {

AddShapes::AddShapes(Drawing& drawing, std::vector<Shape> shapes, const QString& text)
    : UndoCommand(row, text), drawing_(drawing), count_(shapes.size())
{
    const std::size_t top = drawing.endOfLayer(shapes.front().layer);
    patches_.push_back({top, 0, std::move(shapes)});
}

ObjectRanges AddShapes::shapes() const
{
    const std::size_t first = patches_.front().first;
    return ObjectRanges(ObjectRange{first, first + count_});
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_shapes.h"

namespace app {

AddShapes::AddShapes(Drawing& drawing, std::vector<Shape> shapes, const QString& text)
    : QUndoCommand(text), drawing_(drawing), count_(shapes.size())
{
    const std::size_t top = drawing.endOfLayer(shapes.front().layer);
    patches_.push_back({top, 0, std::move(shapes)});
}

std::set<std::size_t> AddShapes::shapes() const
{
    std::set<std::size_t> all;
    for (std::size_t i = 0; i < count_; ++i)
        all.insert(all.end(), patches_.front().first + i);
    return all;
}

} // namespace app

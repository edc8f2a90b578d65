// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_shapes.h"

#include "app/document/path_points.h"

#include <QCoreApplication>

namespace app {

Shape moved(Shape shape, const Point& by)
{
    for (Subpath& path : shape.paths)
        forEachPoint(path, [&](Point& point) { point += by; });
    return shape;
}

MoveShapes::MoveShapes(Drawing& drawing, const ObjectRanges& shapes, const Point& by,
                       Merging merging)
    : UndoCommand(row, QCoreApplication::translate("Commands", "Move selection"), merging),
      drawing_(drawing), patches_(patchesOf(drawing.sheet(), shapes, [&](Shape& shape) {
          shape = moved(std::move(shape), by);
          return true;
      }))
{
}

bool MoveShapes::mergeWith(const UndoCommand& next)
{
    return samePlaces(patches_, static_cast<const MoveShapes&>(next).patches_);
}

} // namespace app

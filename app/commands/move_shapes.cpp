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

MoveShapes::MoveShapes(Drawing& drawing, ObjectRanges shapes, const Point& by, Merging merging)
    : QUndoCommand(QCoreApplication::translate("Commands", "Move selection")), drawing_(drawing),
      shapes_(std::move(shapes)), merging_(merging),
      patches_(patchesOf(drawing.sheet(), shapes_, [&](Shape& shape) {
          shape = moved(std::move(shape), by);
          return true;
      }))
{
}

// Both are in force: what the first keeps is how the shapes were before either.
bool MoveShapes::mergeWith(const QUndoCommand* next)
{
    const auto& other = *static_cast<const MoveShapes*>(next);
    return other.merging_ == Merging::WithLast && merging_ == Merging::WithLast
           && other.shapes_ == shapes_;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/resize_shapes.h"

#include "app/document/path_points.h"

#include <QCoreApplication>

namespace app {

Point fitted(const Point& point, const clipping::Window& from, const clipping::Window& to)
{
    const Point old = from.max - from.min, size = to.max - to.min;
    const Point scale(old.x > 0 ? size.x / old.x : 1, old.y > 0 ? size.y / old.y : 1);
    return to.min + (point - from.min) * scale;
}

ResizeShapes::ResizeShapes(Drawing& drawing, const ObjectRanges& shapes,
                           const clipping::Window& from, const clipping::Window& to)
    : UndoCommand(row, QCoreApplication::translate("Commands", "Resize selection")),
      drawing_(drawing), patches_(patchesOf(drawing.sheet(), shapes, [&](Shape& shape) {
          for (Subpath& path : shape.paths)
              forEachPoint(path, [&](Point& point) { point = fitted(point, from, to); });
          return true;
      }))
{
}

} // namespace app

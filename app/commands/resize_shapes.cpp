// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/resize_shapes.h"

#include <QCoreApplication>

namespace app {

Point fitted(const Point& point, const clipping::Window& from, const clipping::Window& to)
{
    const Point old = from.max - from.min, size = to.max - to.min;
    const Point scale(old.x > 0 ? size.x / old.x : 1, old.y > 0 ? size.y / old.y : 1);
    return to.min + (point - from.min) * scale;
}

ResizeShapes::ResizeShapes(Drawing& drawing, const std::set<std::size_t>& shapes,
                           const clipping::Window& from, const clipping::Window& to)
    : QUndoCommand(QCoreApplication::translate("Commands", "Resize selection")), drawing_(drawing),
      patches_(patchesOf(drawing.sheet(), shapes, [&](Shape& shape) {
          for (Path& path : shape.paths) {
              path.start = fitted(path.start, from, to);
              for (Stretch& stretch : path.stretches) {
                  stretch.to = fitted(stretch.to, from, to);
                  if (stretch.curved) {
                      stretch.control1 = fitted(stretch.control1, from, to);
                      stretch.control2 = fitted(stretch.control2, from, to);
                  }
              }
          }
          return true;
      }))
{
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/remove_shapes.h"

#include <QCoreApplication>

namespace app {

RemoveShapes::RemoveShapes(Drawing& drawing, const ObjectRanges& shapes,
                           const QString& text)
    : UndoCommand(row, text), drawing_(drawing),
      patches_(patchesOf(drawing.sheet(), shapes, [](Shape&) { return false; }))
{
}

RemoveShapes::RemoveShapes(Drawing& drawing, const ObjectRanges& shapes)
    : RemoveShapes(drawing, shapes, QCoreApplication::translate("Commands", "Delete selection"))
{
}

} // namespace app

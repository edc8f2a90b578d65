// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_style.h"

namespace app {

SetStyle::SetStyle(Drawing& drawing, const ObjectRanges& shapes,
                   const std::function<void(Style&)>& change, const QString& text)
    : QUndoCommand(text), drawing_(drawing),
      patches_(patchesOf(drawing.sheet(), shapes, [&](Shape& shape) {
          change(shape.style);
          return true;
      }))
{
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_style.h"

namespace app {

SetStyle::SetStyle(Drawing& drawing, const ObjectRanges& shapes,
                   const std::function<void(Style&)>& change, const QString& text, Merging merging)
    : UndoCommand(row, text, merging), drawing_(drawing),
      patches_(patchesOf(drawing.sheet(), shapes, [&](Shape& shape) {
          change(shape.style);
          return true;
      }))
{
}

bool SetStyle::mergeWith(const UndoCommand& next)
{
    return samePlaces(patches_, static_cast<const SetStyle&>(next).patches_);
}

} // namespace app

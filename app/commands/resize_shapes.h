// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Moves and scales shapes so that what was in the rectangle `from` is in `to`. Stroke widths stay.
/// Along an axis where `from` has no extent, shapes are only moved.
class ResizeShapes : public UndoCommand {
public:
    static constexpr CommandKind row{"resize-shapes", "Moves and scales shapes"};

    ResizeShapes(Drawing& drawing, const ObjectRanges& shapes,
                 const clipping::Window& from, const clipping::Window& to);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }

private:
    Drawing& drawing_;
    Patches patches_;
};

/// Where a point of `from` is in `to`.
Point fitted(const Point& point, const clipping::Window& from, const clipping::Window& to);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Moves shapes.
class MoveShapes : public UndoCommand {
public:
    static constexpr CommandKind row{"move-shapes", "Moves shapes"};

    MoveShapes(Drawing& drawing, const ObjectRanges& shapes, const Point& by,
               Merging merging = Merging::Never);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }
    bool mergeWith(const UndoCommand& next) override;

private:
    Drawing& drawing_;
    Patches patches_; ///< in force: the shapes as they were
};

/// The shape, moved.
Shape moved(Shape shape, const Point& by);

} // namespace app

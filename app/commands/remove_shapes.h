// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Removes shapes. Undone, they are where they were.
class RemoveShapes : public UndoCommand {
public:
    static constexpr CommandKind row{"remove-shapes", "Removes shapes"};

    RemoveShapes(Drawing& drawing, const ObjectRanges& shapes, const QString& text);
    RemoveShapes(Drawing& drawing, const ObjectRanges& shapes);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }

private:
    Drawing& drawing_;
    Patches patches_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

namespace app {

/// Adds shapes, all of one layer, on top of that layer.
class AddShapes : public UndoCommand {
public:
    static constexpr CommandKind row{"add-shapes", "Adds shapes on top of a layer"};

    /// `text` names the step: "Draw line", "Paste". Not empty; `shapes` neither.
    AddShapes(Drawing& drawing, std::vector<Shape> shapes, const QString& text);

    /// Where they are while this command is in force.
    ObjectRanges shapes() const;

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }

private:
    Drawing& drawing_;
    std::size_t count_;
    Patches patches_;
};

} // namespace app

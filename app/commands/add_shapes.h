// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

#include <QUndoCommand>

namespace app {

/// Adds shapes, all of one layer, on top of that layer.
class AddShapes : public QUndoCommand {
public:
    /// `text` names the step: "Draw line", "Paste". Not empty; `shapes` neither.
    AddShapes(Drawing& drawing, std::vector<Shape> shapes, const QString& text);

    /// Where they are while this command is in force.
    ObjectRanges shapes() const;

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }

private:
    Drawing& drawing_;
    std::size_t count_;
    Patches patches_;
};

} // namespace app

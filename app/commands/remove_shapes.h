// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

#include <QUndoCommand>

namespace app {

/// Removes shapes. Undone, they are where they were.
class RemoveShapes : public QUndoCommand {
public:
    RemoveShapes(Drawing& drawing, const ObjectRanges& shapes, const QString& text);
    RemoveShapes(Drawing& drawing, const ObjectRanges& shapes);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }

private:
    Drawing& drawing_;
    Patches patches_;
};

} // namespace app

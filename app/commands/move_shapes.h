// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

#include <QUndoCommand>

namespace app {

/// Moves shapes.
class MoveShapes : public QUndoCommand {
public:
    MoveShapes(Drawing& drawing, ObjectRanges shapes, const Point& by,
               Merging merging = Merging::Never);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    int id() const override { return 2; }
    bool mergeWith(const QUndoCommand* next) override;

private:
    Drawing& drawing_;
    ObjectRanges shapes_;
    Merging merging_;
    Patches patches_; ///< in force: the shapes as they were
};

/// The shape, moved.
Shape moved(Shape shape, const Point& by);

} // namespace app

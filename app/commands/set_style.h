// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

#include <QUndoCommand>

namespace app {

/// Changes how shapes are painted.
class SetStyle : public QUndoCommand {
public:
    /// `change` is called once for each shape's style.
    SetStyle(Drawing& drawing, const ObjectRanges& shapes,
             const std::function<void(Style&)>& change, const QString& text);

    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }

private:
    Drawing& drawing_;
    Patches patches_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"

#include <QUndoCommand>

namespace app {

/// Draws, moves or resizes the clip window.
class SetWindow : public QUndoCommand {
public:
    SetWindow(Drawing& drawing, const clipping::Window& window, Merging merging = Merging::Never);

    void redo() override { drawing_.setWindow(after_); }
    void undo() override { drawing_.setWindow(before_); }
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* next) override;

private:
    Drawing& drawing_;
    clipping::Window before_, after_;
    Merging merging_;
};

} // namespace app

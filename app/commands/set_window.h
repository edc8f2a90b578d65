// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/memory.h"
#include "app/commands/undo_command.h"
#include "app/document/drawing.h"

namespace app {

/// Draws, moves or resizes the clip window.
class SetWindow : public UndoCommand {
public:
    static constexpr CommandKind row{"set-window", "Draws, moves or resizes the clip window"};

    SetWindow(Drawing& drawing, const clipping::Window& window, Merging merging = Merging::Never);

    void redo() override { drawing_.setWindow(after_); }
    void undo() override { drawing_.setWindow(before_); }
    bool mergeWith(const UndoCommand& next) override;
    std::size_t bytes() const override { return heapBlock(sizeof *this); }

private:
    Drawing& drawing_;
    clipping::Window before_, after_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/patch.h"
#include "app/document/cut.h"

namespace app {

/// Really cuts the drawing at its clip window.
class CropToWindow : public UndoCommand {
public:
    static constexpr CommandKind row{"crop-to-window", "Cuts the drawing at its clip window"};

    CropToWindow(Drawing& drawing, const CutOptions& options);

    const CutCounts& counts() const { return counts_; }
    bool changes() const { return counts_.cut + counts_.gone > 0; } ///< anything at all
    void redo() override { apply(drawing_, patches_); }
    void undo() override { revert(drawing_, patches_); }
    std::size_t bytes() const override { return heapBlock(sizeof *this) + heapBytes(patches_); }

private:
    Drawing& drawing_;
    CutCounts counts_;
    Patches patches_;
};

} // namespace app

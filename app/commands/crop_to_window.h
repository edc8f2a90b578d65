// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/cut/permanent_cuts.h"

namespace app {

/// Cuts the document permanently at its clip windows: crops, cuts out or splits.
class CropToWindow : public EditCommand {
public:
    static constexpr CommandKind row{"crop-to-window", "Cuts the drawing at its clip window"};

    CropToWindow(EditedDocument& document, const CutOptions& options);
    /// `cut` of the present document, made by `kind`.
    CropToWindow(EditedDocument& document, Cut cut,
                 const PermanentCut& kind = permanentCut("crop"));

    const CutCounts& counts() const { return counts_; }
    bool changes() const { return changes_; } ///< whether an object changes

private:
    CutCounts counts_;
    bool changes_;
};

} // namespace app

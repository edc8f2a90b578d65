// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/cut/cut.h"

namespace app {

/// Cuts the document permanently at its clip windows.
class CropToWindow : public EditCommand {
public:
    static constexpr CommandKind row{"crop-to-window", "Cuts the drawing at its clip window"};

    CropToWindow(EditedDocument& document, const CutOptions& options);
    CropToWindow(EditedDocument& document, Cut cut); ///< `cut` of the present document

    const CutCounts& counts() const { return counts_; }
    bool changes() const { return counts_.cut + counts_.gone > 0; } ///< whether an object changes

private:
    CutCounts counts_;
};

} // namespace app

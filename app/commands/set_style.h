// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Changes how objects are painted.
class SetStyle : public EditCommand {
public:
    static constexpr CommandKind row{"set-style", "Changes how objects are painted"};

    /// Calls `change` at least once for each style of the objects.
    SetStyle(EditedDocument& document, const ObjectRanges& objects,
             const std::function<void(Style&)>& change, const QString& text,
             Merging merging = Merging::Never);
};

} // namespace app

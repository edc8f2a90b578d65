// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Adds, moves or removes guides of the page.
class SetGuides : public EditCommand {
public:
    static constexpr CommandKind row{"set-guides", "Adds, moves or removes guides"};

    SetGuides(EditedDocument& document, Guides guides, const QString& text);
};

} // namespace app

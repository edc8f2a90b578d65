// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Sets how the page is divided among sheets of paper.
class SetSheets : public EditCommand {
public:
    static constexpr CommandKind row{"set-sheets", "Sets how the page is divided among sheets"};

    SetSheets(EditedDocument& document, std::optional<PageSheets> sheets, const QString& text);
};

} // namespace app

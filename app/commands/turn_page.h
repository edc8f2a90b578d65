// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Turns the page from portrait to landscape or back. Objects keep their places.
class TurnPage : public EditCommand {
public:
    static constexpr CommandKind row{"turn-page", "Turns the page"};

    explicit TurnPage(EditedDocument& document);
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Hides or shows objects by themselves, whatever layer or group they are in.
class SetHidden : public EditCommand {
public:
    static constexpr CommandKind row{"set-hidden", "Hides or shows objects"};

    SetHidden(EditedDocument& document, const ObjectRanges& objects, bool hidden,
              const QString& text)
        : EditCommand(row, document,
                      changed(document.now(), objects,
                              [hidden](ObjectRow& object, StyleTable&) { object.hidden = hidden; }),
                      text)
    {
    }
};

} // namespace app

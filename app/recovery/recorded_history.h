// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/commands/history.h"

namespace app {

/// A history as values, which any thread may keep.
struct RecordedHistory {
    struct Step {
        const CommandKind* kind; ///< a row of the catalogue
        QString text;
        Edit next; ///< the edit that the next undo or redo of this step applies
    };
    std::vector<Step> steps{};
    int index = 0; ///< the number of steps that are done
    std::optional<int> clean{};
};

/// The steps of a history that edits a document. Of the done steps, the newest ones that use at
/// most so many bytes of memory.
RecordedHistory recorded(const History& history, std::size_t mostBytes);

/// Makes these the steps of `history`, whose `document` must be in the state of the recording.
void restore(History& history, EditedDocument& document, RecordedHistory recorded);

/// The row of the catalogue with that key; for an unknown key, a row that adds and removes.
const CommandKind& kindOf(std::string_view key);

} // namespace app

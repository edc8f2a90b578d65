// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/recorded_history.h"

#include "app/commands/catalogue.h"

#include <algorithm>

namespace app {

RecordedHistory recorded(const History& history, std::size_t mostBytes)
{
    int first = history.index();
    for (std::size_t bytes = 0; first > 0; --first)
        if (bytes += history.command(first - 1).bytes(); bytes > mostBytes)
            break;
    RecordedHistory record;
    for (int i = first; i < history.count(); ++i) {
        const auto& command = static_cast<const EditCommand&>(history.command(i));
        record.steps.push_back({&command.kind(), command.text(), command.next()});
    }
    record.index = history.index() - first;
    if (const auto clean = history.cleanIndex(); clean && *clean >= first)
        record.clean = *clean - first;
    return record;
}

void restore(History& history, EditedDocument& document, RecordedHistory recorded)
{
    std::vector<std::unique_ptr<UndoCommand>> commands;
    for (RecordedHistory::Step& step : recorded.steps) {
        auto command =
            std::make_unique<EditCommand>(*step.kind, document, std::move(step.next), step.text);
        command->measure();
        commands.push_back(std::move(command));
    }
    history.restore(std::move(commands), recorded.index, recorded.clean);
}

const CommandKind& kindOf(std::string_view key)
{
    static constexpr CommandKind unknown{"edit", "Changes the document"};
    const auto all = commandKinds();
    const auto found = std::ranges::find(all, key, &CommandKind::key);
    return found == all.end() ? unknown : *found;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/nearest.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/teaching/manual.h"

namespace app {
namespace {

QString topicOverview()
{
    std::vector<std::pair<QString, QString>> rows;
    for (const QString& topic : manualTopics())
        if (const auto page = manualPage(topic); page && topic != manualIndex)
            rows.emplace_back(topic, page->title);
    return Text::tr("Usage: clearcut help TOPIC\n\nTopics:\n") + aligned(rows);
}

void help(const ParsedArguments& arguments)
{
    const QString topic = arguments.operands().value(0);
    if (topic.isEmpty())
        return print(topicOverview());
    const auto page = manualPage(topic);
    if (!page) {
        const auto meant = nearestTo(topic, manualTopics());
        const QString nothing = Text::tr("There is no page on “%1”.").arg(topic);
        throw WrongUsage{meant ? nothing + u' ' + Text::tr("Did you mean “%1”?").arg(*meant)
                               : nothing};
    }
    print(plainText(*page));
}

} // namespace

Command helpCommand()
{
    return {.key = "help",
            .usage = "[TOPIC]",
            .summary = Text::tr("Prints a page of the manual, or the list of its topics."),
            .options = {},
            .examples = {"clearcut help", "clearcut help snapping"},
            .operands = 1,
            .run = help,
            .lastIsOptional = true};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/misnamed.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/nearest.h"

#include <QFileInfo>

namespace app {
namespace {

std::optional<QString> nearestCommand(const QString& word)
{
    QStringList all;
    for (const Command& command : commands())
        all << QLatin1StringView(command.key);
    return nearestTo(word, all);
}

bool looksLikeFile(const QString& argument)
{
    return argument.contains(u'.') || argument.contains(u'/');
}

} // namespace

std::optional<Refusal> misnamed(const QString& argument)
{
    if (QFileInfo::exists(argument))
        return std::nullopt;
    if (const auto fault = faultOfName(argument))
        return Refusal{Text::tr("Cannot open %1: %2").arg(argument, *fault), Exit::Failed};
    if (looksLikeFile(argument))
        return Refusal{Text::tr("Cannot open %1: there is no such file.").arg(argument),
                       Exit::Failed};
    const auto nearest = nearestCommand(argument.toLower());
    if (nearest == argument)
        return Refusal{
            Text::tr("The command “%1” must come first. Try clearcut --help.").arg(argument),
            Exit::Usage};
    const QString nothing = Text::tr("There is no file or command “%1”.").arg(argument);
    const QString list = Text::tr("clearcut --help lists all commands.");
    return Refusal{nothing + u' '
                       + (nearest ? Text::tr("Did you mean “%1”?").arg(*nearest) + u' ' : QString())
                       + list,
                   Exit::Usage};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/misnamed.h"

#include "app/command_line/refusal.h"

#include <QFileInfo>

#include <algorithm>
#include <numeric>

namespace app {
namespace {

/// How many letters must be typed, left out or exchanged to make one word of the other.
std::size_t distance(const QString& word, const QString& other)
{
    std::vector<std::size_t> row(std::size_t(other.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (const QChar letter : word) {
        std::size_t diagonal = row[0]++;
        for (std::size_t i = 1; i < row.size(); ++i) {
            const std::size_t exchanged = diagonal + (other[qsizetype(i) - 1] != letter);
            diagonal = row[i];
            row[i] = std::min({exchanged, row[i] + 1, row[i - 1] + 1});
        }
    }
    return row.back();
}

QString nearestCommand(const QString& word)
{
    const auto all = commands();
    const auto far = [&](const Command& c) { return distance(word, QLatin1StringView(c.key)); };
    return QLatin1StringView(std::ranges::min_element(all, {}, far)->key);
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
    if (looksLikeFile(argument))
        return Refusal{Commands::tr("Cannot open %1: there is no such file.").arg(argument),
                       Exit::Failed};
    const QString nearest = nearestCommand(argument.toLower());
    if (nearest == argument)
        return Refusal{
            Commands::tr("The command “%1” must come first. Try clearcut --help.").arg(argument),
            Exit::Usage};
    return Refusal{Commands::tr("There is no file or command “%1”. The nearest command is “%2”; "
                                "clearcut --help lists them all.")
                       .arg(argument, nearest),
                   Exit::Usage};
}

} // namespace app

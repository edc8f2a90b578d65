// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/nearest.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace app {
namespace {

/// The number of letters to insert, delete or exchange to turn one word into the other.
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

} // namespace

std::optional<QString> nearestTo(const QString& word, const QStringList& words)
{
    const auto far = [&](const QString& other) { return distance(word, other); };
    const auto nearest = std::ranges::min_element(words, {}, far);
    if (nearest == words.end())
        return std::nullopt;
    const auto longer = std::size_t(std::max(word.size(), nearest->size()));
    return far(*nearest) * 5 <= longer * 2 ? std::optional(*nearest) : std::nullopt;
}

} // namespace app

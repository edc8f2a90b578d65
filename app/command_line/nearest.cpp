// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/nearest.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace app {
namespace {

/// The number of letters to insert, delete, exchange, or swap with the next one to turn one word
/// into the other ("optimal string alignment").
std::size_t distance(const QString& word, const QString& other)
{
    using Row = std::vector<std::size_t>;
    Row now(std::size_t(other.size()) + 1);
    std::iota(now.begin(), now.end(), 0);
    Row before = now, beforeThat = now;
    for (qsizetype w = 0; w < word.size(); ++w) {
        beforeThat = std::exchange(before, now);
        ++now[0];
        for (std::size_t i = 1; i < now.size(); ++i) {
            const auto o = qsizetype(i) - 1;
            now[i] =
                std::min({before[i - 1] + (other[o] != word[w]), before[i] + 1, now[i - 1] + 1});
            if (w > 0 && o > 0 && word[w] == other[o - 1] && word[w - 1] == other[o])
                now[i] = std::min(now[i], beforeThat[i - 2] + 1);
        }
    }
    return now.back();
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

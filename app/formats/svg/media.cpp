// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/media.h"

#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <string>

namespace app::svg {
namespace {

/// A condition, written without blanks, and whether a picture meets it.
struct MediaFeature {
    std::string_view text;
    bool met;
};
constexpr std::array mediaFeatures{
    MediaFeature{"all", true},
    MediaFeature{"screen", true},
    MediaFeature{"print", false},
    MediaFeature{"speech", false},
    MediaFeature{"(color)", true},
    MediaFeature{"(prefers-color-scheme:light)", true},
    MediaFeature{"(prefers-color-scheme:dark)", false},
    MediaFeature{"(prefers-reduced-motion:no-preference)", true},
    MediaFeature{"(prefers-reduced-motion:reduce)", false},
    MediaFeature{"(prefers-contrast:no-preference)", true},
    MediaFeature{"(prefers-contrast:more)", false},
    MediaFeature{"(forced-colors:none)", true},
    MediaFeature{"(forced-colors:active)", false},
};

std::string withoutBlanks(std::string_view text)
{
    std::string result;
    for (const char c : text)
        if (blanks.find(c) == blanks.npos)
            result += c;
    return result;
}

std::optional<bool> isMet(std::string_view condition)
{
    const std::string plain = withoutBlanks(condition);
    const auto found = std::ranges::find_if(mediaFeatures, [&](const MediaFeature& each) {
        return equalsIgnoringCase(each.text, plain);
    });
    return found == mediaFeatures.end() ? std::nullopt : std::optional(found->met);
}

bool takePrefix(std::string_view& text, std::string_view word)
{
    const bool begins =
        equalsIgnoringCase(text.substr(0, word.size()), word) && text.size() > word.size()
        && (blanks.find(text[word.size()]) != blanks.npos || text[word.size()] == '(');
    if (begins)
        text = trimmed(text.substr(word.size()));
    return begins;
}

// Where the next " and " outside brackets begins, or the end.
std::size_t endOfCondition(std::string_view text)
{
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += (text[i] == '(') - (text[i] == ')');
        auto rest = text.substr(i);
        if (depth == 0 && i > 0 && (blanks.find(text[i - 1]) != blanks.npos || text[i - 1] == ')')
            && takePrefix(rest, "and"))
            return i;
    }
    return text.size();
}

// One query. A condition that is not met decides, whatever the others are.
std::optional<bool> queryApplies(std::string_view query)
{
    const bool denied = takePrefix(query, "not");
    takePrefix(query, "only");
    bool clear = true, met = true;
    while (!query.empty()) {
        const auto end = endOfCondition(query);
        const auto one = isMet(trimmed(query.substr(0, end)));
        clear = clear && one;
        met = met && one.value_or(true);
        query = trimmed(query.substr(end));
        takePrefix(query, "and");
    }
    if (met && !clear)
        return std::nullopt;
    return met != denied;
}

} // namespace

std::optional<bool> appliesToScreens(std::string_view media)
{
    if (trimmed(media).empty())
        return true;
    bool applies = false, clear = true;
    while (!media.empty()) {
        const auto comma = std::min(media.find(','), media.size());
        const auto one = queryApplies(trimmed(media.substr(0, comma)));
        applies = applies || one.value_or(false);
        clear = clear && one;
        media.remove_prefix(std::min(comma + 1, media.size()));
    }
    return applies || clear ? std::optional(applies) : std::nullopt;
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/name_match.h"

#include "app/base/synonyms.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace app {
namespace {

enum Score : int { Letters = 1, Words, Part, WordStarts, WordStart, Start, Whole };

bool startsWord(const QString& name, qsizetype at)
{
    return at == 0 || !name[at - 1].isLetterOrNumber();
}

void append(QList<qsizetype>& letters, qsizetype first, qsizetype count)
{
    for (qsizetype i = 0; i < count; ++i)
        letters << first + i;
}

/// The first place of the text in the name, at the beginning of a word if there is one; -1: none.
qsizetype placeOf(const QString& text, const QString& name)
{
    const qsizetype first = name.indexOf(text, 0, Qt::CaseInsensitive);
    for (qsizetype at = first; at >= 0; at = name.indexOf(text, at + 1, Qt::CaseInsensitive))
        if (startsWord(name, at))
            return at;
    return first;
}

std::optional<NameMatch> asOne(const QString& typed, const QString& name)
{
    const qsizetype at = placeOf(typed, name);
    if (at < 0)
        return std::nullopt;
    NameMatch match{typed.size() == name.size() ? Whole
                    : at == 0                   ? Start
                    : startsWord(name, at)      ? WordStart
                                                : Part};
    append(match.letters, at, typed.size());
    return match;
}

std::optional<NameMatch> asWords(const QStringList& typed, const QString& name)
{
    NameMatch match{WordStarts};
    for (const QString& word : typed) {
        const qsizetype at = placeOf(word, name);
        if (at < 0)
            return std::nullopt;
        if (!startsWord(name, at))
            match.score = Words;
        append(match.letters, at, word.size());
    }
    std::ranges::sort(match.letters);
    match.letters.erase(std::ranges::unique(match.letters).begin(), match.letters.end());
    return match;
}

/// The typed letters in a name, each behind the one before or at the beginning of a word.
class LetterSearch {
public:
    LetterSearch(const QString& typed, const QString& name)
        : typed_(typed), name_(name), failed_(std::size_t(typed.size() * name.size()))
    {
    }
    std::optional<NameMatch> match()
    {
        NameMatch found{Letters};
        for (qsizetype at = 0; at < name_.size(); ++at)
            if (startsWord(name_, at) && goesOn(0, at, found.letters))
                return found;
        return std::nullopt;
    }

private:
    /// Whether the letters from this one on are found, this one at this place.
    bool goesOn(qsizetype letter, qsizetype at, QList<qsizetype>& letters)
    {
        auto&& failed = failed_[std::size_t(letter * name_.size() + at)];
        if (failed || name_[at].toLower() != typed_[letter].toLower())
            return false;
        letters << at;
        if (letter + 1 == typed_.size())
            return true;
        for (qsizetype next = at + 1; next < name_.size(); ++next)
            if ((next == at + 1 || startsWord(name_, next)) && goesOn(letter + 1, next, letters))
                return true;
        letters.removeLast();
        failed = true;
        return false;
    }

    const QString& typed_;
    const QString& name_;
    std::vector<bool> failed_; ///< for each letter and place
};

} // namespace

static std::optional<NameMatch> matchSpelled(const QString& text, const QString& name)
{
    if (auto match = asOne(text, name))
        return match;
    const QStringList words = text.split(u' ');
    if (words.size() > 1)
        return asWords(words, name);
    constexpr qsizetype most = 30, longest = 200; // of such names there are few
    if (text.size() > most || name.size() > longest)
        return std::nullopt;
    return LetterSearch(text, name).match();
}

/// The text with American words spelled the British way, which the program speaks.
static QString inBritishSpelling(QString text)
{
    constexpr std::array spellings{std::pair{"color", "colour"}, std::pair{"center", "centre"},
                                   std::pair{"gray", "grey"}};
    for (const auto& [american, british] : spellings)
        text.replace(QLatin1StringView(american), QLatin1StringView(british), Qt::CaseInsensitive);
    return text;
}

std::optional<NameMatch> matchName(const QString& typed, const QString& name)
{
    const QString text = typed.simplified();
    if (text.isEmpty())
        return NameMatch{};
    if (auto match = matchSpelled(text, name))
        return match;
    for (const QString& other : {inBritishSpelling(text), inProgramWords(text)})
        if (other != text)
            if (auto match = matchSpelled(other, name))
                return match;
    return std::nullopt;
}

} // namespace app

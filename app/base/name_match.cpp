// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/name_match.h"

#include <QStringList>

#include <algorithm>

namespace app {
namespace {

enum Score : int { Letters = 1, Words, Part, WordStarts, WordStart, Start };

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
    NameMatch match{at == 0 ? Start : startsWord(name, at) ? WordStart : Part};
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

/// From one letter to the next: the letter behind it, else the beginning of a word.
std::optional<NameMatch> asLetters(const QString& typed, const QString& name)
{
    NameMatch match{Letters};
    qsizetype at = 0;
    for (const QChar letter : typed) {
        const bool goesOn =
            !match.letters.isEmpty() && at < name.size() && name[at].toLower() == letter.toLower();
        while (!goesOn && at < name.size()
               && !(startsWord(name, at) && name[at].toLower() == letter.toLower()))
            ++at;
        if (at >= name.size())
            return std::nullopt;
        match.letters << at++;
    }
    return match;
}

} // namespace

std::optional<NameMatch> matchName(const QString& typed, const QString& name)
{
    const QString text = typed.simplified();
    if (text.isEmpty())
        return NameMatch{};
    if (auto match = asOne(text, name))
        return match;
    const QStringList words = text.split(u' ');
    if (words.size() > 1)
        return asWords(words, name);
    return asLetters(text, name);
}

} // namespace app

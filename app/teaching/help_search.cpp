// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/help_search.h"

#include "app/base/name_match.h"
#include "app/base/synonyms.h"
#include "app/base/text.h"
#include "app/teaching/manual.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <optional>

namespace app {

namespace {

constexpr int titleScore = 10'000, commandScore = 1'000, mostPlaces = 900;
constexpr qsizetype mostLetters = 200; // of what is typed: a paste may be endless
constexpr qsizetype excerptBefore = 24, excerptLength = 90; // letters of an excerpt

/// The words of a page, without what only markdown needs.
QString wordsOf(QString markdown)
{
    static const QRegularExpression target(QStringLiteral("\\]\\([^)]*\\)")),
        sign(QStringLiteral("[*`|\\[\\]#\\\\]|\\|?-{3,}"));
    markdown = withoutComments(markdown).section(u'\n', 1);
    return markdown.remove(target).remove(sign).simplified();
}

HelpPage pageOn(const clipping::Algorithm& algorithm)
{
    return {pageLink(algorithm),
            QStringLiteral("%1 (%2)").arg(latin(algorithm.name), latin(algorithm.abbreviation)),
            wordsOf(pageOf(algorithm)),
            {}};
}

std::vector<HelpPart> readContents()
{
    std::vector<HelpPart> parts;
    for (const ManualPart& part : manualParts()) {
        parts.push_back({part.title, {}});
        for (const QString& topic : part.topics)
            if (auto page = manualPage(topic))
                parts.back().pages.push_back({topic + QStringLiteral(".md"), page->title,
                                              wordsOf(page->markdown), page->explains});
    }
    parts.push_back({Text::tr("Algorithms"), {}});
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        parts.back().pages.push_back(pageOn(algorithm));
    for (HelpPart& part : parts)
        for (HelpPage& page : part.pages)
            page.small = page.text.toLower();
    return parts;
}

/// Whole words on both sides of a place, on one line.
QString excerpt(const QString& text, qsizetype place)
{
    const qsizetype from =
        place < excerptBefore ? 0 : text.indexOf(u' ', place - excerptBefore) + 1;
    const QString rest = text.mid(from, excerptLength);
    const bool isAll = from + rest.size() >= text.size();
    return (from > 0 ? QStringLiteral("… ") : QString())
           + (isAll ? rest : rest.left(rest.lastIndexOf(u' ')) + QStringLiteral(" …"));
}

struct Found {
    int score;
    QString why;
};

std::optional<Found> inCommands(const QString& typed, const HelpPage& page,
                                const HelpCommands& commands)
{
    std::optional<Found> best;
    for (const QString& key : page.commands) {
        const HelpCommand command = commands.value(key);
        const bool isKey = command.keys.contains(typed, Qt::CaseInsensitive);
        const auto match = matchName(typed, command.name);
        const int score = isKey ? titleScore : match ? match->score : 0;
        if (score > (best ? best->score : 1)) // more than some letters of it
            best = {score, command.keys.isEmpty()
                               ? command.name
                               : Text::tr("%1 (%2)").arg(command.name, command.keys.front())};
    }
    if (best)
        best->score += commandScore;
    return best;
}

/// The word of the page that a typed one means: itself, or the program's word for it; empty: the
/// page has neither.
QString wordOn(const HelpPage& page, const QString& typed)
{
    const auto isThere = [&page](const QString& word) {
        return page.small.contains(word) || page.title.contains(word, Qt::CaseInsensitive);
    };
    if (isThere(typed))
        return typed;
    const QString meant = inProgramWords(typed);
    return meant != typed && isThere(meant) ? meant : QString();
}

/// Each word, or the program's word for it, is somewhere on the page, apart from as many as may be
/// missing. They are in lower case.
std::optional<Found> inText(const QStringList& words, const HelpPage& page, qsizetype mayMiss)
{
    int places = 0;
    qsizetype first = -1, missing = 0; // the place of the first word that is there
    for (const QString& typed : words) {
        const QString word = wordOn(page, typed);
        if (word.isEmpty() && ++missing > mayMiss)
            return std::nullopt;
        if (word.isEmpty())
            continue;
        places += int(page.small.count(word));
        if (first < 0)
            first = page.small.indexOf(word);
    }
    return Found{std::min(places, mostPlaces) - int(missing) * mostPlaces,
                 first < 0 ? QString() : excerpt(page.text, first)};
}

std::optional<Found> find(const QString& typed, const QStringList& words, const HelpPage& page,
                          const HelpCommands& commands)
{
    if (const auto match = matchName(typed, page.title); match && match->score > 1)
        return Found{titleScore + match->score, {}};
    if (auto found = inCommands(typed, page, commands))
        return found;
    return inText(words, page, 0);
}

/// What is sought in a question: "how to turn something" is about to turn.
QStringList wordsSought(const QString& typed)
{
    static const QSet<QString> fillers{
        "a",    "an",    "and",  "are",  "by",   "can",   "do",    "does",      "for",
        "from", "get",   "how",  "i",    "in",   "into",  "is",    "it",        "make",
        "my",   "of",    "on",   "onto", "or",   "so",    "some",  "something", "that",
        "the",  "thing", "this", "to",   "what", "where", "which", "with"};
    const QStringList all = typed.toLower().split(u' ', Qt::SkipEmptyParts);
    QStringList words;
    for (const QString& word : all)
        if (!fillers.contains(word))
            words << word;
    return words.isEmpty() ? all : words;
}

} // namespace

const std::vector<HelpPart>& helpContents()
{
    static const std::vector<HelpPart> contents = readContents();
    return contents;
}

std::vector<HelpHit> searchHelp(const QString& typed, const HelpCommands& commands)
{
    const QStringList words = wordsSought(typed.left(mostLetters).simplified());
    if (words.isEmpty())
        return {};
    const QString sought = words.join(u' ');
    std::vector<std::pair<int, HelpHit>> found;
    const auto collect = [&](const auto& hitOn) {
        for (const HelpPart& part : helpContents())
            for (const HelpPage& page : part.pages)
                if (const std::optional<Found> hit = hitOn(page))
                    found.push_back({hit->score, {&page, hit->why}});
    };
    collect([&](const HelpPage& page) { return find(sought, words, page, commands); });
    for (qsizetype missing = 1; found.empty() && missing <= words.size() / 2; ++missing)
        collect([&](const HelpPage& page) { return inText(words, page, missing); });
    std::ranges::stable_sort(found, std::greater(), &std::pair<int, HelpHit>::first);
    std::vector<HelpHit> hits;
    for (auto& [score, hit] : found)
        hits.push_back(std::move(hit));
    return hits;
}

} // namespace app

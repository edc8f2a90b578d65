// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race_verdict.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/race/race_text.h"
#include "app/view/frame_times.h"

#include <QStringList>

#include <algorithm>

namespace app {
namespace {

using Kind = RaceStatement::Kind;
using clipping::Form;
using Statements = std::vector<RaceStatement>;

constexpr qsizetype mostTold = 3; // sentences of one sort; the others are counted

QString counted(std::size_t count, const QString& one, const QString& many)
{
    return count == 1 ? one : many.arg(countText(count));
}

bool measured(const RaceOutcome& outcome)
{
    return !outcome.rows.empty() && !outcome.rows.front().milliseconds.empty();
}

bool allAgree(const RaceOutcome& outcome, Form form)
{
    return std::ranges::none_of(outcome.rows, [form](const RaceRow& row) {
        return row.variant.form == form && row.differences.all() > 0;
    });
}

bool anyOf(const RaceOutcome& outcome, Form form)
{
    return std::ranges::any_of(outcome.rows,
                               [form](const RaceRow& row) { return row.variant.form == form; });
}

void addAgreement(Statements& all, const RaceOutcome& outcome)
{
    const bool corrected = anyOf(outcome, Form::Corrected);
    if (!allAgree(outcome, corrected ? Form::Corrected : Form::Published))
        return;
    const QString place =
        outcome.where.isEmpty() ? QString() : Text::tr(" in %1").arg(outcome.where);
    QStringList rest;
    if (corrected && anyOf(outcome, Form::Published) && allAgree(outcome, Form::Published))
        rest << Text::tr("So do the published forms.");
    const std::size_t visible = outcome.rows.front().visible;
    rest << counted(visible, Text::tr("1 line is visible."), Text::tr("%1 lines are visible."));
    all.push_back(
        {Kind::Agreement,
         (corrected ? Text::tr("All corrected forms agree%1.", "in a window")
                    : Text::tr("All published forms agree with exact arithmetic%1.", "in a window"))
             .arg(place),
         rest.join(u' ')});
}

void addDifferences(Statements& all, const RaceOutcome& outcome)
{
    std::vector<const RaceRow*> differing;
    for (const RaceRow& row : outcome.rows)
        if (row.differences.all() > 0)
            differing.push_back(&row);
    if (differing.empty())
        return;
    std::ranges::stable_sort(differing, std::greater(),
                             [](const RaceRow* row) { return row->differences.all(); });
    QStringList told;
    for (const RaceRow* row : differing)
        if (told.size() < mostTold)
            told << sentence(row->variant, exactVariant(), row->differences, outcome.lines) + u'.';
    if (const std::size_t more = differing.size() - std::size_t(told.size()))
        told << counted(more, Text::tr("1 other form differs on no more lines."),
                        Text::tr("%1 other forms differ on no more lines."));
    const QString first = told.takeFirst();
    all.push_back({Kind::Differences, first, told.join(u' '), differing.front()->variant});
}

/// The algorithms that cannot clip at some windows, and the names of these.
struct Limit {
    std::vector<std::size_t> pairs;
    QStringList windows;
};

std::vector<Limit> limitsOf(const RaceOutcome& outcome, std::span<const RacePair> pairs)
{
    std::vector<Limit> limits;
    for (const NamedNeeds& window : outcome.windows) {
        std::vector<std::size_t> unable;
        for (std::size_t i = 0; i < pairs.size(); ++i)
            if (!limitText(pairs[i].ablest().row.variant, window.needs).isEmpty())
                unable.push_back(i);
        if (unable.empty())
            continue;
        auto found = std::ranges::find(limits, unable, &Limit::pairs);
        if (found == limits.end())
            found = limits.insert(found, {unable, {}});
        found->windows << window.name;
    }
    return limits;
}

QString limitSentence(const Limit& limit, std::span<const RacePair> pairs)
{
    const QString where = briefListText(limit.windows);
    if (limit.pairs.size() == pairs.size())
        return Text::tr("None of these forms can clip %1.").arg(where);
    const Variant& only = pairs[limit.pairs.front()].ablest().row.variant;
    return limit.pairs.size() == 1 ? Text::tr("%1 cannot clip %2.").arg(shortNameOf(only), where)
                                   : Text::tr("%1 algorithms cannot clip %2.")
                                         .arg(countText(limit.pairs.size()), where);
}

void addLimits(Statements& all, const RaceOutcome& outcome)
{
    const std::vector<RacePair> pairs = pairsOf(outcome.rows);
    QStringList told;
    const std::vector<Limit> limits = limitsOf(outcome, pairs);
    for (const Limit& limit : limits)
        told << limitSentence(limit, pairs);
    if (told.isEmpty())
        return;
    const QString first = told.takeFirst();
    const Limit& only = limits.front();
    told << (limits.size() == 1 && only.windows.size() == 1 && only.pairs.size() > 1
                 ? Text::tr("They leave it alone, and its lines are not counted for them: nothing "
                            "there is lost.")
                 : Text::tr("Such a window is left alone, and lines there are not counted: nothing "
                            "there is lost."));
    all.push_back({Kind::Limits, first, told.join(u' ')});
}

QStringList namesOf(const std::vector<std::size_t>& group, std::span<const RaceRow> rows)
{
    std::vector<Variant> variants;
    for (const RaceRow& row : rows)
        variants.push_back(row.variant);
    QStringList names;
    for (const std::size_t i : group)
        names << nameAmong(variants, i);
    return names;
}

void addTies(Statements& all, std::span<const RaceRow> rows, const Ranking& ranking)
{
    if (!ranking.told) {
        all.push_back({Kind::Ties, Text::tr("It is too early to rank the times."),
                       Text::tr("%1 of the %2 rounds that it takes are done.")
                           .arg(ranking.rounds)
                           .arg(leastRounds(rows.size()))});
        return;
    }
    QStringList told;
    std::size_t more = 0;
    for (const auto& group : ranking.groups) {
        const QString names = briefListText(namesOf(group, rows));
        if (group.size() < 2)
            continue;
        const QString from = shortTimeText(rows[group.front()].summary().median),
                      to = shortTimeText(rows[group.back()].summary().median);
        if (told.isEmpty())
            told << (from == to ? Text::tr("%1 tie at about %2.").arg(names, from)
                                : Text::tr("%1 tie at %2 to %3.").arg(names, from, to))
                 << Text::tr(
                        "No test finds 1 % or more between them, so their order says nothing.");
        else if (told.size() <= mostTold)
            told << Text::tr("%1 tie, too.").arg(names);
        else
            ++more;
    }
    if (told.isEmpty())
        told << Text::tr("No two of these times tie.");
    if (more > 0)
        told << counted(more, Text::tr("1 more group ties."), Text::tr("%1 more groups tie."));
    if (ranking.hasFastest() && rows.size() > 1)
        told << Text::tr("%1 is fastest here.").arg(namesOf({ranking.order.front()}, rows).front());
    const QString first = told.takeFirst();
    all.push_back({Kind::Ties, first, told.join(u' ')});
}

void addUntimed(Statements& all, std::size_t lines)
{
    if (lines == 0)
        return all.push_back({Kind::Untimed, Text::tr("There are no lines to compare.")});
    all.push_back({Kind::Untimed,
                   counted(lines, Text::tr("1 line is too few to time."),
                           Text::tr("%1 lines are too few to time.")),
                   tooFewText(lines)});
}

} // namespace

std::vector<RaceStatement> verdictOf(const RaceOutcome& outcome)
{
    Statements all;
    const bool known = measured(outcome);
    if (known && outcome.lines > 0) {
        addAgreement(all, outcome);
        addDifferences(all, outcome);
    }
    addLimits(all, outcome);
    const bool timed = outcome.lines >= leastLinesToTime;
    if (known && timed && outcome.ranking)
        addTies(all, outcome.rows, *outcome.ranking);
    if (known && !timed)
        addUntimed(all, outcome.lines);
    return all;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/ranking.h"

#include <QStringList>

namespace app {

/// The letter of a group: "a" for the first.
QString groupLetter(std::size_t group);

/// "2"; empty if the thing does not differ significantly from another, or there were too few runs.
QString rankText(const Ranking& ranking, std::size_t thing);

/// The letters of its groups, "a b"; empty if there were too few runs.
QString lettersText(const Ranking& ranking, std::size_t thing);

/// p to three digits.
QString pText(double p);

/// A thing's time ÷ the time of the lowest median, and the p of that comparison. Both are empty for
/// the lowest median itself; p is empty if there were too few runs.
QString ratioToFastestText(const Ranking& ranking, std::size_t thing);
QString pToFastestText(const Ranking& ranking, std::size_t thing);

/// One sentence if there were too few runs to test for differences; empty if there were enough.
QString tooFewRunsText(const Ranking& ranking);

/// How to read the letters, and which test was used; or tooFewRunsText. Empty for a single thing.
QStringList rankingNotes(const Ranking& ranking);

/// The meaning of the ratio to the lowest median and its p. Empty for a single thing.
QStringList ratioNotes(const Ranking& ranking);

/// "From the lowest median to the highest: Skala (a), CS (b), LB (b c), CB (c)." and how to read
/// the letters, or tooFewRunsText. `names` are in the order of the ranked things.
QString rankingText(const QStringList& names, const Ranking& ranking);

/// A bound of an interval of times with two decimals, or with as many as a number above 0 needs;
/// empty if there is no bound.
QString boundText(double time);

} // namespace app

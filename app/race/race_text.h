// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/ranking.h"
#include "app/race/race_lane.h"

#include <QString>

namespace app {

/// "No significant difference of 1 % or more: MD and LB", by the tests of an experiment; empty if
/// every pair differs; a sentence while there are too few rounds for a test.
QString groupsText(std::span<const RaceRow> rows, const Ranking& ranking);

/// Of the rows' times, all with at least one. With 22 rows of 40 rounds it takes some milliseconds.
Ranking rankingOf(std::span<const RaceRow> rows);

/// "0.42 ms" as everywhere, but below 0.1 ms "30.1 µs", which keeps significant digits.
QString shortTimeText(double milliseconds);

/// "As published: 0.42 ms ± 30.1 µs, 7.1 operations per line, 1,120 visible lines, 456 differ";
/// without the time if it is not meaningful; empty if nothing was measured.
QString figuresText(const FormResult& result, bool timed);

/// For legends: "µs and differences: Rectangle 1 only, all can clip it". `where`: the name of the
/// window of the race, empty if there is no other one.
QString placeText(const QString& where, const RaceLane& lane);

/// "9,969 lines, rotated order, 1 thread"; "312 lines: too few to time".
QString fieldText(std::size_t lines);
/// Why so few lines are not timed, and what to do, in sentences; empty: they are timed.
QString tooFewText(std::size_t lines);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/line_class.h"
#include "app/experiment/experiment.h"
#include "app/experiment/ranking.h"
#include "app/tables/table.h"

#include <QByteArray>

namespace app::plug_in {

/// The key of the library, where algorithms have their own keys.
inline constexpr auto ownKey = "yours";

/// The times and results of one contender.
struct Contender {
    QString key;                                      ///< of the algorithm, or ownKey
    std::vector<double> times;                        ///< nanoseconds per line, one number per run
    std::array<double, lineClasses.size()> byClass{}; ///< medians, nanoseconds per line
    Findings found{};
};

/// The times of the judged library and of each algorithm, on the paper's scene.
struct Times {
    std::vector<Contender> contenders;               ///< the library is the first
    std::array<double, lineClasses.size()> shares{}; ///< of the lines of the scene, by class
    std::vector<std::pair<QString, QString>> facts;
    std::size_t ownWrong = 0; ///< lines that the library clipped wrongly while it was timed; if
                              ///< any, its time has no rank. Known only to the judge.
};

/// Converts to JSON on one line, and back; empty if the text is not such JSON, or `exact` is
/// missing.
QByteArray jsonOf(const Times& times);
std::optional<Times> timesOf(const QByteArray& json);

/// The ranks of the contenders, in the order of `contenders`.
Ranking rankingOf(const Times& times);

/// The library's time ÷ the time of contender `to`, by medians.
double ratioOf(const Times& times, std::size_t to);

/// Where a table is shown. File: keys and plain numbers. Terminal: keys, and errors in words.
/// Person (the interface): words, and numbers in the format of the locale.
enum class Reader : std::uint8_t { File, Terminal, Person };

/// A row for each contender, the fastest first: rank, time, and the library's time ÷ its time.
Table raceTable(const Times& times, Reader reader = Reader::File);
/// A row for each contender in the same order: nanoseconds per line of each class.
Table classTable(const Times& times, Reader reader = Reader::File);

} // namespace app::plug_in

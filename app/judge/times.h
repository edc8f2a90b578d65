// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/line_class.h"
#include "app/experiment/experiment.h"
#include "app/experiment/ranking.h"
#include "app/tables/table.h"

#include <QByteArray>

namespace app::plug_in {

/// What stands for the library where others have the key of their algorithm.
inline constexpr auto ownKey = "yours";

/// What one of them needed and found.
struct Contender {
    QString key;                                      ///< of the algorithm, or ownKey
    std::vector<double> times;                        ///< nanoseconds a line, one number a run
    std::array<double, lineClasses.size()> byClass{}; ///< medians, nanoseconds a line
    Findings found{};
};

/// The library beside every row, on the paper's scene.
struct Times {
    std::vector<Contender> contenders;               ///< the library is the first
    std::array<double, lineClasses.size()> shares{}; ///< of the scene, by class
    std::vector<std::pair<QString, QString>> facts;
    std::size_t ownWrong = 0; ///< lines that the library got wrong while it was timed: then its
                              ///< time has no rank. Known to the judge alone.
};

/// In one line, and back; nothing if it is not what was written, with `exact` among them.
QByteArray jsonOf(const Times& times);
std::optional<Times> timesOf(const QByteArray& json);

/// Who differs from whom, contenders in their order.
Ranking rankingOf(const Times& times);

/// How many times as long as the other the first one takes, by medians.
double ratioOf(const Times& times, std::size_t to);

/// Whom a table is for: a file holds keys and plain numbers, a terminal keys and errors in words, a
/// person reads words and numbers of the locale.
enum class Reader : std::uint8_t { File, Terminal, Person };

/// One row each, the fastest first: place, time, and how many times as long as it the library
/// takes.
Table raceTable(const Times& times, Reader reader = Reader::File);
/// One row each in the same order: nanoseconds a line, class by class.
Table classTable(const Times& times, Reader reader = Reader::File);

} // namespace app::plug_in

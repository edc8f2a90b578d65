// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/category.h"
#include "app/judge/times.h"

namespace app::plug_in {

/// One line that a library clips wrongly.
struct Finding {
    Fault fault;
    std::size_t category; ///< an index into categories()
    Question question;
    std::optional<clipping::Segment> expected;
    std::optional<clipping::Segment> got; ///< empty also if there was no answer
    double ulps = 0; ///< error of the ends, or distance outside the window; 0: no meaning
    QString more{};  ///< for a crash: the reason
};

/// The results of one category.
struct CategoryCount {
    std::size_t lines = 0, judged = 0, wrong = 0;
    std::size_t outside = 0; ///< ends that rounding left outside the window, within the contract
    std::size_t visible = 0; ///< of the judged lines: truly visible
    std::size_t wrongVisible = 0; ///< of these lines: wrong
};

/// How much longer than processor time the tests may take by the clock, for a library that sleeps
/// and on a busy machine.
inline constexpr double wallFactor = 3;

/// Why a library could not be judged at all.
enum class Unusable : std::uint8_t {
    NoFile,
    NotCompiled,
    NotLoadable,
    NoFunction,
    OtherVersion,
    Broken
};

/// The result of a judgement: plain data.
struct Verdict {
    QString path;
    QString name; ///< reported by the library, or its file's name
    Contract contract{};
    std::optional<Unusable> unusable{};
    QString more{};    ///< of an unusable library: the loader's message, or the reason of the crash
    QString command{}; ///< makes a library of an uncompiled file; may be empty
    /// In the order of categories(); the last one only after a race.
    std::vector<CategoryCount> categories{};
    std::vector<std::size_t> byFault = std::vector<std::size_t>(faults().size());
    std::vector<Finding> findings{}; ///< the first ones of each category
    double mostOff = 0;              ///< in ulps, of the right answers
    double nanoseconds = 0;          ///< per line, including the overhead of asking
    double seconds = 0;              ///< the time limit (Case::seconds)
    QString notReloaded{};           ///< why it could not be loaded again after a crash
    QString raceEnd{};               ///< why the library ended the race
    QString printed{};               ///< the first part of its output
    std::optional<Times> times{};
    QString noTimes{}; ///< why there are no times

    bool passed() const { return !unusable && wrong() == 0 && judged() == lines(); }
    bool hasRace() const { return categories.size() == app::plug_in::categories().size(); }
    std::size_t lines() const;
    std::size_t judged() const;
    std::size_t wrong() const;
    std::size_t outside() const;
    /// The fault to name first: one that ended the child, otherwise the most frequent one.
    std::optional<Fault> fault() const;
};

/// The result in one sentence; for an unusable library, what to do.
QString sentence(const Verdict& verdict);
/// Further remarks about rounding and speed, a sentence each.
QStringList remarks(const Verdict& verdict);

/// The error of a finding's ends: "3 ulps" if it can be rounding, beyond that "84.6 units" of the
/// coordinates. An ulp is one unit in the last place of the largest coordinate.
QString errorText(const Finding& finding);

/// Tables: the verdict in one row, a row for each category, a row for each wrong line.
Table summaryTable(const Verdict& verdict);
Table categoryTable(const Verdict& verdict, Reader reader = Reader::File);
Table findingTable(const Verdict& verdict, Reader reader = Reader::File);
/// All these tables and those of the race; for a file or a terminal.
std::vector<Table> tablesOf(const Verdict& verdict, Reader reader = Reader::File);
/// The same for a window, which shows the verdict itself; `findingTable` with all findings in
/// order.
std::vector<Table> shownTables(const Verdict& verdict);

} // namespace app::plug_in

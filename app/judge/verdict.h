// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/category.h"
#include "app/judge/times.h"

namespace app::plug_in {

/// One line that a library does wrong.
struct Finding {
    Fault fault;
    std::size_t category; ///< an index into categories()
    Question question;
    std::optional<clipping::Segment> expected;
    std::optional<clipping::Segment> got; ///< nothing also where there was no answer
    double ulps = 0; ///< how far the ends are off, or outside the window; 0 where neither says much
    QString more{};  ///< of a crash: why
};

/// How one category went.
struct CategoryCount {
    std::size_t lines = 0, judged = 0, wrong = 0;
    std::size_t outside = 0; ///< ends that rounding left outside the window, within the contract
    std::size_t visible = 0; ///< of the judged ones: truly visible
    std::size_t wrongVisible = 0; ///< of these: wrong
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

/// What came of it: plain data.
struct Verdict {
    QString path;
    QString name; ///< what the library calls itself, or its file's name
    Contract contract{};
    std::optional<Unusable> unusable{};
    QString more{};    ///< of an unusable one: what the loader said, or why it crashed
    QString command{}; ///< of one that is not compiled: what makes a library of it; may be empty
    /// In the order of categories(); the last one only after a race.
    std::vector<CategoryCount> categories{};
    std::vector<std::size_t> byFault = std::vector<std::size_t>(faults().size());
    std::vector<Finding> findings{}; ///< the first ones of each category
    double mostOff = 0;              ///< ulps, among what was right
    double nanoseconds = 0;          ///< a line, with what asking takes
    double seconds = 0;              ///< how long it might take (Case::seconds)
    QString notReloaded{};           ///< why it could not be loaded again after a crash
    QString raceEnd{};               ///< of a race that the library ended: why
    QString printed{};               ///< the first of what it printed
    std::optional<Times> times{};
    QString noTimes{}; ///< why there are none

    bool passed() const { return !unusable && wrong() == 0 && judged() == lines(); }
    bool hasRace() const { return categories.size() == app::plug_in::categories().size(); }
    std::size_t lines() const;
    std::size_t judged() const;
    std::size_t wrong() const;
    std::size_t outside() const;
    /// The fault to name first: one that ended the child, or else the most frequent one.
    std::optional<Fault> fault() const;
};

/// What came out, in one sentence; for one that is unusable, what to do.
QString sentence(const Verdict& verdict);
/// What else is to be said of it, a sentence each: rounding, speed.
QStringList remarks(const Verdict& verdict);

/// How far the ends of a finding are off: "3 ulps" where that can be rounding, beyond that
/// "84.6 units" of the coordinates. An ulp is one unit in the last place of the largest coordinate.
QString errorText(const Finding& finding);

/// The verdict in one row of facts, a row a category, a row a line that is wrong.
Table summaryTable(const Verdict& verdict);
Table categoryTable(const Verdict& verdict, Reader reader = Reader::File);
Table findingTable(const Verdict& verdict, Reader reader = Reader::File);
/// All there are, with those of the race; for a file or a terminal.
std::vector<Table> tablesOf(const Verdict& verdict, Reader reader = Reader::File);
/// The same for a window, which says the verdict itself; all findings of `findingTable` in order.
std::vector<Table> shownTables(const Verdict& verdict);

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/judge.h"

#include "app/base/progress.h"
#include "app/base/text.h"
#include "app/experiment/ranking.h"
#include "app/judge/child.h"
#include "app/judge/examination.h"
#include "app/judge/race_check.h"
#include "app/judge/signal_text.h"

#include <QFileInfo>

#include <algorithm>

namespace app::plug_in {
namespace {

constexpr double mostLines = 100'000, fewestLines = 2000;
constexpr double raceNanoseconds = 4e9; ///< of the library in a race

/// As many runs as a test of the library against every algorithm needs.
std::size_t runs() { return usualRounds(clipping::algorithms().size() + 1); }

/// As many lines as the time allows; a line is clipped in some dozen turns.
std::uint64_t linesFor(double nanoseconds)
{
    const double most = raceNanoseconds / (2 * (double(runs()) + 1) * std::max(nanoseconds, 1.0));
    return std::uint64_t(std::min(most, mostLines));
}

std::size_t raceCategory()
{
    return std::size_t(std::ranges::find(categories(), Asked::InTheRace, &Category::asked)
                       - categories().begin());
}

/// Adds the errors of the race to the verdict.
void addFindings(Verdict& verdict, const RaceFindings& found)
{
    verdict.categories.push_back({.lines = found.lines,
                                  .judged = found.lines,
                                  .wrong = found.wrong(),
                                  .outside = found.outside,
                                  .visible = found.visible,
                                  .wrongVisible = found.wrongVisible});
    verdict.mostOff = std::max(verdict.mostOff, found.mostOff);
    for (std::size_t i = 0; i < found.byFault.size(); ++i)
        verdict.byFault[i] += found.byFault[i];
    const std::size_t category = raceCategory();
    for (const auto& [fault, question, answer] : found.first) {
        const auto result =
            judged(question, answer, verdict.contract, categories()[category].visibilityUlps);
        verdict.findings.push_back({fault, category, question, expected(question), answer.piece(),
                                    std::max(result.off, result.outside)});
    }
}

/// The library ended the race or hung: a fault, whose line is unknown.
void addEnd(Verdict& verdict, ChildProcess::WaitResult news, const ChildProcess& child,
            std::uint64_t lines)
{
    const bool stuck = news != ChildProcess::WaitResult::Ended;
    const Fault fault = stuck             ? Fault::DidNotEnd
                        : child.crashed() ? Fault::Crashed
                                          : Fault::LeftProgram;
    if (!verdict.hasRace())
        verdict.categories.push_back({.lines = std::size_t(lines), .judged = 1});
    ++verdict.categories.back().wrong;
    ++verdict.byFault[std::size_t(fault)];
    verdict.raceEnd = stuck             ? Text::tr("it did not go on")
                      : child.crashed() ? signalText(child.exitCode())
                                        : Text::tr("exit code %1").arg(child.exitCode());
    verdict.noTimes = Text::tr("It was not timed: it did not reach the end of the race.");
}

/// Sleeping is not a fault, but these lines remain untested.
void addSleep(Verdict& verdict, std::uint64_t lines)
{
    verdict.categories.push_back({.lines = std::size_t(lines)});
    verdict.noTimes = Text::tr("It was not timed, because it slept in the race.");
}

QStringList raceArguments(const Case& which, std::uint64_t lines)
{
    return {QLatin1StringView(childKey),
            QStringLiteral("race"),
            QFileInfo(which.library).absoluteFilePath(),
            QString::number(lines),
            QString::number(runs()),
            QString::number(which.seed),
            wordOf(which.contract.strictness)};
}

/// Reads the child's reports until the race is over or there are no more. Times are accepted only
/// after the findings; findings only once.
ChildProcess::WaitResult follow(ChildProcess& child, Verdict& verdict, const Case& which,
                                const Follower& follower)
{
    const WaitLimits start{10, 20}, patience{10, which.raceSleep};
    auto news = child.waitForStart(start, follower.stop);
    if (news == ChildProcess::WaitResult::Came)
        news = child.waitForLine(start, follower.stop);
    child.readLine(); // the algorithm's name is known already
    while (news == ChildProcess::WaitResult::Came && !verdict.times) {
        news = child.waitForLine(patience, follower.stop);
        if (news != ChildProcess::WaitResult::Came)
            break;
        const QByteArray line = child.readLine();
        if (verdict.hasRace())
            verdict.times = timesOf(line);
        else if (const auto found = raceFindingsOf(line))
            addFindings(verdict, *found);
        else if (follower.progress)
            follower.progress({line.toDouble(), 0});
    }
    return news;
}

/// Returns false if it was stopped.
bool addTimes(Verdict& verdict, const Case& which, const Follower& follower)
{
    if (verdict.judged() < verdict.lines() && verdict.wrong() == 0) {
        verdict.noTimes = Text::tr("It was not timed: it was too slow for the tests.");
        return true;
    }
    const auto lines = linesFor(verdict.nanoseconds);
    if (double(lines) < fewestLines) {
        verdict.noTimes =
            Text::tr("It was not timed: it takes about %1 µs per line, too long for a race.")
                .arg(verdict.nanoseconds / 1000, 0, 'f', 0);
        return true;
    }
    ChildProcess child(programOf(which), raceArguments(which, lines));
    const auto news = follow(child, verdict, which, follower);
    if (news == ChildProcess::WaitResult::Stopped)
        return false;
    if (verdict.times)
        verdict.times->ownWrong = verdict.categories.back().wrong;
    else if (news == ChildProcess::WaitResult::Asleep && !verdict.hasRace())
        addSleep(verdict, lines);
    else
        addEnd(verdict, news, child, lines);
    return true;
}

bool isAlive(const Verdict& verdict)
{
    return !verdict.unusable && verdict.judged() > 0 && verdict.notReloaded.isEmpty()
           && std::ranges::none_of(faults(), [&](const FaultInfo& info) {
                  return info.fatal && verdict.byFault[std::size_t(info.fault)] > 0;
              });
}

} // namespace

std::optional<Verdict> judge(const Case& which, const Follower& follower)
{
    const bool wanted = which.race == Case::Race::Yes;
    PhasedProgress phases(follower, wanted ? std::vector{1.0, 1.0} : std::vector{1.0});
    const Follower first = phases.next();
    Examination examination(which, first);
    if (!examination.run())
        return std::nullopt;
    Verdict verdict = examination.take();
    if (!wanted)
        return verdict;
    if (!isAlive(verdict)) {
        if (!verdict.unusable)
            verdict.noTimes = Text::tr("It was not timed, because it crashed or did not end.");
        return verdict;
    }
    const Follower second = phases.next();
    return addTimes(verdict, which, second) ? std::optional(std::move(verdict)) : std::nullopt;
}

} // namespace app::plug_in

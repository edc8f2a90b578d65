// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/judge.h"

#include "app/experiment/legs.h"
#include "app/plug_in/child.h"
#include "app/plug_in/examination.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace app::plug_in {
namespace {

struct PlugIn {
    Q_DECLARE_TR_FUNCTIONS(PlugIn)
};

constexpr double runs = 10, mostLines = 100'000, fewestLines = 2000;
constexpr double raceNanoseconds = 4e9; ///< what the library may take of a race

/// As many lines as there is time for; a line is clipped in some dozen turns.
std::uint64_t linesFor(double nanoseconds)
{
    const double most = raceNanoseconds / (2 * (runs + 1) * std::max(nanoseconds, 1.0));
    return std::uint64_t(std::min(most, mostLines));
}

/// False: it was stopped.
bool addTimes(Verdict& verdict, const Case& which, const Follower& follower)
{
    const auto lines = linesFor(verdict.nanoseconds);
    if (double(lines) < fewestLines) {
        verdict.noTimes =
            PlugIn::tr("It was not timed: it takes about %1 µs a line, too long for a "
                       "race.")
                .arg(verdict.nanoseconds / 1000, 0, 'f', 0);
        return true;
    }
    const Patience patience{10, 60};
    ChildProcess child(programOf(which),
                       {QLatin1StringView(childKey), QStringLiteral("race"),
                        QFileInfo(which.library).absoluteFilePath(), QString::number(lines),
                        QString::number(int(runs)), QString::number(which.seed)});
    for (bool first = true;; first = false) {
        const auto news = child.waitForLine(patience, follower.stop);
        if (news == ChildProcess::News::Stopped)
            return false;
        if (news != ChildProcess::News::Came)
            break;
        const QByteArray line = child.readLine();
        if (first)
            continue; // what it is called is known
        if ((verdict.times = timesOf(line)))
            return true;
        if (follower.progress)
            follower.progress({line.toDouble(), 0});
    }
    verdict.noTimes = PlugIn::tr("It was not timed: it did not come to the end of the race.");
    return true;
}

bool isAlive(const Verdict& verdict)
{
    return !verdict.unusable && verdict.judged() > 0
           && std::ranges::none_of(faults(), [&](const FaultInfo& info) {
                  return info.fatal && verdict.byFault[std::size_t(info.fault)] > 0;
              });
}

} // namespace

std::optional<Verdict> judge(const Case& which, const Follower& follower)
{
    const bool wanted = which.race == Case::Race::Yes;
    Legs legs(follower, wanted ? std::vector{1.0, 1.0} : std::vector{1.0});
    const Follower first = legs.next();
    Examination examination(which, first);
    if (!examination.run())
        return std::nullopt;
    Verdict verdict = examination.take();
    if (!wanted)
        return verdict;
    if (!isAlive(verdict)) {
        if (!verdict.unusable)
            verdict.noTimes = PlugIn::tr("It was not timed: only what comes to its end is.");
        return verdict;
    }
    const Follower second = legs.next();
    return addTimes(verdict, which, second) ? std::optional(std::move(verdict)) : std::nullopt;
}

} // namespace app::plug_in

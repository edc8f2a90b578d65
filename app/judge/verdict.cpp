// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/verdict.h"

#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/judge/points.h"

#include <algorithm>
#include <numeric>

#include "resources/plug_in/clearcut_algorithm.h"

namespace app::plug_in {
namespace {

std::size_t sum(const std::vector<CategoryCount>& all, std::size_t CategoryCount::*what)
{
    return std::accumulate(
        all.begin(), all.end(), std::size_t(0),
        [what](std::size_t so, const CategoryCount& one) { return so + one.*what; });
}

QString unusableText(const Verdict& v)
{
    switch (*v.unusable) {
    case Unusable::NoFile:
        return Text::tr("There is no file %1: compile the library first.").arg(v.path);
    case Unusable::NotCompiled:
        return v.more;
    case Unusable::NotLoadable:
        return Text::tr("%1 cannot be loaded. The loader says: %2.").arg(v.path, v.more);
    case Unusable::NoFunction:
        return Text::tr("%1 has no function clearcut_clip: include clearcut_algorithm.h, and in "
                        "C++ keep its declaration, which is extern \"C\".")
            .arg(v.path);
    case Unusable::OtherVersion:
        return Text::tr("%1 was made for version %2 of clearcut_algorithm.h. Compile it with the "
                        "header of this Clearcut, which is version %3.")
            .arg(v.path, v.more)
            .arg(CLEARCUT_ABI_VERSION);
    case Unusable::Broken:
        return Text::tr("%1 failed while it was loaded: %2.").arg(v.path, v.more);
    }
    return {};
}

/// "corners (24) and edges (12)": the categories with the most first.
QString whereText(const Verdict& v)
{
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < v.categories.size(); ++i)
        if (v.categories[i].wrong > 0)
            wrong.push_back(i);
    std::ranges::stable_sort(wrong, std::greater(),
                             [&](std::size_t i) { return v.categories[i].wrong; });
    QStringList parts;
    for (const std::size_t i : wrong)
        parts << Text::tr("%1 (%2)").arg(categories()[i].name, countText(v.categories[i].wrong));
    return briefListText(parts);
}

QString wrongText(const Verdict& v)
{
    const FaultInfo& info = infoOf(*v.fault());
    const auto worst =
        std::ranges::find_if(v.findings, [&](const Finding& f) { return f.fault == info.fault; });
    if (info.fatal) {
        const bool inRace = worst == v.findings.end();
        const QString& where =
            categories()[inRace ? v.categories.size() - 1 : worst->category].name;
        const QString& more = inRace ? v.raceEnd : worst->more;
        return more.isEmpty()
                   ? Text::tr("Wrong: %1 %2 (%3).").arg(v.name, info.sentence, where)
                   : Text::tr("Wrong: %1 %2 (%3): %4.").arg(v.name, info.sentence, where, more);
    }
    return Text::tr("Wrong: %1 %2. It is wrong on %3 of %4 lines: %5.")
        .arg(v.name, info.sentence, countText(v.wrong()), countText(v.judged()), whereText(v));
}

/// "It passes everything but “Invalid input”: 10 of 11 categories are right, 103 of 110 points."
QString scoreText(const Verdict& v)
{
    const Score score = scoreOf(v);
    const QString counts = Text::tr("%1 of %2 categories are right, %3 of %4 points")
                               .arg(score.right)
                               .arg(score.categories)
                               .arg(score.points)
                               .arg(score.most);
    if (score.right + 1 != score.categories)
        return Text::tr("%1.").arg(counts);
    for (std::size_t i = 0; i < v.categories.size(); ++i)
        if (pointsOf(v.categories[i]) < fullPoints)
            return Text::tr("It passes everything but “%1”: %2.").arg(categories()[i].name, counts);
    return {};
}

QString tooSlowText(const Verdict& v)
{
    const QString untested = countText(v.lines() - v.judged());
    if (v.judged() == 0)
        return Text::tr("Too slow: there was no time to test %1 on any of %2 lines.")
            .arg(v.name, untested);
    return Text::tr("Too slow: %1 is right on the %2 lines that were tested within %3 of processor "
                    "time, or %4 by the clock. %5 lines were not tested.")
        .arg(v.name, countText(v.judged()), durationText(v.seconds),
             durationText(v.seconds * wallFactor), untested);
}

/// The sentence for a library without errors that slept in the race.
QString asleepText(const Verdict& v)
{
    return Text::tr("Not finished: %1 is right on the %2 lines that were tested. But it slept in "
                    "the race, so the race's %3 lines were not tested.")
        .arg(v.name, countText(v.judged()), countText(v.lines() - v.judged()));
}

QString roundingText(const Verdict& v)
{
    const QString ulps = QString::number(v.mostOff, 'g', 3);
    if (v.outside() == 0)
        return Text::tr("No end lies outside the window, not even by rounding. None is off by more "
                        "than %1 ulps of the largest coordinate.")
            .arg(ulps);
    const QString rounded = v.outside() == 1
                                ? Text::tr("Rounding left an end of 1 result outside the window")
                                : Text::tr("Rounding left ends of %1 results outside the window")
                                      .arg(countText(v.outside()));
    return rounded
           + Text::tr(", by at most %1 ulps of the largest coordinate. Clearcut's own algorithms "
                      "leave no end outside.")
                 .arg(ulps);
}

QString speedText(const Times& times)
{
    const Ranking ranking = rankingOf(times);
    std::size_t slower = 0;
    for (std::size_t i = 1; i < times.contenders.size(); ++i)
        slower += ranking.pairs[i][0].outcome == Outcome::Different && ratioOf(times, i) < 1;
    const std::size_t others = times.contenders.size() - 1;
    return Text::tr(
               "It takes %1 on the paper's scene, significantly less than %2 of the %3 others. It "
               "takes %4 times as long as exact, which is also called line by line.")
        .arg(timeText(summaryOf(times.contenders.front().times).median))
        .arg(slower)
        .arg(others)
        .arg(QString::number(
            ratioOf(times, std::size_t(std::ranges::find(times.contenders,
                                                         latin(clipping::exactAlgorithm().key),
                                                         &Contender::key)
                                       - times.contenders.begin())),
            'f', 2));
}

bool isWrongOnlyInRace(const Verdict& v)
{
    return v.hasRace() && v.categories.back().wrong > 0 && v.wrong() == v.categories.back().wrong;
}

} // namespace

std::size_t Verdict::lines() const { return sum(categories, &CategoryCount::lines); }
std::size_t Verdict::judged() const { return sum(categories, &CategoryCount::judged); }
std::size_t Verdict::wrong() const { return sum(categories, &CategoryCount::wrong); }
std::size_t Verdict::outside() const { return sum(categories, &CategoryCount::outside); }

std::optional<Fault> Verdict::fault() const
{
    for (const FaultInfo& info : faults())
        if (info.fatal && byFault[std::size_t(info.fault)] > 0)
            return info.fault;
    const auto most = std::ranges::max_element(byFault);
    return *most > 0 ? std::optional(Fault(most - byFault.begin())) : std::nullopt;
}

QString sentence(const Verdict& v)
{
    if (v.unusable)
        return unusableText(v);
    if (v.wrong() > 0)
        return wrongText(v);
    if (!v.passed())
        return v.hasRace() ? asleepText(v) : tooSlowText(v);
    return Text::tr("Passed: %1 is right on all %2 lines.").arg(v.name, countText(v.lines()));
}

QStringList remarks(const Verdict& v)
{
    QStringList all;
    if (v.unusable)
        return v.command.isEmpty() ? all : all << v.command;
    if (v.wrong() > 0)
        all << scoreText(v);
    if (v.wrong() > 0 && v.judged() < v.lines())
        all << Text::tr("Not tested: %1.").arg(linesText(v.lines() - v.judged()));
    if (!v.notReloaded.isEmpty())
        all << Text::tr("After the error it could not be loaded again: %1.").arg(v.notReloaded);
    if (isWrongOnlyInRace(v))
        all << Text::tr(
            "It is right on every line outside the race, but its results in the race differ.");
    if (v.passed())
        all << roundingText(v);
    if (v.times)
        all << (v.categories.back().wrong > 0 ? Text::tr(
                    "Its time does not count, because its results in the race were wrong.")
                                              : speedText(*v.times));
    else if (!v.noTimes.isEmpty())
        all << v.noTimes;
    if (!v.printed.isEmpty())
        all << Text::tr("It printed: %1").arg(v.printed.section(u'\n', 0, 0).left(120));
    return all;
}

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/ulps.h"
#include "app/judge/points.h"
#include "app/teaching/line_text.h"

#include <QLocale>

#include <cmath>

namespace app::plug_in {
namespace {

/// As many digits as are needed to read back bit for bit; with an exponent if that is shorter.
QString number(double value)
{
    if (std::isnan(value))
        return QStringLiteral("nan");
    if (std::isinf(value))
        return value < 0 ? QStringLiteral("-inf") : QStringLiteral("inf");
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString numbers(const glm::dvec2& p, const glm::dvec2& q)
{
    return QStringList{number(p.x), number(p.y), number(q.x), number(q.y)}.join(u',');
}

QString numbers(const std::optional<clipping::Segment>& piece)
{
    return piece ? numbers(piece->a, piece->b) : Text::tr("nothing");
}

QString words(const glm::dvec2& p) { return pairText(shortText(p.x), shortText(p.y)); }

QString words(const glm::dvec2& p, const glm::dvec2& q, const QString& between)
{
    return QStringList{words(p), between, words(q)}.join(u' ');
}

QString words(const std::optional<clipping::Segment>& piece)
{
    return piece ? words(piece->a, piece->b, QStringLiteral("→")) : Text::tr("nothing");
}

/// The error in the unit of the coordinates.
double distanceOf(const Finding& one)
{
    return one.ulps * ulpFor(one.question.line, one.question.window);
}

QString outcomeWord(const Verdict& v)
{
    return v.unusable      ? QStringLiteral("unusable")
           : v.passed()    ? QStringLiteral("passed")
           : v.wrong() > 0 ? QStringLiteral("wrong")
                           : QStringLiteral("too-slow");
}

} // namespace

QString errorText(const Finding& finding)
{
    constexpr double mostRounding = 1e6; // in ulps: a larger error cannot be rounding
    if (!(finding.ulps > 0))
        return {};
    if (finding.ulps < mostRounding)
        return Text::tr("%1 ulps").arg(finding.ulps < 10
                                           ? shortText(finding.ulps)
                                           : countText(std::size_t(std::llround(finding.ulps))));
    const double distance = distanceOf(finding);
    return std::isfinite(distance) ? Text::tr("%1 units").arg(QString::number(distance, 'g', 3))
                                   : Text::tr("infinitely far");
}

Table summaryTable(const Verdict& v)
{
    const Score score = scoreOf(v);
    Table table{.names = {"library", "name", "outcome", "fault", "lines", "judged", "wrong",
                          "rounded_outside", "most_ulps", "points", "most_points"},
                .title = sentence(v),
                .key = QStringLiteral("verdict"),
                .notes = remarks(v)};
    table.rows.push_back(
        {v.path, v.name, outcomeWord(v), v.fault() ? infoOf(*v.fault()).key : QString(),
         QString::number(v.lines()), QString::number(v.judged()), QString::number(v.wrong()),
         QString::number(v.outside()), QString::number(v.mostOff, 'g', 4),
         QString::number(score.points), QString::number(score.most)});
    table.facts = {{"ulps_allowed", QString::number(v.contract.ulps)},
                   {"contract", wordOf(v.contract.strictness)}};
    return table;
}

Table categoryTable(const Verdict& v, Reader reader)
{
    const bool person = reader == Reader::Person;
    Table table{
        .names = {"category", "lines", "judged", "wrong", "rounded_outside", "points", "degree"},
        .title = Text::tr("Tests"),
        .key = QStringLiteral("categories")};
    if (person)
        table.names << QStringLiteral("meaning");
    for (std::size_t i = 0; i < v.categories.size(); ++i) {
        const CategoryCount& one = v.categories[i];
        const Category& asked = categories()[i];
        table.rows.push_back({person ? asked.name : asked.key, QString::number(one.lines),
                              QString::number(one.judged), QString::number(one.wrong),
                              QString::number(one.outside), QString::number(pointsOf(one)),
                              person ? degreeOf(one).name : degreeOf(one).key});
        if (person)
            table.rows.back() << asked.meaning;
    }
    return table;
}

/// A file has the number and the distance; people get one readable text.
Table findingTable(const Verdict& v, Reader reader)
{
    const bool person = reader == Reader::Person, file = reader == Reader::File;
    const auto ends = [&](const std::optional<clipping::Segment>& piece) {
        return person ? words(piece) : numbers(piece);
    };
    Table table{.names = {"category", "fault", "line", "window", "expected", "got"},
                .title = Text::tr("Wrong results, the first of each category"),
                .key = QStringLiteral("findings")};
    if (reader == Reader::Terminal)
        table.notes << Text::tr(
            "An ulp is one unit in the last place of the largest coordinate of line and window. "
            "Errors above a million ulps are in units of the coordinates.");
    table.names << (file ? QStringList{"ulps", "distance"} : QStringList{"error"});
    for (const Finding& one : v.findings) {
        const auto& [line, window] = one.question;
        const FaultInfo& info = infoOf(one.fault);
        const Category& asked = categories()[one.category];
        QStringList row{person ? asked.name : asked.key,
                        person ? info.name : info.key,
                        ends(line),
                        person ? words(window.min, window.max, QStringLiteral("…"))
                               : numbers(window.min, window.max),
                        ends(one.expected),
                        info.fatal ? one.more : ends(one.got)};
        if (!file)
            row << errorText(one);
        else if (one.ulps > 0)
            row << QString::number(one.ulps, 'g', 4) << QString::number(distanceOf(one), 'g', 4);
        else
            row << QString() << QString();
        table.rows.push_back(row);
    }
    return table;
}

std::vector<Table> tablesOf(const Verdict& v, Reader reader)
{
    std::vector<Table> all{summaryTable(v)};
    if (!v.categories.empty())
        all.push_back(categoryTable(v, reader));
    if (!v.findings.empty())
        all.push_back(findingTable(v, reader));
    if (v.times) {
        all.push_back(raceTable(*v.times, reader));
        all.push_back(classTable(*v.times, reader));
    }
    return all;
}

std::vector<Table> shownTables(const Verdict& v)
{
    std::vector<Table> all;
    if (!v.categories.empty())
        all.push_back(categoryTable(v, Reader::Person));
    if (!v.findings.empty())
        all.push_back(findingTable(v, Reader::Person));
    if (v.times) {
        all.push_back(raceTable(*v.times, Reader::Person));
        all.push_back(classTable(*v.times, Reader::Person));
    }
    return all;
}

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/verdict.h"
#include "app/teaching/line_text.h"
#include "app/teaching/walk.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace app::plug_in {
namespace {

struct PlugIn {
    Q_DECLARE_TR_FUNCTIONS(PlugIn)
};

/// So many digits that it reads back bit for bit; with an exponent where that is shorter.
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
    return piece ? numbers(piece->a, piece->b) : PlugIn::tr("nothing");
}

QString words(const glm::dvec2& p) { return pairText(shortText(p.x), shortText(p.y)); }

QString words(const glm::dvec2& p, const glm::dvec2& q, const QString& between)
{
    return QStringList{words(p), between, words(q)}.join(u' ');
}

QString words(const std::optional<clipping::Segment>& piece)
{
    return piece ? words(piece->a, piece->b, QStringLiteral("→")) : PlugIn::tr("nothing");
}

QString outcomeWord(const Verdict& v)
{
    return v.unusable      ? QStringLiteral("unusable")
           : v.passed()    ? QStringLiteral("passed")
           : v.wrong() > 0 ? QStringLiteral("wrong")
                           : QStringLiteral("too-slow");
}

} // namespace

Table summaryTable(const Verdict& v)
{
    Table table{.names = {"library", "name", "outcome", "fault", "lines", "judged", "wrong",
                          "rounded_outside", "most_ulps"},
                .title = sentence(v),
                .key = QStringLiteral("verdict"),
                .notes = remarks(v)};
    table.rows.push_back(
        {v.path, v.name, outcomeWord(v), v.fault() ? infoOf(*v.fault()).key : QString(),
         QString::number(v.lines()), QString::number(v.judged()), QString::number(v.wrong()),
         QString::number(v.outside()), QString::number(v.mostOff, 'g', 4)});
    table.facts = {{"ulps_allowed", QString::number(v.contract.ulps)},
                   {"contract", v.contract.strictness == Strictness::Clearcuts
                                    ? QStringLiteral("strict")
                                    : QStringLiteral("textbook")}};
    return table;
}

Table categoryTable(const Verdict& v, Reader reader)
{
    const bool person = reader == Reader::Person;
    Table table{.names = {"category", "lines", "judged", "wrong", "rounded_outside"},
                .title = PlugIn::tr("What was asked"),
                .key = QStringLiteral("categories")};
    if (person)
        table.names << QStringLiteral("meaning");
    for (std::size_t i = 0; i < v.categories.size(); ++i) {
        const CategoryCount& one = v.categories[i];
        const Category& asked = categories()[i];
        table.rows.push_back({person ? asked.name : asked.key, QString::number(one.lines),
                              QString::number(one.judged), QString::number(one.wrong),
                              QString::number(one.outside)});
        if (person)
            table.rows.back() << asked.meaning;
    }
    return table;
}

Table findingTable(const Verdict& v, Reader reader)
{
    const bool person = reader == Reader::Person;
    const auto ends = [&](const std::optional<clipping::Segment>& piece) {
        return person ? words(piece) : numbers(piece);
    };
    Table table{.names = {"category", "fault", "line", "window", "expected", "got", "ulps"},
                .title = PlugIn::tr("Lines that are wrong, the first of each category"),
                .key = QStringLiteral("findings")};
    for (const Finding& one : v.findings) {
        const auto& [line, window] = one.question;
        const FaultInfo& info = infoOf(one.fault);
        const Category& asked = categories()[one.category];
        table.rows.push_back({person ? asked.name : asked.key, person ? info.name : info.key,
                              ends(line),
                              person ? words(window.min, window.max, QStringLiteral("…"))
                                     : numbers(window.min, window.max),
                              ends(one.expected), info.fatal ? one.more : ends(one.got),
                              one.ulps > 0 ? QString::number(one.ulps, 'g', 4) : QString()});
    }
    return table;
}

std::vector<Table> tablesOf(const Verdict& v)
{
    std::vector<Table> all{summaryTable(v)};
    if (!v.categories.empty())
        all.push_back(categoryTable(v));
    if (!v.findings.empty())
        all.push_back(findingTable(v));
    if (v.times) {
        all.push_back(raceTable(*v.times));
        all.push_back(classTable(*v.times));
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

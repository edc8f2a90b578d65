// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/times.h"

#include "app/base/text.h"
#include "app/experiment/ranking_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace app::plug_in {
namespace {

template <class Numbers>
QJsonArray arrayOf(const Numbers& numbers)
{
    QJsonArray array;
    for (const double number : numbers)
        array.append(number);
    return array;
}

std::vector<double> numbersOf(const QJsonValue& array)
{
    std::vector<double> numbers;
    for (const auto& value : array.toArray())
        numbers.push_back(value.toDouble());
    return numbers;
}

using ByClass = std::array<double, lineClasses.size()>;

ByClass byClassOf(const QJsonValue& array)
{
    ByClass all{};
    const auto numbers = numbersOf(array);
    std::copy_n(numbers.begin(), std::min(numbers.size(), all.size()), all.begin());
    return all;
}

Contender contenderOf(const QJsonObject& object)
{
    Contender one{
        object["key"].toString(), numbersOf(object["times"]), byClassOf(object["classes"]), {}};
    one.found.visible = std::uint64_t(object["visible"].toDouble());
    one.found.lost = std::uint64_t(object["lost"].toDouble());
    one.found.shown = std::uint64_t(object["shown"].toDouble());
    return one;
}

std::vector<Summary> summariesOf(const Times& times)
{
    std::vector<Summary> all;
    for (const Contender& one : times.contenders)
        all.push_back(summaryOf(one.times));
    return all;
}

/// The columns have the names of the experiment's columns, and therefore the same headings.
Table tableOf(const Times& times, const QString& key, const QString& title,
              const QStringList& names)
{
    Table table{.names = names, .title = title, .key = key, .facts = times.facts};
    table.notes << Text::tr("Every algorithm is called line by line through a pointer, as yours "
                            "is. In experiments they clip many lines at once and take less.");
    return table;
}

QString nameFor(Reader reader, const Contender& one)
{
    return reader == Reader::Person && one.key == QLatin1StringView(ownKey) ? Text::tr("▸  Yours")
                                                                            : one.key;
}

QString nanoseconds(double time) { return QString::number(time, 'f', 2); }

} // namespace

QByteArray jsonOf(const Times& times)
{
    QJsonArray contenders;
    for (const Contender& one : times.contenders)
        contenders.append(QJsonObject{{"key", one.key},
                                      {"times", arrayOf(one.times)},
                                      {"classes", arrayOf(one.byClass)},
                                      {"visible", double(one.found.visible)},
                                      {"lost", double(one.found.lost)},
                                      {"shown", double(one.found.shown)}});
    QJsonArray facts;
    for (const auto& [name, value] : times.facts)
        facts.append(QJsonArray{name, value});
    return QJsonDocument(QJsonObject{{"contenders", contenders},
                                     {"shares", arrayOf(times.shares)},
                                     {"facts", facts}})
        .toJson(QJsonDocument::Compact);
}

std::optional<Times> timesOf(const QByteArray& json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    Times times{{}, byClassOf(object["shares"]), {}};
    for (const auto& one : object["contenders"].toArray())
        times.contenders.push_back(contenderOf(one.toObject()));
    for (const auto& fact : object["facts"].toArray())
        times.facts.emplace_back(fact[0].toString(), fact[1].toString());
    const auto isEmpty = [](const Contender& one) { return one.times.empty(); };
    const auto isUnpaired = [&](const Contender& one) {
        return one.times.size() != times.contenders.front().times.size();
    };
    const bool hasExact =
        std::ranges::count(times.contenders, latin(clipping::exactAlgorithm().key), &Contender::key)
        == 1;
    if (times.contenders.size() < 2 || !hasExact || std::ranges::any_of(times.contenders, isEmpty)
        || std::ranges::any_of(times.contenders, isUnpaired))
        return std::nullopt;
    return times;
}

Ranking rankingOf(const Times& times)
{
    std::vector<std::vector<double>> runs;
    for (const Contender& one : times.contenders)
        runs.push_back(one.times);
    return app::rankingOf(runs);
}

double ratioOf(const Times& times, std::size_t to)
{
    return summaryOf(times.contenders.front().times).median
           / summaryOf(times.contenders[to].times).median;
}

Table raceTable(const Times& times, Reader reader)
{
    Table table = tableOf(times, QStringLiteral("race"),
                          Text::tr("Race on the paper's scene: nanoseconds per line"),
                          {"algorithm", "rank", "median_ns", "low_ns", "high_ns", "ratio",
                           "visible", "lost", "shown", "letters"});
    const auto summaries = summariesOf(times);
    const Ranking ranking = rankingOf(times);
    for (const std::size_t i : ranking.order) {
        const Contender& one = times.contenders[i];
        const bool isWrong = i == 0 && times.ownWrong > 0;
        table.rows.push_back(
            {nameFor(reader, one), isWrong ? QStringLiteral("wrong") : rankText(ranking, i),
             nanoseconds(summaries[i].median), boundText(summaries[i].confidence.low),
             boundText(summaries[i].confidence.high), nanoseconds(ratioOf(times, i)),
             QString::number(one.found.visible), QString::number(one.found.lost),
             QString::number(one.found.shown), lettersText(ranking, i)});
    }
    table.notes << Text::tr("Ratio: your median time ÷ its median time.") << rankingNotes(ranking);
    return table;
}

Table classTable(const Times& times, Reader reader)
{
    Table table = tableOf(
        times, QStringLiteral("classes"), Text::tr("By class of line: nanoseconds per line"),
        {"algorithm", "inside_ns", "rejected_ns", "cut_ns", "missed_ns", "weighted_ns"});
    for (const std::size_t i : sortedByMedian(summariesOf(times))) {
        const Contender& one = times.contenders[i];
        QStringList row{nameFor(reader, one)};
        double weighted = 0;
        for (std::size_t c = 0; c < one.byClass.size(); ++c) {
            row << nanoseconds(one.byClass[c]);
            weighted += times.shares[c] * one.byClass[c];
        }
        table.rows.push_back(row << nanoseconds(weighted));
    }
    return table;
}

} // namespace app::plug_in

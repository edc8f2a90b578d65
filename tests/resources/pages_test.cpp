// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages in resources/algorithms say was measured is what their commands print today.
#include "app/base/text.h"
#include "app/lessons/reading.h"
#include "app/teaching/manual.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>

#include "tests/app/command_line/program.h"
#include "tests/clipping/rows.h"
#include "tests/resources/page_claims.h"
#include "tests/test_class.h"

namespace pages_test {

namespace {

using clipping::Algorithm;
using clipping::Form;

/// What the program prints. Each command runs once.
const Ended& resultOf(const QString& command)
{
    static QMap<QString, Ended> known;
    if (!known.contains(command))
        known[command] = clearcut(command.split(u' '));
    return known[command];
}

QJsonDocument jsonOf(const QString& command)
{
    return QJsonDocument::fromJson(resultOf(command + QStringLiteral(" -f json")).out);
}

/// The rows of the first table that name `word` (an algorithm, a form or a class), the whole scene
/// where there are classes of lines.
QList<QJsonObject> rowsOf(const QString& command, const QString& word)
{
    QList<QJsonObject> rows;
    for (const QJsonValue value : jsonOf(command)[0]["rows"].toArray()) {
        const QJsonObject row = value.toObject();
        const auto is = [&](const char* name) { return row[QLatin1StringView(name)] == word; };
        const bool whole = !row.contains("class") || row["class"] == "whole scene";
        if (whole && (word.isEmpty() || is("algorithm") || is("form")))
            rows << row;
    }
    return rows;
}

/// Of a trace the operations of its last step, of other commands a row of their first table.
/// Empty where the expression names none, or more than one.
QJsonObject valuesOf(const QString& command, const QString& word)
{
    if (command.startsWith(QStringLiteral("trace "))) {
        QJsonObject counts = jsonOf(command)["steps"].toArray().last()["operations"].toObject();
        counts["all"] = counts["comparisons"].toDouble() + counts["additions"].toDouble()
                        + counts["multiplications"].toDouble() + counts["divisions"].toDouble();
        return counts;
    }
    const auto rows = rowsOf(command, word);
    return rows.size() == 1 ? rows.front() : QJsonObject();
}

/// "NAME", "NAME / NAME", each with "@ WORD" after it or not. NaN: the command does not print it.
double measured(const Claim& claim)
{
    static const QRegularExpression form(QStringLiteral("^(\\w+)(?: / (\\w+))?(?: @ ([\\w-]+))?$"));
    const auto match = form.match(claim.expression);
    const auto values = valuesOf(claim.command, match.captured(3));
    const auto value = [&](int group) { return values[match.captured(group)].toDouble(NAN); };
    return (match.captured(2).isEmpty() ? value(1) : value(1) / value(2))
           * (claim.percent ? 100 : 1);
}

/// What the paper's authors printed.
bool isInThePaper(const QString& number)
{
    const auto lines = contentOf(SOURCE_DIR "/resources/paper/percentages.csv").split('\n');
    return std::ranges::any_of(
        lines, [&](const QByteArray& line) { return line.split(',').contains(number.toUtf8()); });
}

bool isRight(const Claim& claim, const Algorithm& algorithm)
{
    if (claim.expression == QStringLiteral("bound"))
        return agrees(claim.number, algorithm.ulps);
    if (claim.expression == QStringLiteral("paper"))
        return isInThePaper(claim.number);
    return !claim.command.isEmpty() && agrees(claim.number, measured(claim));
}

QString pageOf(const Algorithm& algorithm) { return app::pageOf(algorithm); }

std::array<double, 4> numbersOf(const clipping::OperationCounts& c)
{
    return {double(c.comparisons), double(c.additions), double(c.multiplications),
            double(c.divisions)};
}

/// What a row of the costs should say.
std::array<double, 4> costOf(const Algorithm& algorithm, Form form, const QString& line)
{
    const auto ends = line.split(u',');
    const auto end = [&](int i) { return glm::dvec2{ends[i].toDouble(), ends[i + 1].toDouble()}; };
    const clipping::Segment segment{end(0), end(2)};
    return numbersOf(
        functionsOf(algorithm, form)->trace(segment, {{-100, -75}, {100, 75}}).steps.back().cost);
}

/// The mean of the scene, by the page's own command.
std::array<double, 4> meanOf(const QString& page, Form form)
{
    static const QRegularExpression ofAllLines(QStringLiteral("-a \\w+ --measure operations$"));
    const auto commands = commandsOf(page.simplified()).filter(ofAllLines);
    const auto row =
        valuesOf(commands.value(0), form == Form::Published ? QStringLiteral("published")
                                                            : QStringLiteral("corrected"));
    std::array<double, 4> mean;
    for (int i = 0; const char* name : {"comparisons", "additions", "multiplications", "divisions"})
        mean[std::size_t(i++)] = row[QLatin1StringView(name)].toDouble(NAN);
    return mean;
}

/// All numbers of these commands and their answers, without their signs.
QList<double> printedBy(const QStringList& commands)
{
    static const QRegularExpression number(QStringLiteral("\\d+(?:\\.\\d+)?"));
    QList<double> numbers;
    for (const QString& command : commands) {
        const QString all = command + QString::fromUtf8(resultOf(command).out);
        for (auto found = number.globalMatch(all); found.hasNext();)
            numbers << found.next().captured().toDouble();
    }
    return numbers;
}

/// Decimal numbers of the text, without those of its commands and without 0.0999…
QStringList decimalsOf(const QString& paragraph)
{
    static const QRegularExpression decimal(QStringLiteral("\\d+\\.\\d+(?![\\d…])")),
        code(QStringLiteral("`[^`]*`|<!--.*?-->"));
    const QString text = QString(paragraph).remove(code);
    QStringList all;
    for (auto found = decimal.globalMatch(text); found.hasNext();)
        all << found.next().captured();
    return all;
}

} // namespace

class PagesTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreMeasured_data() { everyAlgorithm(); }
    void numbersAreMeasured()
    {
        QFETCH(const Algorithm*, algorithm);
        int count = 0;
        for (const QString& paragraph : paragraphsOf(pageOf(*algorithm)))
            for (const Claim& claim : claimsOf(paragraph)) {
                ++count;
                const QString said =
                    QStringLiteral("The page says %1 for \"%2\", and `clearcut %3` prints %4")
                        .arg(claim.number, claim.expression, claim.command)
                        .arg(claim.command.isEmpty() ? NAN : measured(claim));
                QVERIFY2(isRight(claim, *algorithm), qPrintable(said));
            }
        QVERIFY2(count >= 3, "the page names nothing that was measured");
    }

    void noNumberIsWithoutItsCommand_data() { everyAlgorithm(); }
    void noNumberIsWithoutItsCommand()
    {
        QFETCH(const Algorithm*, algorithm);
        static const QRegularExpression unit(
            QStringLiteral("[\\d½](?: %| ulps?+| per cent| units? in the last)(?!<!--).{0,40}"));
        const auto found = unit.match(pageOf(*algorithm).simplified());
        QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
    }

    void costsAreCounted_data() { everyAlgorithm(); }
    void costsAreCounted()
    {
        QFETCH(const Algorithm*, algorithm);
        const QString page = pageOf(*algorithm);
        const std::vector<Form> forms = algorithm->published
                                            ? std::vector{Form::Published, Form::Corrected}
                                            : std::vector{Form::Corrected};
        const auto rows = costRowsOf(page);
        QVERIFY(rows.size() >= 10);
        for (const CostRow& row : rows) {
            QCOMPARE(row.cells.size(), qsizetype(forms.size()));
            for (std::size_t f = 0; f < forms.size(); ++f) {
                const auto expected = row.line.contains(u',') && row.line.count(u',') == 3
                                          ? costOf(*algorithm, forms[f], row.line)
                                          : meanOf(page, forms[f]);
                const auto said = row.cells[qsizetype(f)].split(QStringLiteral(" / "));
                QCOMPARE(said.size(), 4);
                for (int i = 0; i < 4; ++i)
                    QVERIFY2(agrees(said[i], expected[std::size_t(i)]),
                             qPrintable(row.line + QStringLiteral(": ") + row.cells.join(u'|')
                                        + QStringLiteral(" but %1").arg(expected[std::size_t(i)])));
            }
        }
        QCOMPARE(int(std::ranges::count(rows, QStringLiteral("400,000"), &CostRow::line)), 1);
    }

    /// The numbers of worked examples, which have no marks, are those of their traces.
    void examplesAreTraced()
    {
        static const QRegularExpression traced(QStringLiteral("^trace .*\\d$"));
        int numbers = 0;
        for (const Algorithm& algorithm : clipping::algorithms())
            for (const QString& paragraph : paragraphsOf(pageOf(algorithm))) {
                const QStringList traces = commandsOf(paragraph).filter(traced);
                if (traces.isEmpty() || !claimsOf(paragraph).empty())
                    continue;
                const QList<double> known = printedBy(traces);
                for (const QString& said : decimalsOf(paragraph)) {
                    const auto is = [&](double number) { return agrees(said, number); };
                    QVERIFY2(std::ranges::any_of(known, is),
                             qPrintable(QStringLiteral("%1 is not printed by %2")
                                            .arg(said, traces.join(u' '))));
                    ++numbers;
                }
            }
        QVERIFY(numbers > 20);
    }

    void commandsRun_data() { everyAlgorithm(); }
    void commandsRun()
    {
        QFETCH(const Algorithm*, algorithm);
        int count = 0;
        for (const QString& paragraph : paragraphsOf(pageOf(*algorithm)))
            for (const QString& command : commandsOf(paragraph)) {
                if (command.endsWith(QStringLiteral("LINE")))
                    continue; // of the table: costsAreCounted
                const Ended& run = resultOf(command + QStringLiteral(" -f json"));
                QVERIFY2(run.code == 0, qPrintable(command + run.err));
                ++count;
            }
        QVERIFY(count > 0);
    }

    /// The marks are for this test; readers see the commands.
    void marksAreNotSeen_data() { everyAlgorithm(); }
    void marksAreNotSeen()
    {
        QFETCH(const Algorithm*, algorithm);
        const QString seen = app::readingOf(*algorithm);
        QVERIFY(pageOf(*algorithm).contains(QStringLiteral("<!--")));
        QVERIFY2(!seen.contains(QStringLiteral("<!--")) && !seen.contains(QStringLiteral("-->")),
                 qPrintable(seen));
        for (const QString& command : commandsOf(pageOf(*algorithm)))
            QVERIFY(seen.contains(command));
    }

    // A wrong number is found.
    void roundsLikeAPerson()
    {
        QVERIFY(agrees("8.7", 8.68) && agrees("8.7", 8.7) && agrees("1,088", 1088));
        QVERIFY(!agrees("8.7", 8.6) && !agrees("8.7", 8.76) && !agrees("8", 8.6)
                && !agrees("8", NAN));
        const auto claims = claimsOf(QStringLiteral(
            "It is off by 3 ulps<!-- most_ulps @ corrected --> (`clearcut bench -a cs`)."));
        QCOMPARE(claims.size(), std::size_t(1));
        QCOMPARE(claims[0].number, QStringLiteral("3"));
        QCOMPARE(claims[0].command, QStringLiteral("bench -a cs"));
        QVERIFY(!isRight({"24", false, "bound", {}}, clipping::exactAlgorithm()));
        QVERIFY(!isRight({"12.46", false, "paper", {}}, clipping::exactAlgorithm()));
        QVERIFY(isRight({"12.45", false, "paper", {}}, clipping::exactAlgorithm()));
    }
};

} // namespace pages_test

TEST_CLASS(pages_test::PagesTest, Core)
#include "tests/resources/pages_test.moc"

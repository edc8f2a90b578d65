// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/teaching/figure.h"
#include "app/teaching/figure_svg.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/trace_file.h"

#include <QGuiApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "tests/app/command_line/program.h"
#include "tests/app/teaching/formulas/lines.h"
#include "tests/deep.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace teaching_trace_page_test {

using namespace app;

namespace {

constexpr qsizetype mostBytes = 300'000;

TraceExport traceOf(const Variant& variant,
                    const clipping::Segment& line = {{-160, -30}, {70, 130}})
{
    TraceExport trace{.tracedLine = {variant, line, {{-100, -75}, {100, 75}}, YAxis::Up, {}},
                      .narration = {}};
    trace.narration = narrationOf(trace.tracedLine);
    return trace;
}
TraceExport traceOf(const char* key, const clipping::Segment& line = {{-160, -30}, {70, 130}})
{
    return traceOf(*findVariant(QString::fromLatin1(key)), line);
}

QString pageOf(const TraceExport& trace)
{
    return QString::fromUtf8(traceBytes(trace, *findTraceFormat(u"html"))->front());
}

/// A step's figure as a picture by another program.
QImage painted(const QByteArray& elements, const QSize& size, const QString& folder)
{
    QByteArray style = "*{fill:none;font-family:'DejaVu Sans'}";
    for (const auto& [name, colour] : figureClasses(Ground::Light))
        style += QByteArray(".f-") + name + "{fill:" + colour.name().toLatin1() + "}.s-" + name
                 + "{stroke:" + colour.name().toLatin1() + '}';
    const QString from = folder + "/figure.svg", to = folder + "/figure.png";
    QFile file(from);
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write("<svg xmlns='http://www.w3.org/2000/svg' width='" + QByteArray::number(size.width())
               + "' height='" + QByteArray::number(size.height()) + "'><style>" + style + "</style>"
               + elements + "</svg>");
    file.close();
    return runProgram("rsvg-convert", {from, "-o", to}).code == 0 ? QImage(to) : QImage();
}

QImage paintedHere(const TraceStep& at, const QSize& size)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(15);
    QImage image(size, QImage::Format_ARGB32);
    QPainter painter(&image);
    paintStep(painter, at, nearFrame(at.tracedLine, size, font), figureColours(Ground::Light));
    return image;
}

/// The mean difference of two pictures' pixels, of 255.
double meanDifference(const QImage& a, const QImage& b)
{
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / (double(a.width()) * a.height());
}

/// The rows that need exact arithmetic, or a script for each pair of regions, are not.
bool isRunByPages(const Variant& variant)
{
    const std::string_view key = variant.algorithm->key;
    return key != "exact" && key != "winding-number" && key != "sobkow-pospisil-yang";
}

/// A number as JavaScript writes it where JSON has none.
QJsonValue numberOf(double v)
{
    return std::isfinite(v)  ? QJsonValue(v)
           : std::isnan(v)   ? QJsonValue("NaN")
           : std::signbit(v) ? QJsonValue("-Infinity")
                             : QJsonValue("Infinity");
}

QJsonArray numbersOf(const Point& p, const Point& q)
{
    return {numberOf(p.x), numberOf(p.y), numberOf(q.x), numberOf(q.y)};
}

QJsonObject countsOf(const clipping::OperationCounts& cost)
{
    return {{"comparisons", qint64(cost.comparisons)},
            {"additions", qint64(cost.additions)},
            {"multiplications", qint64(cost.multiplications)},
            {"divisions", qint64(cost.divisions)},
            {"negations", qint64(cost.negations)}};
}

/// A form with the library's runs of many lines, for interpreter_check.js.
QJsonObject runsOf(const Variant& variant)
{
    const auto& functions = functionsOf(variant);
    static const auto inputs = [] {
        auto all = formulas::inputs();
        // First, so that it is always run: the ends of the point in which it meets this window are
        // rounded differently.
        all.insert(all.begin(), {{{11, -27.500000000000007}, {2.25, 7.5}}, {{-3, 0.5}, {4, 0.5}}});
        return all;
    }();
    QJsonArray runs, code;
    QJsonObject kinds;
    for (std::size_t i = 0; i < inputs.size(); i += std::size_t(3 * tests::caseStep() - 2)) {
        const auto& [line, window] = inputs[i];
        const clipping::Trace trace = functions.trace(line, window);
        const bool isVisible = trace.outcome == clipping::Outcome::Visible;
        const auto& visible = trace.visible;
        for (const auto& step : trace.steps)
            for (const auto& value : step.values)
                if (value.kind != clipping::ValueKind::Number)
                    kinds[latin(value.name)] = QStringLiteral("whole");
        runs.append(QJsonObject{
            {"line", numbersOf(line.a, line.b)},
            {"window", numbersOf(window.min, window.max)},
            {"outcome", isVisible                                       ? "visible"
                        : trace.outcome == clipping::Outcome::DidNotEnd ? "did not end"
                                                                        : "invisible"},
            {"visible", isVisible ? QJsonValue(numbersOf(visible.a, visible.b)) : QJsonValue()},
            {"counts", countsOf(trace.steps.back().cost)}});
    }
    for (const QString& text : traceOf(variant).narration.code)
        code.append(text);
    return {{"name", keyOf(variant)},
            {"code", code},
            {"kinds", kinds},
            // One comparison says which of two numbers is less, or that none is (exceptions.h).
            {"comparesLess", keyOf(variant) == "slater-barsky"},
            {"runs", runs}};
}

} // namespace

class TracePageTest : public QObject {
    Q_OBJECT

private slots:
    void aPageOfEachFormNeedsNothingElseAndIsSmall()
    {
        static const QRegularExpression elsewhere(
            "https?:|//\\w|url\\(|@import|src *=|<link|<iframe|fetch\\(|import\\(");
        for (const Variant& variant : variants()) {
            const TraceExport trace = traceOf(variant);
            const QString page = pageOf(trace);
            const QByteArray key = keyOf(variant).toUtf8();
            const auto found = elsewhere.match(page);
            VERIFY_OR_SAY(!found.hasMatch(), key + ": " + found.captured().toUtf8());
            VERIFY_OR_SAY(page.toUtf8().size() <= mostBytes, key);
            VERIFY_OR_SAY(page.contains("<!DOCTYPE html>") && page.contains("'none'"), key);
        }
    }
    void everyStepIsOnThePage()
    {
        for (const char* key : {"cs", "lb:published", "nln", "md", "skala", "exact"}) {
            const TraceExport trace = traceOf(key);
            const QString page = pageOf(trace);
            const auto& steps = trace.narration.steps;
            QCOMPARE(page.count("<article"), qsizetype(steps.size()));
            for (std::size_t i = 0; i < steps.size(); ++i) {
                const QString article =
                    page.section("<article", int(i) + 1, int(i) + 1).section("</article>", 0, 0);
                QVERIFY(article.contains('>' + steps[i].sentence.toHtmlEscaped() + "</p>"));
                QVERIFY(article.contains(QString("data-line=\"%1\"").arg(steps[i].line)));
                QVERIFY(article.contains(QString("Step %1 of %2").arg(i + 1).arg(steps.size())));
                for (const Variable& variable : steps[i].variables)
                    QVERIFY2(article.contains("<th scope=\"row\">" + variable.name + "</th><td>"
                                              + valueText(variable).toHtmlEscaped() + "</td>"),
                             qPrintable(article));
            }
            for (const QString& line : trace.narration.code)
                QVERIFY(page.contains("<li>" + line.toHtmlEscaped() + "</li>"));
        }
    }
    /// 667 steps have no room: those in the middle are left out, and that is said.
    void aLongTraceIsShortenedAndSaysSo()
    {
        const TraceExport trace = traceOf("ms:published", {{-160, -30}, {70.1, 130.7}});
        QVERIFY(trace.narration.steps.size() > 200);
        const QString page = pageOf(trace);
        QVERIFY2(page.toUtf8().size() <= mostBytes, QByteArray::number(page.toUtf8().size()));
        QVERIFY(page.toUtf8().size() > mostBytes / 2);
        QCOMPARE(page.count("are not on this page"), 1);
        const auto count = qsizetype(trace.narration.steps.size());
        QVERIFY(page.contains("\"step-1\"") && page.contains(QString("\"step-%1\"").arg(count)));
        static const QRegularExpression leftOut("Steps (\\d+) to (\\d+) are not");
        const auto match = leftOut.match(page);
        QCOMPARE(count - page.count("<article"),
                 match.captured(2).toLongLong() - match.captured(1).toLongLong() + 1);
        QVERIFY(!pageOf(traceOf("md")).contains("are not on this page"));
    }
    void hostileTextIsShownAsText()
    {
        TraceExport trace = traceOf("md");
        const QString hostile = QStringLiteral("</script><img src=x onerror='a()'>\"&<!--");
        trace.tracedLine.origin = hostile;
        trace.tracedLine.unit = hostile;
        trace.narration.code[2] = hostile;
        for (NarratedStep& step : trace.narration.steps) {
            step.sentence = hostile;
            step.variables.front().name = hostile;
        }
        const QString page = pageOf(trace);
        QVERIFY(page.contains(hostile.toHtmlEscaped()));
        QVERIFY(!page.contains("<img") && !page.contains("<!--"));
        QCOMPARE(page.count("</script>"), 2); // the data and the script
        trace.narration.steps.clear();
        trace.narration.refusal = hostile;
        QVERIFY(!pageOf(trace).contains("<img"));
    }
    void aRefusedLineIsOneSentence()
    {
        const TraceExport trace = traceOf("md", {{std::nan(""), 0}, {std::nan(""), std::nan("")}});
        QVERIFY(!trace.narration.refusal.isEmpty());
        const QString page = pageOf(trace);
        QCOMPARE(page.count(trace.narration.refusal.toHtmlEscaped()), 1);
        QVERIFY(!page.contains("<article") && !page.contains("<nav"));
    }
    void oneStepAlone()
    {
        TraceExport trace = traceOf("md");
        trace.only = 3;
        const QString page = pageOf(trace);
        QCOMPARE(page.count("<article"), 1);
        QVERIFY(page.contains("\"step-4\""));
    }
    /// By librsvg, in the colours of the light ground.
    void theFiguresAreThoseOfOtherFormats()
    {
        const QTemporaryDir folder;
        const QSize size(480, 340);
        int compared = 0;
        for (TraceExport trace : {traceOf("cs"), traceOf("md", {{-3, 74}, {-2, 76}}),
                                  traceOf("lb", {{-170, 40}, {-20, 150}}),
                                  traceOf("cb", {{-1e9, -2e9}, {1e9, 1.5e9}})}) {
            for (std::size_t step = 0; step < trace.narration.steps.size(); step += 4) {
                const TraceStep at{trace.tracedLine, trace.narration, step};
                const QImage theirs = painted(figureSvg(at, size), size, folder.path());
                QCOMPARE(theirs.size(), size);
                const double difference = meanDifference(theirs, paintedHere(at, size));
                QVERIFY2(difference < 3, QByteArray::number(difference));
                ++compared;
            }
        }
        QVERIFY(compared > 10);
    }
    void theScriptsAreRead()
    {
        const QString node = QStandardPaths::findExecutable(QStringLiteral("node"));
        if (node.isEmpty())
            QSKIP("Node is not installed, which reads the page's scripts");
        for (const char* script : {"page", "drag", "interpreter"}) {
            const auto run = runProgram(
                node, {"--check", QString(SOURCE_DIR "/resources/trace_page/%1.js").arg(script)});
            QVERIFY2(run.code == 0, run.err);
        }
    }
    /// Bit for bit and operation for operation, in all forms that a page can run.
    void theInterpreterComputesWhatTheLibraryDoes()
    {
        const QString node = QStandardPaths::findExecutable(QStringLiteral("node"));
        if (node.isEmpty())
            QSKIP("Node is not installed, which runs the page's interpreter");
        const QTemporaryDir folder;
        QJsonArray forms;
        qsizetype runs = 0;
        for (const Variant& variant : variants()) {
            if (!isRunByPages(variant))
                continue;
            forms.append(runsOf(variant));
            runs += forms.last()["runs"].toArray().size();
        }
        QCOMPARE(forms.size(), 20);
        writeText(folder.filePath("data.json"), QJsonDocument(forms).toJson());
        const auto run = runProgram(node, {SOURCE_DIR "/tests/app/teaching/interpreter_check.js",
                                           SOURCE_DIR "/resources/trace_page/interpreter.js",
                                           folder.filePath("data.json")});
        QVERIFY2(run.code == 0, run.err);
        QCOMPARE(run.out, QByteArray::number(runs) + '\n');
    }
    /// Of the rows that need exact arithmetic or a script for each pair of regions, not.
    void onlyPagesThatCanRunTheCodeHaveItsData()
    {
        QVERIFY(pageOf(traceOf("nln")).contains("id=\"trace\">{"));
        TraceExport one = traceOf("md");
        one.only = 1;
        QVERIFY(!pageOf(one).contains("id=\"trace\""));
    }
};

} // namespace teaching_trace_page_test

TEST_CLASS(teaching_trace_page_test::TracePageTest, Gui)
#include "tests/app/teaching/trace_page_test.moc"

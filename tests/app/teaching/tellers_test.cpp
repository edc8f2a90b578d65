// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of the steps of an algorithm: every step in its own words, on a line that fits.
#include "app/teaching/page.h"
#include "app/teaching/teller.h"

#include <QRegularExpression>
#include <QTest>

#include <random>

#include "tests/clipping/inputs.h"

namespace {

using clipping::Edge;
using clipping::Form;

constexpr clipping::Window window{{-100, -75}, {100, 75}};

/// Lines of all kinds: anywhere, on the edges' lines, points, along the axes.
std::vector<clipping::Segment> lines(int count)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> anywhere(-250, 250);
    std::uniform_int_distribution<int> onGrid(-3, 3);
    std::vector<clipping::Segment> all;
    for (int i = 0; i < count; ++i) {
        const auto point = [&] {
            return i % 2 ? app::Point(anywhere(random), anywhere(random))
                         : app::Point(50 * onGrid(random), 37.5 * onGrid(random));
        };
        const auto a = point();
        all.push_back({a, point()});
    }
    return all;
}

std::vector<app::Clipper> toldClippers()
{
    std::vector<app::Clipper> all = app::clippers();
    std::erase_if(all, [](const app::Clipper& clipper) {
        return clipper.exhibit
               || std::ranges::find(app::tellers(), clipper.algorithm->key, &app::Teller::key)
                      == app::tellers().end();
    });
    return all;
}

const app::Teller& tellerOf(const app::Clipper& clipper)
{
    return *std::ranges::find(app::tellers(), clipper.algorithm->key, &app::Teller::key);
}

/// Calls of(telling) for each step of the line.
void forEachStep(const app::Clipper& clipper, const clipping::Segment& line,
                 const clipping::Window& w, app::YAxis y, const auto& of)
{
    const app::Specimen specimen{clipper, line, w, y, {}};
    const auto trace = clipping::usesOf(*clipper.algorithm, clipper.form)->trace(line, w);
    const clipping::Step* before = nullptr;
    for (const auto& step : trace.steps) {
        of(app::Telling{specimen, step, before});
        before = &step;
    }
}

QByteArray told(const app::Telling& telling, const QString& sentence)
{
    const auto& [a, b] = telling.specimen.line;
    return QStringLiteral("%1, %2 %3 to %4 %5, line %6 (%7): %8")
        .arg(app::keyOf(telling.specimen.clipper))
        .arg(a.x, 0, 'g', 17)
        .arg(a.y, 0, 'g', 17)
        .arg(b.x, 0, 'g', 17)
        .arg(b.y, 0, 'g', 17)
        .arg(telling.step.line)
        .arg(QLatin1StringView(telling.step.what.data(), qsizetype(telling.step.what.size())),
             sentence)
        .toUtf8();
}

/// What is wrong with a sentence in itself; empty: nothing.
QString fault(const QString& sentence)
{
    static const QRegularExpression placeholder(QStringLiteral("%\\d"));
    static const QRegularExpression number(QStringLiteral("\\b(nan|inf)\\b"));
    if (sentence.isEmpty() || sentence.contains(QStringLiteral("  ")))
        return QStringLiteral("something is missing");
    if (sentence.contains(placeholder) || sentence.contains(number)
        || sentence.contains(QStringLiteral("::")))
        return QStringLiteral("no words");
    if (!sentence.front().isUpper() || !(sentence.endsWith(u'.') || sentence.endsWith(u'!')))
        return QStringLiteral("no sentence");
    return {};
}

/// The sentences of a line that is clipped, y up.
QStringList sentences(const char* key, const clipping::Segment& line,
                      const clipping::Window& w = window)
{
    QStringList all;
    const auto walk =
        app::walkOf({*app::findClipper(QLatin1StringView(key)), line, w, app::YAxis::Up, {}});
    for (const auto& moment : walk.moments)
        all << QStringLiteral("%1: %2").arg(moment.line).arg(moment.sentence);
    return all;
}

void compareLists(const QStringList& actual, const QStringList& expected)
{
    for (qsizetype i = 0; i < std::min(actual.size(), expected.size()); ++i)
        QCOMPARE(actual[i], expected[i]);
    QCOMPARE(actual.size(), expected.size());
}

} // namespace

class TellersTest : public QObject {
    Q_OBJECT

private slots:
    void everyTellerHasItsAlgorithm()
    {
        for (const auto& teller : app::tellers())
            QVERIFY2(clipping::findAlgorithm(teller.key), teller.key.data());
    }

    void everyStepIsSaidInItsOwnWords()
    {
        for (const app::Clipper& clipper : toldClippers())
            for (const auto& line : lines(1'500))
                for (const auto y : {app::YAxis::Up, app::YAxis::Down})
                    forEachStep(clipper, line, window, y, [&](const app::Telling& telling) {
                        const QString sentence = tellerOf(clipper).sentence(telling);
                        const QString wrong = fault(sentence);
                        QVERIFY2(wrong.isEmpty(), told(telling, sentence));
                        QVERIFY2(sentence != app::generalSentence(telling),
                                 told(telling, sentence));
                    });
    }

    /// Numbers of any size, windows without area, lines that only touch.
    void hardCasesAreSaidInWords()
    {
        for (const app::Clipper& clipper : toldClippers())
            for (const Family& family : families()) {
                const auto inputs = family.inputs();
                for (std::size_t i = 0; i < inputs.size() && i < 300; ++i)
                    forEachStep(clipper, inputs[i].segment, inputs[i].window, app::YAxis::Up,
                                [&](const app::Telling& telling) {
                                    const QString sentence = tellerOf(clipper).sentence(telling);
                                    const QString wrong = fault(sentence);
                                    QVERIFY2(wrong.isEmpty(), told(telling, sentence));
                                });
            }
    }

    /// With y down the same numbers lie elsewhere on the screen.
    void edgesAreSaidAsTheyAreSeen()
    {
        static const QRegularExpression vertical(
            QStringLiteral("\\b(top|bottom|above|below|up|down)\\b"));
        int different = 0;
        for (const app::Clipper& clipper : toldClippers())
            for (const auto& line : lines(200)) {
                QStringList up, down;
                const auto say = [&](QStringList& into) {
                    return [&](const app::Telling& t) { into << tellerOf(clipper).sentence(t); };
                };
                forEachStep(clipper, line, window, app::YAxis::Up, say(up));
                forEachStep(clipper, line, window, app::YAxis::Down, say(down));
                const auto trace =
                    clipping::usesOf(*clipper.algorithm, clipper.form)->trace(line, window);
                for (qsizetype i = 0; i < up.size(); ++i) {
                    const Edge edge = trace.steps[std::size_t(i)].edge;
                    if ((edge == Edge::Top || edge == Edge::Bottom) && up[i].contains(vertical)) {
                        QVERIFY2(up[i] != down[i], up[i].toUtf8());
                        ++different;
                    }
                }
            }
        QVERIFY(different > 100);
    }

    /// The line of the pseudo-code that is lit says what is done.
    void linesFitTheMarks()
    {
        static const QRegularExpression assigns(QStringLiteral("=|move|exchange"));
        static const QRegularExpression asks(QStringLiteral("\\b(if|while|until|repeat)\\b"));
        for (const app::Clipper& clipper : toldClippers())
            for (const auto& line : lines(500)) {
                const auto walk = app::walkOf({clipper, line, window, app::YAxis::Up, {}});
                for (const auto& moment : walk.moments) {
                    QVERIFY(moment.line >= 1 && moment.line <= walk.code.size());
                    const QString& code = walk.code[moment.line - 1];
                    const QByteArray where =
                        QStringList{app::keyOf(clipper), code, moment.sentence}.join(u'/').toUtf8();
                    if (moment.mark == app::Mark::Accept)
                        QVERIFY2(code.contains(QStringLiteral("accept")), where);
                    else if (moment.mark == app::Mark::Reject)
                        QVERIFY2(code.contains(QStringLiteral("reject")), where);
                    else if (moment.mark == app::Mark::Cut)
                        QVERIFY2(code.contains(assigns), where);
                    else if (moment.answer)
                        QVERIFY2(code.contains(asks), where);
                }
            }
    }

    void pseudoCodeIsPlain()
    {
        for (const app::Clipper& clipper : toldClippers())
            for (const QString& code : app::pageOf(*clipper.algorithm).code)
                for (const QChar c : code)
                    QVERIFY2(c.unicode() >= 32 && c.unicode() < 127, code.toUtf8());
    }

    /// By hand: the slope is 160/230, and from x = -160 to the left edge it is 60. The picture that
    /// the microscope was drawn after has 13 steps; it leaves out that y[1] and x[2] are tested
    /// against both edges of their axis.
    void matthesDrakopoulos()
    {
        compareLists(
            sentences("md:published", {{-160, -30}, {70, 130}}),
            {"1: From x = −160 to x = 70 the line lies neither wholly left nor wholly right of the "
             "window (−100 to 100): x does not rule it out.",
             "3: From y = −30 to y = 130 the line lies neither wholly above nor wholly below the "
             "window (−75 to 75): y does not rule it out.",
             "7: End 1 lies left of the window (−160 < −100), so it has to move along the line to "
             "the left edge.",
             "8: From End 1 to the left edge it is 60 in x. For each unit of x the line goes "
             "0.695652 in y, so it goes 41.7391 in y.",
             "9: End 1 moves along the line to the left edge, to (−100, 11.7391). What lay beyond "
             "is gone.",
             "13: End 1 does not lie below the window (11.7391 > −75), so the bottom edge does not "
             "cut it.",
             "16: End 1 does not lie above the window (11.7391 < 75), so the top edge does not cut "
             "it.",
             "7: End 2 does not lie left of the window (70 > −100), so the left edge does not cut "
             "it.",
             "10: End 2 does not lie right of the window (70 < 100), so the right edge does not "
             "cut it.",
             "13: End 2 does not lie below the window (130 > −75), so the bottom edge does not cut "
             "it.",
             "16: End 2 lies above the window (130 > 75), so it has to move along the line to the "
             "top edge.",
             "17: From End 1 to the top edge it is 105 in y. For each unit of y the line goes "
             "1.4375 in x, so it goes 150.938 in x.",
             "18: End 2 moves along the line to the top edge, to (−9.0625, 75). What lay beyond is "
             "gone.",
             "19: The ends are now at x = −100 and x = −9.0625, neither both left nor both right "
             "of the window: the line has met it.",
             "21: What is left, from (−100, 11.7391) to (−9.0625, 75), lies inside the window: it "
             "is visible."});
    }
    void matthesDrakopoulosSaysWhatIsWrong()
    {
        const double u = 0x1p-52;
        const auto said =
            sentences("md:published", {{-1, 1 + 2 * u}, {3, 1 - u}}, {{0, 0}, {1, 1}});
        QVERIFY2(said.last().endsWith("this is wrong."), said.last().toUtf8());
        const auto lost =
            sentences("md:published", {{-1e-300, -1e300}, {2e-300, 1e300}}, {{0, 0}, {1, 1}});
        QVERIFY(lost.filter("The slope overflows (infinity)").size() > 0);
    }
};

QTEST_APPLESS_MAIN(TellersTest)
#include "tellers_test.moc"

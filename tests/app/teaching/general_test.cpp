// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of an algorithm without its own: the highlighted line of its pseudo-code with the
// values of its variables, computed by hand.
#include "app/teaching/sentences/code_values.h"
#include "app/teaching/teaching.h"

#include <QLocale>
#include <QTest>

#include "tests/test_class.h"

namespace teaching_general_test {

namespace {

constexpr clipping::Window window{{-100, -75}, {100, 75}};
constexpr clipping::Segment across{{-160, -30}, {70, 130}};

/// "7: Is x[i] < ...", y up.
QStringList told(const char* key, const clipping::Segment& line = across)
{
    const app::TracedLine tracedLine{
        *app::findVariant(QLatin1StringView(key)), line, window, app::YAxis::Up, {}};
    const auto& variant = tracedLine.variant;
    const auto trace = clipping::functionsOf(*variant.algorithm, variant.form)->trace(line, window);
    const app::Narration narration = app::narrationOf(tracedLine);
    QStringList all;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
        const app::SentenceContext context{tracedLine, trace.steps[i],
                                           i > 0 ? &trace.steps[i - 1] : nullptr,
                                           narration.steps[i].variables};
        all << QStringLiteral("%1: %2")
                   .arg(narration.steps[i].line)
                   .arg(app::generalSentence(context));
    }
    return all;
}

void compare(const QStringList& actual, const QStringList& expected)
{
    for (qsizetype i = 0; i < std::min(actual.size(), expected.size()); ++i)
        QCOMPARE(actual[i], expected[i]);
    QCOMPARE(actual.size(), expected.size());
}

} // namespace

class GeneralTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void questionsAndWays()
    {
        compare(told("md"),
                {"1: Is (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)? (−160 < −100 and "
                 "70 < −100) or (−160 > 100 and 70 > 100): no.",
                 "3: Is (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)? (−30 < −75 and "
                 "130 < −75) or (−30 > 75 and 130 > 75): no.",
                 "5: dx = x2 − x1 = 70 − (−160) = 230, dy = y2 − y1 = 130 − (−30) = 160.",
                 "7: moved = false.", "8: At the left edge, is xi < xmin? −160 < −100: yes.",
                 "9: At the left edge, rise = dy * (xmin − xi) / dx = 160 * (−100 − (−160)) / 230 "
                 "= 41.7391.",
                 "10: End 1 is cut at the left edge: it moves to (−100, 11.7391).",
                 "14: At the bottom edge, is rise < ymin − yi? 41.7391 < −75 − (−30): no.",
                 "17: At the top edge, is rise > ymax − yi? 41.7391 > 75 − (−30): no.",
                 "7: moved = false.", "8: At the left edge, is xi < xmin? 70 < −100: no.",
                 "11: At the right edge, is xi > xmax? 70 > 100: no.",
                 "14: At the bottom edge, is yi < ymin? 130 < −75: no.",
                 "17: At the top edge, is yi > ymax? 130 > 75: yes.",
                 "18: At the top edge, run = dx * (ymax − yi) / dy = 230 * (75 − 130) / 160 = "
                 "−79.0625.",
                 "19: End 2 is cut at the top edge: it moves to (−9.0625, 75).",
                 "20: Is (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)? (−100 < "
                 "−100 and −9.0625 < −100) or (−100 > 100 and −9.0625 > 100): no.",
                 "22: The remaining part does not change: it runs from (−100, 11.7391) to "
                 "(−9.0625, 75).",
                 "23: The remaining part, from (−100, 11.7391) to (−9.0625, 75), lies inside the "
                 "window: it is visible."});
    }
    void callsAndParameters()
    {
        const QStringList all = told("lb:published");
        compare(all.first(6),
                {"13: u0 = 0, u1 = 1, dx = x2 − x1 = 70 − (−160) = 230.",
                 "14: At the left edge, p = −dx = −230, q = x1 − xmin = −160 − (−100) = −60.",
                 "2: At the left edge, is p < 0? −230 < 0: yes.",
                 "3: At the left edge, r = q/p = −60/(−230) = 0.26087.",
                 "4: At the left edge, is r > u1? 0.26087 > 1: no.",
                 "5: At the left edge, is r > u0? 0.26087 > 0: yes."});
        QVERIFY(all.contains("22: End 1 is cut at the left edge: it moves to (−100, 11.7391)."));
    }
    void outcodes()
    {
        const QStringList all = told("cs:published");
        QCOMPARE(all[1], "3: Is code1 | code2 == 0000? 0001 | 1000 == 0000: no.");
        QVERIFY2(all.filter("is codeOut & TOP != 0000? 1000 & TOP != 0000: yes.").size() == 1,
                 qPrintable(all.join('\n')));
    }
    /// A formula that changes a variable shows the value before.
    void valuesAreThoseBefore()
    {
        // The line turned round: dy = 160, the window is 200 wide, and e was 160 * 60 - 230 * 105.
        const QStringList all = told("sb:published", {across.b, across.a});
        QVERIFY2(all.contains("31: e = e + dy*(xmax − xmin) = −14550 + 160*(100 − (−100)) = "
                              "17450, c = c + 1 = 3 + 1 = 4."),
                 qPrintable(all.join('\n')));
    }
    /// In a plane that the algorithm has turned, window and line have their values in that plane.
    void aTurnedPlaneHasItsOwnWindow()
    {
        // Turned by three quarters: (x, y) becomes (-y, x).
        const QStringList all = told("nln:published", {{-30, 200}, {40, -70}});
        for (const char* said : {"51: xmin = −ymax = −75, ymax = xmax = 100, xmax = −ymin = −(−75) "
                                 "= 75, ymin = xmin = −100.",
                                 "33: At the top edge, is x2 < xmin? 70 < −75: no."})
            QVERIFY2(all.contains(said), qPrintable(all.join('\n')));
        QVERIFY(told("nln", {{200, -30}, {-70, 40}})
                    .contains("8: At the right edge, is x2 < xmin? 70 < −100: no."));
    }
    /// "x[k]" is the coordinate of the end that k numbers.
    void indexedNames()
    {
        const app::TracedLine tracedLine{app::exactVariant(), across, window, app::YAxis::Up, {}};
        const clipping::Step step{};
        const std::vector<app::Variable> variables{
            {"i", 1}, {"k", 2}, {"x[1]", 5}, {"x[2]", 7}, {"X[k]", 9}};
        const app::SentenceContext context{tracedLine, step, nullptr, variables};
        const app::CodeValues values(context, {});
        QCOMPARE(app::filledIn("x[k] - x[i] < X[k] + y[n] * xi", values),
                 "7 − 5 < 9 + y[n] * (−160)");
    }
    /// Two numbers that differ only in a late digit are shown with all digits.
    void digitsTellNumbersApart()
    {
        const double x = std::nextafter(-100.0, -200.0);
        const QStringList all = told("md", {{x, 0}, {0, 0}});
        QVERIFY2(all.contains("8: At the left edge, is xi < xmin? −100.00000000000001 < −100: "
                              "yes."),
                 qPrintable(all.join('\n')));
    }
    void rejections()
    {
        QCOMPARE(told("md", {{-200, 0}, {-150, 50}}).last(),
                 "2: The line is rejected: nothing is visible.");
        const QString lost = told("kwc:published", {{100, 0}, {100.5, 300}}).last();
        QVERIFY2(lost.startsWith("16: The line is rejected: nothing is visible. That is "
                                 "wrong: "),
                 qPrintable(lost));
    }
};

} // namespace teaching_general_test

TEST_CLASS(teaching_general_test::GeneralTest, None)
#include "tests/app/teaching/general_test.moc"

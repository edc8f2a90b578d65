// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a line of pseudo-code: condition, assignments, calls.
#include "app/teaching/code_line.h"

#include <QTest>

#include "tests/test_class.h"

namespace teaching_code_line_test {

namespace {

QStringList assignments(const char* line, const QStringList& code = {})
{
    QStringList all;
    for (const app::Assignment& one : app::assignmentsIn(line, code))
        all << one.name + " <- " + one.formula;
    return all;
}

/// -5 for every name.
QString minusFive(const QString&) { return QStringLiteral("\u22125"); }

} // namespace

class CodeLineTest : public QObject {
    Q_OBJECT

private slots:
    void conditionsStandAlone()
    {
        QCOMPARE(app::conditionIn("  if x1 < xmin"), "x1 < xmin");
        QCOMPARE(app::conditionIn("else if x1 < xmin: reject"), "x1 < xmin");
        QCOMPARE(app::conditionIn("if (moved ? rise < ymin-yi : yi < ymin)"),
                 "(moved ? rise < ymin-yi : yi < ymin)");
        QCOMPARE(app::conditionIn("if u0 > u1: x1 = x2,  y1 = y2"), "u0 > u1");
        QCOMPARE(app::conditionIn("until code1 == 0000"), "code1 == 0000");
        QCOMPARE(app::conditionIn("notL(): if x[i] < xmin: reject"), "x[i] < xmin");
        QCOMPARE(app::conditionIn("test(p, q): while p < q"), "p < q");
        for (const char* line : {"else", "reject", "x1 = xmin", "repeat", "for i = 1, 2"})
            QCOMPARE(app::conditionIn(line), "");
    }
    void assignmentsGoFromLeftToRight()
    {
        QCOMPARE(assignments("  x[i] = xmin,  y[i] = rise + y1"),
                 (QStringList{"x[i] <- xmin", "y[i] <- rise + y1"}));
        QCOMPARE(assignments("if a <= b: c = d,  e = max(f, g)"),
                 (QStringList{"c <- d", "e <- max(f, g)"}));
        QCOMPARE(assignments("else x1 = x2"), QStringList{"x1 <- x2"});
        QCOMPARE(assignments("L(): way[i] = dy / dx,  y = yi"),
                 (QStringList{"way[i] <- dy / dx", "y <- yi"}));
        QCOMPARE(assignments("turn(p): if p < 0: q = -p"), QStringList{"q <- -p"});
        for (const char* line : {"if x1 < xmin", "if a == b", "reject", "hold new ends inside"})
            QCOMPARE(assignments(line), QStringList());
    }
    void callsSetTheirParameters()
    {
        const QStringList code{"clipt(p, q):", "  if p < 0", "if clipt(-dx, max(x1, xmin)-x2)"};
        QCOMPARE(assignments("if clipt(-dx, max(x1, xmin)-x2)", code),
                 (QStringList{"p <- -dx", "q <- max(x1, xmin)-x2"}));
        QCOMPARE(assignments("clipt(p, q):", code), QStringList());
        QCOMPARE(assignments("reclipt(dx, dy)", code), QStringList());
        QCOMPARE(assignments("if reclipt(dx) < clipt(dy, 2)", code),
                 (QStringList{"p <- dy", "q <- 2"}));
    }
    void namesStandForValues()
    {
        QCOMPARE(app::namesIn("abs(x[1]-x2) < 1 and not (code1 & TOP) == 0000"),
                 (QStringList{"x[1]", "x2", "code1"}));
    }
    void numbersTakeTheirPlaces()
    {
        QCOMPARE(app::withTexts("dy*(xmin-x1) / dx", minusFive), "−5*(−5 − (−5)) / (−5)");
        QCOMPARE(app::withTexts("-dx", minusFive), "−(−5)");
        QCOMPARE(app::withTexts("2*u+1 <= min(p, q)", minusFive), "2*(−5) + 1 <= min(−5, −5)");
        QCOMPARE(app::withTexts("x1", [](const QString& name) { return name; }), "x1");
    }
};

} // namespace teaching_code_line_test

TEST_CLASS(teaching_code_line_test::CodeLineTest, None)
#include "tests/app/teaching/code_line_test.moc"

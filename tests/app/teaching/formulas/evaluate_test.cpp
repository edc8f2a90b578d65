// SPDX-License-Identifier: GPL-3.0-or-later
// Formulas of the pseudo-code are read and evaluated as they are meant.
#include "app/teaching/formulas/reader.h"

#include <QTest>

#include "tests/app/teaching/formulas/checker.h"
#include "tests/app/teaching/formulas/exact_functions.h"
#include "tests/test_class.h"

namespace teaching_formulas_evaluate_test {

using namespace app::formulas;

namespace {

const clipping::Segment segment{{1, 2}, {30, 40}};
const clipping::Window window{{5, 6}, {7, 8}};

/// A formula, and what it is evaluated with: u is of the right edge, n is an outcode.
struct Given {
    explicit Given(const char* formula)
    {
        const std::set<std::string> loops{"i"};
        Reader reader(formula, names, loops);
        expression = reader.expression();
        if (!reader.atEnd())
            reader.fail("The end");
        const int i = names.slotOf("i"), indexed = names.slotOf("x[2]"), u = names.slotOf("u"),
                  n = names.slotOf("n");
        scope.emplace(names, segment, window);
        scope->exact = &exactFunctions;
        scope->set(i, 2), scope->set(indexed, 9), scope->set(u, 0.5), scope->set(n, 5);
        scope->setEdge(u, clipping::Edge::Right);
        scope->setIsNumber(n, false), scope->setIsNumber(i, false);
    }
    Names names;
    Expression expression;
    std::optional<Scope> scope;
};

double valueOf(const char* formula, clipping::Edge edge = clipping::Edge::NoEdge, int axis = -1)
{
    Given given(formula);
    given.scope->edge = edge, given.scope->axis = axis;
    return app::formulas::valueOf(given.expression, *given.scope);
}

} // namespace

class EvaluateTest : public QObject {
    Q_OBJECT

private slots:
    void values_data()
    {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<double>("value");
        const auto row = [](const char* formula, double value) {
            QTest::newRow(formula) << QString(formula) << value;
        };
        row("1 + 2 * 3", 7), row("(1 + 2) * 3", 9), row("8 - 4 - 2", 2), row("8 / 4 / 2", 1);
        row("2 - -3", 5), row("-x1*y2", -40), row("-(1 - 3)", 2), row("0.1 + 0.2", 0.1 + 0.2);
        row("1 < 2", 1), row("2 < 2", 0), row("2 <= 2", 1), row("2 >= 3", 0), row("3 > 2", 1);
        row("1 + 1 == 2", 1), row("1 != 1", 0), row("1 / 0 > 5", 1), row("0/0 == 0/0", 0);
        row("true or true and false", 1), row("(true or true) and false", 0);
        row("not 1 > 2", 1), row("not true or true", 1), row("not (true or true)", 0);
        row("false and unknown", 0), row("true or unknown", 1);
        row("1 ? 2 : unknown", 2), row("0 ? unknown : 3", 3), row("1 ? 0 ? 4 : 5 : 6", 5);
        row("1 < 2 ? 3 + 4 : 0", 7), row("0 ? 1 : 0 ? 2 : 3", 3);
        row("1010 | 0101", 15), row("1010 & 0110", 2), row("1000 | 0110 & 0010", 10);
        row("1000 & 0100 == 0000", 1), row("1100 & ~1000", 4), row("TOP | LEFT", 9);
        row("1000 == TOP", 1), row("0010 == RIGHT", 1), row("0100 == BOTTOM", 1), row("10", 10);
        row("outcode(0, 0)", 5), row("outcode(5, 8)", 0), row("outcode(9, 9)", 10);
        row("min(2, 1) + max(3, 4)", 5), row("abs(-2) + abs(3)", 5);
        row("yAt(15.5)", 21), row("xAt(21)", 15.5), row("order(15.5, 21)", 0);
        row("order(5, 21)", -1), row("order(20, 21)", 1);
        row("sign(-3)", -1), row("sign(0)", 0), row("sign(0.1)", 1);
        row("atEdge(u)", 1), row("atEdge(n)", 0), row("vertical(u)", 1), row("edge(u)", 7);
        row("x[i]", 9), row("x[1 + 1]", 9), row("xi", 30), row("yi - y1", 38), row("xmin*ymax", 40);
    }
    void values()
    {
        QFETCH(QString, formula);
        QFETCH(double, value);
        const double found = valueOf(qPrintable(formula));
        QVERIFY2(same(found, value), qPrintable(QString::number(found, 'g', 17)));
    }

    void heldClampsToTheWindow()
    {
        using clipping::Edge;
        QCOMPARE(valueOf("held(1)", Edge::Right, 0), 5.0); // the edge of a step does not matter
        QCOMPARE(valueOf("held(1)", Edge::Right, 1), 6.0);
        QCOMPARE(valueOf("held(7.5)", Edge::Right, 1), 7.5);
        QCOMPARE(valueOf("held(9)", Edge::Top, 0), 7.0);
        QVERIFY_THROWS_EXCEPTION(Unreadable, valueOf("held(1)"));
    }

    /// What a reader of the text would count.
    void operations_data()
    {
        QTest::addColumn<QString>("formula");
        QTest::addColumn<int>("additions");
        QTest::addColumn<int>("multiplications");
        QTest::addColumn<int>("comparisons");
        const auto row = [](const char* formula, int additions, int multiplications,
                            int comparisons) {
            QTest::newRow(formula)
                << QString(formula) << additions << multiplications << comparisons;
        };
        row("x1 + y1*x2 - 1", 2, 1, 0);
        row("x1 > y1 or x1 > y2", 0, 0, 2);            // 1 > 2, 1 > 40
        row("x1 < y1 or x1 + 1 > y2", 0, 0, 1);        // the first decides
        row("x1 > y1 and x1*y1 > 0", 0, 0, 1);         // again
        row("x1 < y1 ? x1*y1 : x1 + y1", 0, 1, 1);     // one alternative
        row("n == 0000 or n & 0001 != 0000", 0, 0, 0); // no numbers
        row("16*n + i", 0, 0, 0);
        row("n == 0 ? x1 + 1 : x1*2*y1", 0, 2, 0);
        row("edge(u) + 1", 1, 0, 0);
        row("vertical(u) ? 1 : x1*y1", 0, 0, 0);
        row("sign(x1 - y1) == 1", 1, 0, 1);
    }
    void operations()
    {
        QFETCH(QString, formula);
        QFETCH(int, additions);
        QFETCH(int, multiplications);
        QFETCH(int, comparisons);
        const Given given(qPrintable(formula));
        clipping::OperationCounts found;
        app::formulas::valueOf(given.expression, *given.scope, &found);
        QCOMPARE(found.additions, std::uint64_t(additions));
        QCOMPARE(found.multiplications, std::uint64_t(multiplications));
        QCOMPARE(found.comparisons, std::uint64_t(comparisons));
    }

    void exactFunctionsAreLent()
    {
        for (const char* formula : {"yAt(1)", "xAt(2)", "order(1, 2)", "side(1, 2)"}) {
            Given given(formula);
            app::formulas::valueOf(given.expression, *given.scope);
            given.scope->exact = nullptr;
            QVERIFY_THROWS_EXCEPTION(Unreadable,
                                     app::formulas::valueOf(given.expression, *given.scope));
        }
    }

    void errors_data()
    {
        QTest::addColumn<QString>("formula");
        for (const char* formula : {"unknown", "1 +", "(1", "1 2", "x[1", "x[20]", "f(1)", "min(1)",
                                    "1 ? 2", "", "+ 1", "1 < 2 < 3", "a = 1", "x[1] + 1", "1 # 2",
                                    "0.5 | 1", "-1 & 1", "edge(x1)", "vertical(n)"})
            QTest::newRow(formula) << QString(formula);
    }
    void errors()
    {
        QFETCH(QString, formula);
        QVERIFY_THROWS_EXCEPTION(Unreadable, valueOf(qPrintable(formula)));
    }

    void lines()
    {
        const Code code = read("if x1 < xmin and y1 < ymin: reject\n"
                               "for i = 1, 2\n"
                               "  if f(-x1, xi*2): reject\n"
                               "  u[i] = xi,  v = -x1 + y1/2\n"
                               "f(p, q):\n"
                               "  else if p > q: p = outcode(x1, y1)\n"
                               "accept the line from x[1], y[1] to x[2], y[2]");
        QCOMPARE(code.lines.size(), 7U);
        QVERIFY(code.lines[0].condition && code.lines[0].rejects && !code.lines[0].accepts);
        QCOMPARE(code.lines[0].mostOperations.comparisons, 2U);
        QCOMPARE(code.lines[2].calls.size(), 1U);
        QCOMPARE(code.lines[2].mostOperations, (clipping::OperationCounts{0, 1, 0, 0, 1}));
        QCOMPARE(code.lines[3].assignments.size(), 2U);
        QCOMPARE(code.lines[3].mostOperations, (clipping::OperationCounts{1, 0, 1, 0, 1}));
        QCOMPARE(code.lines[4].definition->variables.size(), 2U);
        QCOMPARE(code.lines[5].mostOperations.comparisons, 5U);
        QCOMPARE(code.names.at(code.ends[3]), std::string("y[2]"));
        QCOMPARE(formulasOf(code).size(), 6U); // copies and x[1] ... y[2] are none
    }

    void unreadableLinesAreRefused_data()
    {
        QTest::addColumn<QString>("line");
        for (const char* line : {"if", "x1", "x1 = ", "x1 = 1 y1 = 2", "reject it", "g(1)",
                                 "for i in 1, 2", "accept the line from x1, y1", "1 = x1",
                                 "if x1 < 1: 5", "f(p): q", "x1 = 1;", "else x1 = 1"})
            QTest::newRow(line) << QString(line);
    }
    void unreadableLinesAreRefused()
    {
        QFETCH(QString, line);
        QVERIFY_THROWS_EXCEPTION(Unreadable, read(line.toStdString()));
    }
};

} // namespace teaching_formulas_evaluate_test

TEST_CLASS(teaching_formulas_evaluate_test::EvaluateTest, Core)
#include "tests/app/teaching/formulas/evaluate_test.moc"

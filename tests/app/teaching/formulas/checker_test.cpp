// SPDX-License-Identifier: GPL-3.0-or-later
// A run that says what its pseudo-code says has no fault; each thing that it says otherwise is one.
#include <QTest>

#include <functional>

#include "tests/app/teaching/formulas/checker.h"
#include "tests/test_class.h"

namespace teaching_formulas_checker_test {

using namespace app::formulas;
using clipping::Edge;
using clipping::Step;
using clipping::What;

namespace {

constexpr const char* code = "dx = x2-x1,  half = dx/2  #half\n"
                             "for i = 1, 2\n"
                             "  moved = false\n"
                             "  if move(dx*2, xi): reject  #move\n"
                             "  x[i] = held(x1 - dx),  y[i] = held(y1)  #ends\n"
                             "move(p, q):\n"
                             "  if p < q and not moved  #asks\n"
                             "    reject  #reject\n"
                             "    give up after a while\n"
                             "hold the ends inside the window  #hold\n"
                             "for each edge, of normal nx\n"
                             "accept the line from x[1], y[1] to x[2], y[2]  #accept\n";
const clipping::Segment given{{-3, 1}, {5, 1}};
const clipping::Window window{{0, 0}, {4, 4}};
const clipping::Segment cut{{0, 1}, {5, 1}}, held{{0, 1}, {4, 1}};

/// A run without fault.
std::vector<Step> goodRun()
{
    return {
        {What::Let,
         false,
         "half",
         "half",
         given,
         Edge::NoEdge,
         {{"dx", 8}, {"half", 4}},
         {1, 0, 1, 0, 0}},
        {What::Let,
         false,
         "q",
         "move",
         given,
         Edge::NoEdge,
         {{"i", 1}, {"xi", -3}, {"moved", 0}, {"p", 16}, {"q", -3}},
         {1, 1, 1, 0, 0}},
        {What::Test, false, "", "asks", given, Edge::NoEdge, {}, {1, 1, 1, 1, 0}},
        {What::Cut, false, "", "ends", cut, Edge::Left, {}, {2, 1, 1, 4, 0}},
        {What::Let, false, "left", "hold", held, Edge::NoEdge, {{"nx", -1}}, {2, 1, 1, 9, 0}},
        {What::Accept, false, "", "accept", held, Edge::NoEdge, {}, {2, 1, 1, 9, 0}},
    };
}

/// In the plane turned to the left the given line comes from (-1, -3) to (-1, 5), and the window's
/// top is its left edge.
constexpr const char* turningCode = "if y1 < ymax: turn f(-ymax, xmax, -ymin, xmin)  #turn\n"
                                    "accept the line from x1, y1 to x2, y2  #accept\n"
                                    "f(xmin, ymax, xmax, ymin):\n"
                                    "  y1 = ymin,  x1 = held(x1)  #cut\n";
std::vector<Step> turningRun()
{
    const std::vector<clipping::NamedValue> inside{{"ymax", 4}, {"xmax", -0.0}, {"ymin", 0},
                                                   {"x1", -1},  {"y2", 5},      {"xmin", -4}};
    return {
        {What::Test, true, "", "turn", given, Edge::Top, {}, {0, 0, 0, 1, 0}},
        {What::Let, false, "xmin", "turn", given, Edge::NoEdge, inside, {0, 0, 0, 1, 4}},
        {What::Cut, false, "", "cut", cut, Edge::Left, {{"y1", 0}}, {0, 0, 0, 3, 4}},
        {What::Let,
         false,
         "left",
         "turn",
         cut,
         Edge::NoEdge,
         {{"x1", 0}, {"ymax", 4}},
         {0, 0, 0, 3, 6}},
        {What::Accept, false, "", "accept", cut, Edge::NoEdge, {}, {0, 0, 0, 3, 6}},
    };
}

std::optional<Fault> faultOf(const std::vector<Step>& steps,
                             clipping::OperationCounts operations = {2, 1, 1, 9, 0},
                             const char* text = code)
{
    const Code parsed = read(text);
    Checker checker(parsed);
    return checker.check(given, window, {steps, clipping::Outcome::Visible, held}, operations);
}

} // namespace

class CheckerTest : public QObject {
    Q_OBJECT

private slots:
    void noFault()
    {
        const auto fault = faultOf(goodRun());
        QVERIFY2(!fault, fault ? text(*fault).c_str() : "");
    }

    void faults_data()
    {
        using Change = std::function<void(std::vector<Step>&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<int>("line");
        const auto row = [](const char* name, int line, const Change& change) {
            QTest::newRow(name) << change << line;
        };
        row("a value", 1, [](auto& s) { s[0].values[1].value = 4.5; });
        row("a second value", 1, [](auto& s) { s[0].values[0].value = 8.5; });
        row("a zero's sign", 4, [](auto& s) { s[1].values[2].value = -0.0; });
        row("a name", 1, [](auto& s) { s[0].values[1].name = "third"; });
        row("a value of another line", 4, [](auto& s) { s[1].values.push_back({"half", 5}); });
        row("a turn of the loop", 4, [](auto& s) { s[1].values[0].value = 3; });
        row("a given end", 4, [](auto& s) { s[1].values[1].value = 5; });
        row("a normal", 10, [](auto& s) { s[4].values[0].value = 2; });
        row("an argument", 4, [](auto& s) { s[1].values[3].value = 17; });
        row("a variable that the line has not", 4, [](auto& s) { s[1].name = "moved"; });
        row("a condition", 7, [](auto& s) { s[2].holds = true; });
        row("no condition", 8, [](auto& s) { s[2].label = "reject"; });
        row("no such label", 0, [](auto& s) { s[2].label = "ask"; });
        row("no label", 0, [](auto& s) { s[2].label = ""; });
        row("an end", 5, [](auto& s) { s[3].segment.a.x = 1; });
        row("the other end", 5, [](auto& s) { s[3].segment.b.y = 2; });
        row("an edge", 5, [](auto& s) { s[3].edge = Edge::Right; });
        row("an end moves in a test", 7, [](auto& s) { s[2].segment = cut; });
        row("a line that cuts nothing", 1, [](auto& s) { s[3].label = "half"; });
        row("an end outside the window", 10, [](auto& s) { s[4].segment = cut; });
        row("another segment is accepted", 12, [](auto& s) { s[5].segment = given; });
        row("no accept", 7, [](auto& s) { s[5].label = "asks"; });
        row("no reject", 12, [](auto& s) { s[5].what = What::Reject; });
        row("no give up", 12, [](auto& s) { s[5].what = What::GiveUp; });
        row("an addition", 7, [](auto& s) { s[2].cost.additions = 2; });
        row("a multiplication", 7, [](auto& s) { s[2].cost.multiplications = 2; });
        row("a division", 7, [](auto& s) { s[2].cost.divisions = 2; });
        row("a comparison", 7, [](auto& s) { s[2].cost.comparisons = 2; });
        row("a change of sign", 7, [](auto& s) { s[2].cost.negations = 1; });
        row("no addition", 1, [](auto& s) { s[0].cost.additions = 0; });
        row("no multiplication", 4, [](auto& s) { s[1].cost.multiplications = 0; });
        row("no division", 1, [](auto& s) { s[0].cost.divisions = 0; });
        row("no comparison", 7, [](auto& s) { s[2].cost.comparisons = 0; });
        row("no addition in a function", 5, [](auto& s) { s[3].cost.additions = 1; });
        row("operations after the last step", 12, [](auto& s) { s[5].cost.comparisons = 8; });
        row("no step of a value", 7, [](auto& s) { s[1].values.resize(4), s[1].name = "p"; });
    }
    void faults()
    {
        QFETCH(std::function<void(std::vector<Step>&)>, change);
        QFETCH(int, line);
        auto steps = goodRun();
        change(steps);
        const auto fault = faultOf(steps);
        QVERIFY(fault.has_value());
        QVERIFY2(fault->line == line, text(*fault).c_str());
    }

    void noFaultInATurnedPlane()
    {
        const auto fault = faultOf(turningRun(), {0, 0, 0, 3, 6}, turningCode);
        QVERIFY2(!fault, fault ? text(*fault).c_str() : "");
    }
    void faultsInATurnedPlane_data()
    {
        using Change = std::function<void(std::vector<Step>&)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<int>("line");
        const auto row = [](const char* name, int line, const Change& change) {
            QTest::newRow(name) << change << line;
        };
        row("an edge of the window", 1, [](auto& s) { s[1].values[0].value = 0; });
        row("an end", 1, [](auto& s) { s[1].values[3].value = 1; });
        row("the picture is turned", 1, [](auto& s) { s[1].segment = cut; });
        row("a change of sign", 1, [](auto& s) { s[1].cost.negations = 5; });
        row("a cut of the picture", 4, [](auto& s) { s[2].segment = held; });
        row("a cut end", 4, [](auto& s) { s[2].values[0].value = 1; });
        row("the edge of a cut", 4, [](auto& s) { s[2].edge = Edge::Top; });
        row("an end that is turned back", 1, [](auto& s) { s[3].values[0].value = -1; });
        row("an edge that is turned back", 1, [](auto& s) { s[3].values[1].value = 0; });
        row("another line turns back", 2, [](auto& s) { s[3].label = "accept"; });
        row("never turned back", 2, [](auto& s) { s.erase(s.begin() + 3); });
        row("turned back twice", 1, [](auto& s) { s.insert(s.begin() + 4, s[3]); });
    }
    void faultsInATurnedPlane()
    {
        QFETCH(std::function<void(std::vector<Step>&)>, change);
        QFETCH(int, line);
        auto steps = turningRun();
        change(steps);
        const auto fault = faultOf(steps, {0, 0, 0, 3, 6}, turningCode);
        QVERIFY(fault.has_value());
        QVERIFY2(fault->line == line, text(*fault).c_str());
    }
    /// No step would tell the window of such a call.
    void anotherWindowWithoutATurn()
    {
        for (const char* arguments : {"(xmin, 1)", "(xmax, xmin)", "(-xmax, -xmin)"}) {
            const std::string call = std::string("f") + arguments;
            const std::string definition = "\nf(xmin, xmax):\n  dx = xmax-xmin\n";
            const std::string plain = call + definition;
            QVERIFY(read("turn " + plain).lines.size() == 3);
            QVERIFY_THROWS_EXCEPTION(Unreadable, read(plain));
        }
        QVERIFY(read("f(xmin, xmax)\nf(xmin, xmax):\n").lines.size() == 2);
    }

    void theReport()
    {
        auto steps = goodRun();
        steps[0].values[1].value = 4.5;
        QCOMPARE(text(*faultOf(steps)).c_str(),
                 "line 1: dx = x2-x1,  half = dx/2\n"
                 "  variables: x1 = -3, y1 = 1, x2 = 5, y2 = 1, xmin = 0, ymin = 0, xmax = 4, "
                 "ymax = 4, dx = 8, x[1] = -3, x[2] = 5, y[1] = 1, y[2] = 1\n"
                 "  found: half = 4\n"
                 "  told: 4.5");
    }

    void notEvaluated()
    {
        const Code parsed = read(code);
        Checker checker(parsed);
        QCOMPARE(checker.notEvaluated().size(), 6U); // dx, half, dx*2, two held ends, a condition
        auto steps = goodRun();
        steps.resize(3);
        QVERIFY(!checker.check(given, window, {steps, {}, {}}, {1, 1, 1, 1, 0}));
        const auto left = checker.notEvaluated();
        QCOMPARE(left.size(), 2U);
        QCOMPARE(left[0].line, 5U);
    }
};

} // namespace teaching_formulas_checker_test

TEST_CLASS(teaching_formulas_checker_test::CheckerTest, Core)
#include "tests/app/teaching/formulas/checker_test.moc"

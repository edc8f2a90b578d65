// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_exact_lines_test {

using namespace tasks;

// Tasks 1 to 6 of README.md.
class ExactLinesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void wall()
    {
        check({key("L"), type("20,30"), enter(), type("3450"), tab(), type("90"), enter()},
              {{{{20, 30}, {20, 30 - 3450}}}});
    }
    void chain()
    {
        const double x = 30 * std::sqrt(0.5);
        check({key("L"), type("10,20"), enter(), type("40,0"), enter(), type("#50,60"), enter(),
               type("30<45"), enter(), type("@0,-5"), enter()},
              {{{{10, 20}, {50, 20}}},
               {{{50, 20}, {50, 60}}},
               {{{50, 60}, {50 + x, 60 - x}}},
               {{{50 + x, 60 - x}, {50 + x, 55 - x}}}});
    }
    void units()
    {
        check({key("L"), type("10,80"), enter(), type("1in+4.6"), tab(), type("90"), enter(),
               enter(), type("90,40"), enter(), type("(210-40)/2"), tab(), type("180"), enter()},
              {{{{10, 80}, {10, 50}}}, {{{90, 40}, {5, 40}}}});
    }
    void correction()
    {
        check({key("L"), type("10,20"), enter(), type("30,0"), enter(), enter(),
               drag({25, 20}, {25.5, 60}, Qt::ShiftModifier), type("<-30"), enter(), type("60"),
               enter()},
              {{{{10, 20}, {40, 20}}}, {{{25, 20}, {25 + 30 * std::sqrt(3), 50}}}});
    }
    void stairs()
    {
        Table steps;
        for (int i = 0; i < 7; ++i) {
            const app::Point at(20 + 290 * i, 190 - 170 * i);
            steps.push_back({{at, at + app::Point(0, -170), at + app::Point(290, -170)}});
        }
        check({key("P"), type("20,190"), enter(), move({20.2, 100}), type("170"), enter(),
               move({90, 20.2}), type("290"), enter(), key("G"), key("C"), type("290,-170"),
               enter(), type("6x"), enter()},
              steps);
    }
    /// Twelve walls, counted in README.md. The doors are left open while drawing; copies of a wall
    /// have its door.
    void housePlan()
    {
        Steps steps{key("L")};
        // A wall goes where the pointer is, as far as is typed.
        const auto wall = [&](const app::Point& aim, const char* length) {
            add(steps, {move(aim), type(length), enter()});
        };
        const auto begin = [&](const char* point) { add(steps, {type(point), enter()}); };
        begin("20,20");
        add(steps, {type("160"), enter()}); // to the right, until the pointer says otherwise
        wall({180.3, 90}, "120");
        wall({150, 140.3}, "68");
        add(steps, {enter()});
        begin("92,140");
        wall({50, 140.3}, "72");
        wall({20.3, 90}, "120");
        add(steps, {enter()});
        begin("26,26");
        wall({100, 26.3}, "148");
        wall({174.3, 80}, "108");
        wall({150, 134.3}, "62");
        add(steps, {enter()});
        begin("92,134");
        wall({50, 134.3}, "66");
        wall({26.3, 90}, "108");
        add(steps, {enter()});
        begin("65,26");
        wall({65.3, 40}, "24");
        add(steps, {enter()});
        begin("65,68");
        wall({65.3, 100}, "66");
        add(steps, {enter()});
        begin("137,80");
        wall({150, 80.3}, "37");
        add(steps, {key("V"), click({65, 35}), click({65, 100}, Qt::ShiftModifier), key("G"),
                    key("C"), type("36,0"), enter(), type("2x"), enter()});
        Table table{{{{20, 20}, {180, 20}}},    {{{180, 20}, {180, 140}}},
                    {{{180, 140}, {112, 140}}}, {{{92, 140}, {20, 140}}},
                    {{{20, 140}, {20, 20}}},    {{{26, 26}, {174, 26}}},
                    {{{174, 26}, {174, 134}}},  {{{174, 134}, {112, 134}}},
                    {{{92, 134}, {26, 134}}},   {{{26, 134}, {26, 26}}}};
        for (const double x : {65.0, 101.0, 137.0}) {
            table.push_back({{{x, 26}, {x, 50}}});
            table.push_back({{{x, 68}, {x, 134}}});
        }
        table.insert(table.begin() + 12, {{{137, 80}, {174, 80}}});
        QCOMPARE(table.size(), std::size_t(2 * 5 + 6 + 1));
        check(steps, table);
    }
};

} // namespace tasks_exact_lines_test

TEST_CLASS(tasks_exact_lines_test::ExactLinesTest, Widgets)
#include "tests/ui/tasks/exact_lines_test.moc"

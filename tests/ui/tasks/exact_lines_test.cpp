// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/tasks/player.h"

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
               drag({40, 20}, {40.5, 60}, Qt::ShiftModifier), type("<-30"), enter(), type("60"),
               enter()},
              {{{{10, 20}, {40, 20}}}, {{{40, 20}, {40 + 30 * std::sqrt(3), 50}}}});
    }
    void stairs()
    {
        Table steps;
        for (int i = 0; i < 7; ++i) {
            const app::Point at(20 + 290 * i, 190 - 170 * i);
            steps.push_back({{at, at + app::Point(0, -170), at + app::Point(290, -170)}});
        }
        check({key("P"), type("20,190"), enter(), type("0,-170"), enter(), type("290,0"), enter(),
               key("G"), key("C"), type("290,-170"), enter(), type("6x"), enter()},
              steps);
    }
};

QTEST_MAIN(ExactLinesTest)
#include "exact_lines_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_transforms_test {

using namespace tasks;

// Tasks of README.md about moving, rotating, scaling and arranging.
class TransformsTest : public QObject {
    Q_OBJECT

    static Table boxes(std::initializer_list<clipping::Window> boxes)
    {
        Table table;
        for (const clipping::Window& w : boxes)
            table.push_back({{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}, true});
        return table;
    }
    /// Draws a rectangle from a typed corner.
    static void rectangle(Steps& steps, const char* corner, const char* width, const char* height)
    {
        const Steps more{key("R"), type(corner), enter(), type(width),
                         tab(),    type(height), enter()};
        steps.insert(steps.end(), more.begin(), more.end());
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void sheetBorder()
    {
        check({key("R"), type("10,10"), enter(), type("190"), tab(), type("277"), enter()},
              boxes({{{10, 10}, {200, 287}}}));
    }
    void star()
    {
        const double step = std::numbers::pi / 6;
        Table rays;
        for (int i = 0; i < 6; ++i) {
            const app::Point arm(-20 * std::sin(i * step), -20 * std::cos(i * step));
            rays.push_back({{app::Point(60, 50) - arm, app::Point(60, 50) + arm}});
        }
        check({key("L"), type("60,70"), enter(), type("40"), tab(), type("90"), enter(), key("O"),
               key("C"), type("30"), enter(), type("5x"), enter()},
              rays);
    }
    void holeCircle()
    {
        Steps steps{key("E"),    type("10,10"), enter(),
                    type("80"),  enter(),       click({50.3, 10.4}, Qt::AltModifier),
                    type("6.6"), enter()};
        const Steps more{key("O"), move({50.3, 50.2}), key("P"), key("C"), type("60"),
                         enter(),  type("5x"),         enter()};
        steps.insert(steps.end(), more.begin(), more.end());
        Table circles{circle({50, 50}, 40)};
        for (int i = 0; i < 6; ++i) {
            const double angle = glm::radians(90.0 + 60 * i);
            circles.push_back(circle({50 + 40 * std::cos(angle), 50 - 40 * std::sin(angle)}, 3.3));
        }
        check(steps, circles);
    }
    void labels()
    {
        Steps steps;
        rectangle(steps, "10,10", "30", "15");
        const Steps more{key("Ctrl+Shift+D"), type("4"), tab(),     type("5"), tab(),
                         type("3"),           tab(),     type("3"), enter()};
        steps.insert(steps.end(), more.begin(), more.end());
        Table labels;
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 5; ++column) {
                const app::Point at(10 + 33 * column, 10 + 18 * row);
                labels.push_back(
                    {{at, at + app::Point(30, 0), at + app::Point(30, 15), at + app::Point(0, 15)},
                     true});
            }
        check(steps, labels);
    }
    void nudged()
    {
        Steps steps;
        rectangle(steps, "40,50", "20", "10");
        for (const char* corner : {"#80,50", "#40,90"})
            add(steps, {type(corner), enter(), enter()});
        const Steps more{key("Ctrl+A"), key("Right"), key("Shift+Down"), key("Up")};
        steps.insert(steps.end(), more.begin(), more.end());
        check(steps, boxes({{{41, 59}, {61, 69}}, {{81, 59}, {101, 69}}, {{41, 99}, {61, 109}}}));
    }
    void skewedRoof()
    {
        Steps steps;
        rectangle(steps, "40,50", "30", "20");
        const Steps more{key("J"), type("20"), enter()};
        steps.insert(steps.end(), more.begin(), more.end());
        const double lean = 10 * std::tan(glm::radians(20.0));
        check(steps,
              {{{{40 + lean, 50}, {70 + lean, 50}, {70 - lean, 70}, {40 - lean, 70}}, true}});
    }
    void mirroredHalf()
    {
        const Table halves{{{{40, 50}, {60, 50}, {60, 70}}}, {{{80, 50}, {60, 50}, {60, 70}}}};
        check({key("P"), type("40,50"), enter(), type("20,0"), enter(), type("0,20"), enter(),
               key("K"), key("X"), key("C"), move({60.2, 55}), key("P"), type("-1"), enter()},
              halves);
    }
    /// A plate with two holes, one in a wider circle.
    void bracket()
    {
        Steps steps;
        rectangle(steps, "20,20", "60", "40");
        add(steps,
            {key("E"), click({50.4, 39.7}, Qt::AltModifier), type("10"), enter(), key("G"),
             type("-20,0"), enter(), key("E"), click({30.3, 40.4}, Qt::AltModifier), type("16"),
             enter(), key("V"), click({35, 40}), key("G"), key("C"), type("40,0"), enter()});
        Table table = boxes({{{20, 20}, {80, 60}}});
        table.insert(table.end(), {circle({30, 40}, 5), circle({30, 40}, 8), circle({70, 40}, 5)});
        check(steps, table);
    }
    void aligned()
    {
        Steps steps;
        rectangle(steps, "40,20", "20", "10");
        for (const char* by : {"10,13", "-30,14", "40,14", "-25,23", "45,13", "-35,12", "25,16"})
            add(steps, {key("G"), key("C"), type(by), enter()});
        add(steps, {key("Ctrl+A"), press("Align left sides"), press("Spread evenly down")});
        Table table;
        for (int i = 0; i < 8; ++i)
            table.push_back(boxes({{{20, 20 + 15 * i}, {40, 30 + 15 * i}}})[0]);
        check(steps, table);
    }
    void sameSize()
    {
        Steps steps;
        const auto square = [&steps](const char* corner, const char* side) {
            add(steps, {key("R"), type(corner), enter(), type(side), enter()});
        };
        square("20,20", "15");
        rectangle(steps, "20,50", "35", "16");
        square("80,20", "17");
        square("80,50", "18");
        add(steps, {key("V"), click({25, 20}), click({90, 20}, Qt::ShiftModifier),
                    click({90, 50}, Qt::ShiftModifier), click({40, 50}, Qt::ShiftModifier),
                    key("Alt+O"), type("a"), type("w")});
        check(steps, boxes({{{20, 20}, {55, 35}},
                            {{20, 50}, {55, 66}},
                            {{80, 20}, {115, 37}},
                            {{80, 50}, {115, 68}}}));
    }
    /// A circle in a square, which scaling leaves the strokes of 0.7.
    void scaledToFit()
    {
        Steps steps{clickField("Stroke width"), key("Ctrl+A"), type("0.7"), enter()};
        rectangle(steps, "20,30", "25", "20");
        add(steps, {key("E"), type("22.5,30"), enter(), type("20"), enter(), key("Ctrl+A"),
                    press("Keep the ratio of width to height"), clickField("Width"), key("Ctrl+A"),
                    type("50"), enter()});
        Table table = boxes({{{20, 30}, {70, 70}}});
        table.push_back(circle({45, 50}, 20));
        for (Drawn& path : table)
            path.style = app::Style{.stroke = app::Colour{}, .width = 0.7};
        check(steps, table);
    }
};

} // namespace tasks_transforms_test

TEST_CLASS(tasks_transforms_test::TransformsTest, Widgets)
#include "tests/ui/tasks/transforms_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_objects_test {

using namespace tasks;

// Tasks of README.md about groups, order and layers.
class ObjectsTest : public QObject {
    Q_OBJECT

    /// A rectangle 20 wide and 10 high, turned around a corner and moved.
    static Drawn box(const app::Point& at, double degrees = 0, const app::Point& around = {})
    {
        const double sine = std::sin(glm::radians(degrees)),
                     cosine = std::cos(glm::radians(degrees));
        Drawn drawn{{}, true};
        for (const app::Point& corner :
             {at, at + app::Point(20, 0), at + app::Point(20, 10), at + app::Point(0, 10)}) {
            const app::Point way = corner - around;
            drawn.points.push_back(
                around + app::Point(cosine * way.x + sine * way.y, cosine * way.y - sine * way.x));
        }
        return drawn;
    }
    static Steps rectangle(const char* corner)
    {
        return {key("R"), type(corner), enter(), type("20"), tab(), type("10"), enter()};
    }
    /// Enter gives it the size of the last one.
    static Steps another(const char* corner) { return {type(corner), enter(), enter()}; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void turnedGroup()
    {
        Steps steps = rectangle("40,50");
        add(steps, another("#80,50"));
        add(steps, {key("Ctrl+A"), key("Ctrl+G")});
        add(steps, another("40,90"));
        add(steps, {key("V"), click({50, 90}), key("Right"), click({90, 50}), key("O"),
                    move({40.2, 60.2}), key("P"), type("33.5"), enter()});
        const app::Point corner(40, 60);
        check(steps, {box({40, 50}, 33.5, corner), box({80, 50}, 33.5, corner), box({41, 90})});
    }
    void hatchedRectangle()
    {
        Steps steps = rectangle("40,50");
        add(steps, {key("L"), type("42,50"), enter(), type("10"), tab(), type("270"), enter(),
                    key("G"), key("C"), type("4,0"), enter(), type("4x"), enter(), key("Ctrl+A"),
                    key("Ctrl+G"), key("R")});
        add(steps, another("80,50"));
        add(steps, {key("V"), click({90, 50}), key("Down"), click({46, 55}), key("G"), type("0,40"),
                    enter()});
        Table table{box({40, 90})};
        for (const double x : {42.0, 46.0, 50.0, 54.0, 58.0})
            table.push_back({{{x, 90}, {x, 100}}, false});
        table.push_back(box({80, 51}));
        check(steps, table);
    }
    void layers()
    {
        const QString list = "Layers";
        Steps steps = rectangle("40,50");
        for (const char* corner : {"80,50", "40,90", "80,90"}) {
            add(steps, {press("Add layer"), enter()});
            add(steps, another(corner));
        }
        add(steps, {dragRow(list, "Layer 3", "Layer 2"), dragRow(list, "Layer 2", "Drawing"),
                    clickRow(list, "Layer 4"), key("Alt+Down"), clickRow(list, "Layer 2", 18),
                    key("Ctrl+A"), key("Right")});
        check(steps, {box({81, 90}), box({41, 50}), box({80, 50}), box({40, 90})});
    }
    void recoloured()
    {
        const auto line = [](const char* from) {
            return Steps{key("L"), type(from), enter(), type("30,0"), enter()};
        };
        Steps steps{press("Stroke colour"), type("red"), enter()};
        add(steps, line("20,20"));
        add(steps, {press("Add layer"), enter()});
        add(steps, line("20,40"));
        add(steps, {press("Stroke colour"), type("black"), enter(), clickRow("Layers", "Drawing")});
        add(steps, line("20,60"));
        add(steps,
            {key("V"), click({35, 20}), key("Alt+E"), type("e"), type("c"), press("Stroke colour"),
             type("blue"), enter(), key("Ctrl+Shift+F"), type("0.5"), tab(), key("Down")});
        const app::Style black{.stroke = app::Colour{}};
        const app::Style blue{.stroke = app::Colour{.blue = 255}, .width = 0.5, .dashes = {3, 1.5}};
        check(steps, {{{{20, 20}, {50, 20}}, false, blue},
                      {{{20, 60}, {50, 60}}, false, black},
                      {{{20, 40}, {50, 40}}, false, blue}});
    }
    /// An A4 page gets margins of 10; the file that is exported holds the same as the drawing.
    void cropped()
    {
        Steps steps{key("L"), type("0,30"), enter(), type("210,0"), enter(),
                    enter(),  type("50,0"), enter(), type("0,297"), enter()};
        add(steps, rectangle("60,50"));
        add(steps, {key("W"), type("#10,10"), enter(), type("277"), tab(), type("190"), enter(),
                    key("Ctrl+Shift+X"), key("Ctrl+E"), enter()});
        const Table once{{{{10, 30}, {210, 30}}}, {{{50, 10}, {50, 200}}}, box({60, 50})};
        Table twice = once;
        twice.insert(twice.end(), once.begin(), once.end());
        check(steps, twice);
    }
};

} // namespace tasks_objects_test

TEST_CLASS(tasks_objects_test::ObjectsTest, Widgets)
#include "tests/ui/tasks/objects_test.moc"

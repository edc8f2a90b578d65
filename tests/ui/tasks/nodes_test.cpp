// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_nodes_test {

using namespace tasks;

// Tasks of README.md about nodes.
class NodesTest : public QObject {
    Q_OBJECT

    static Steps rectangle()
    {
        return {key("R"), type("10,10"), enter(), type("40"), tab(), type("20"), enter(), key("V")};
    }
    static Steps both(Steps first, const Steps& then)
    {
        first.insert(first.end(), then.begin(), then.end());
        return first;
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void movedEnd()
    {
        check({key("L"), type("10,20"), enter(), type("30,0"), enter(), key("V"), click({25, 20}),
               key("N"), click({40, 20}), type("50,60"), enter()},
              {{{{10, 20}, {50, 60}}}});
    }
    void insertedNode()
    {
        check(both(rectangle(),
                   {doubleClick({20, 10}), doubleClick({20, 10}), type("30,-2"), enter()}),
              {{{{10, 10}, {30, -2}, {50, 10}, {50, 30}, {10, 30}}, true}});
    }
    void split()
    {
        check(both(rectangle(), {doubleClick({20, 10}), click({10, 10}),
                                 click({50, 30}, Qt::ShiftModifier), key("Shift+B")}),
              {{{{10, 10}, {50, 10}, {50, 30}}}, {{{50, 30}, {10, 30}, {10, 10}}}});
    }
    void joined()
    {
        check({key("L"), type("10,10"), enter(), type("30,0"), enter(), type("0,20"), enter(),
               type("-30,0"), enter(), type("0,-20"), enter(), key("Ctrl+A"), key("Shift+J"),
               enter()},
              {{{{10, 10}, {40, 10}, {40, 30}, {10, 30}}, true}});
    }
    /// The points are the centres of small circles.
    void traced()
    {
        const std::vector<app::Point> points{{20, 60}, {50, 30}, {80, 60}, {110, 40}};
        Steps steps{key("E"), type("17,57"), enter(), type("6"), enter()};
        for (const char* corner : {"#47,27", "#77,57", "#107,37"})
            add(steps, {type(corner), enter(), enter()}); // as large as the last one
        add(steps, {key("P")});
        for (const app::Point& p : points)
            add(steps, {click(p + app::Point(0.3, -0.3))});
        add(steps, {key("N"), click({35, 45}), key("Ctrl+A"), key("Shift+S")});
        Table table;
        for (const app::Point& p : points)
            table.push_back(circle(p, 3));
        Drawn smooth{{points[0], points[0] + (points[1] - points[0]) / 3.0}};
        for (std::size_t i : {1, 2}) {
            const app::Point in = points[i - 1] - points[i], out = points[i + 1] - points[i];
            const app::Point along = glm::normalize(glm::normalize(out) - glm::normalize(in)) / 3.0;
            smooth.points.insert(smooth.points.end(),
                                 {points[i] - along * glm::length(in), points[i],
                                  points[i] + along * glm::length(out)});
        }
        smooth.points.insert(smooth.points.end(),
                             {points[3] + (points[2] - points[3]) / 3.0, points[3]});
        table.push_back(smooth);
        check(steps, table);
    }
    /// The two halves of one curve, drawn on the grid.
    void deletedNode()
    {
        check({key("Shift+F5"), key("D"), drag({20, 60}, {20, 40}), drag({60, 30}, {80, 30}),
               drag({100, 60}, {100, 80}), key("N"), click({32.5, 37.5}), click({60, 30}),
               key("Delete")},
              {{{{20, 60}, {20, 20}, {100, 20}, {100, 60}}}});
    }
};

} // namespace tasks_nodes_test

TEST_CLASS(tasks_nodes_test::NodesTest, Widgets)
#include "tests/ui/tasks/nodes_test.moc"

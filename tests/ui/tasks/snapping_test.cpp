// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_snapping_test {

using namespace tasks;

// Tasks of README.md about snapping.
class SnappingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    /// A title block: the guides get typed positions, and two rectangles snap to their crossings.
    void guides()
    {
        const auto guide = [](Steps& steps, int axis, const app::Point& to, const char* at) {
            steps.insert(steps.end(), {dragGuide(axis, to), type(at), enter()});
        };
        Steps steps;
        guide(steps, 0, {110, 60}, "120");
        guide(steps, 0, {180, 60}, "200");
        guide(steps, 1, {60, 150}, "160");
        guide(steps, 1, {60, 180}, "195.5");
        steps.insert(steps.end(), {key("R"), click({120.4, 159.6}), click({199.7, 195.9})});
        check(steps, {{{{120, 160}, {200, 160}, {200, 195.5}, {120, 195.5}}, true}});
    }
    void crossing()
    {
        check({key("L"), type("20,20"), enter(), type("60,40"), enter(), enter(), type("20,60"),
               enter(), type("#80,0"), enter(), key("E"), click({44.4, 36.3}, Qt::AltModifier),
               type("20"), enter()},
              {{{{20, 20}, {80, 60}}}, {{{20, 60}, {80, 0}}}, circle({44, 36}, 10)});
    }
    void perpendicular()
    {
        const app::Point left(20, 80), base(80, -20), top(40, 15);
        const app::Point foot = left + base * (glm::dot(top - left, base) / glm::dot(base, base));
        check({key("P"), type("20,80"), enter(), type("80,-20"), enter(), type("-60,-45"), enter(),
               click({20.4, 79.7}), key("L"), click({40.3, 15.4}), click({54.4, 71.9})},
              {{{left, left + base, top}, true}, {{top, foot}}});
    }
    /// A rhombus, and the line between two of its corners.
    void gridSketch()
    {
        const auto at = [](double u, double v) {
            return app::Point(std::sqrt(75) * (u + v), 5 * (u - v));
        };
        const app::Point near(0.5, -0.6);
        check({key("Shift+F5"), key("Alt+V"), type("d"), type("i"), key("P"),
               click(at(8, 0) + near), click(at(11, 0) + near), click(at(11, 3) + near),
               click(at(8, 3) + near), click(at(8, 0) + near), key("L"), click(at(8, 0) + near),
               click(at(11, 3) + near)},
              {{{at(8, 0), at(11, 0), at(11, 3), at(8, 3)}, true}, {{at(8, 0), at(11, 3)}}});
    }
};

} // namespace tasks_snapping_test

TEST_CLASS(tasks_snapping_test::SnappingTest, Widgets)
#include "tests/ui/tasks/snapping_test.moc"

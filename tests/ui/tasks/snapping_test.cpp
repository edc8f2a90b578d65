// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/tasks/player.h"

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
};

QTEST_MAIN(SnappingTest)
#include "snapping_test.moc"

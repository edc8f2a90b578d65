// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/player.h"

namespace tasks_pages_test {

using namespace tasks;

// Tasks of README.md about the page. The last row of a table is the page: its corners, its size on
// paper.
class PagesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void planAtScale()
    {
        checkWithPage({key("Ctrl+Alt+P"),
                       press("A3, 297 × 420 mm"),
                       press("Metres"),
                       clickField("Scale 1 :"),
                       key("Ctrl+A"),
                       type("50"),
                       enter(),
                       key("R"),
                       type("2,2"),
                       enter(),
                       type("8.4"),
                       tab(),
                       type("5.2"),
                       enter(),
                       key("L"),
                       type("#6,2"),
                       enter(),
                       type("5.2"),
                       tab(),
                       type("-90"),
                       enter()},
                      {{{{2000, 2000}, {10400, 2000}, {10400, 7200}, {2000, 7200}}, true},
                       {{{6000, 2000}, {6000, 7200}}},
                       {{{0, 0}, {21000, 14850}, {420, 297}}}});
    }
    void pageTurned()
    {
        checkWithPage({key("R"), type("20,30"), enter(), type("100"), tab(), type("40"), enter(),
                       key("Ctrl+Alt+P"), clickField("Left margin"), key("Ctrl+A"), type("15"),
                       press("Fits the page around everything that is drawn, and adds the margins"),
                       press("Portrait")},
                      {{{{20, 30}, {120, 30}, {120, 70}, {20, 70}}, true},
                       {{{5, 15}, {75, 145}, {70, 130}}}});
    }
    void pageToWindows()
    {
        checkWithPage(
            {key("W"), type("20,30"), enter(), type("60"), tab(), type("40"), enter(),
             key("Ctrl+Alt+P"), clickField("Left margin"), key("Ctrl+A"), type("5"),
             press("Fits the page around the visible clip windows, and adds the margins")},
            {{{{15, 25}, {85, 75}, {70, 50}}}});
    }
    void ownSize()
    {
        checkWithPage({key("Ctrl+Alt+P"), clickField("Width of the page"), key("Ctrl+A"),
                       type("200"), clickField("Height of the page"), key("Ctrl+A"), type("100"),
                       enter()},
                      {{{{0, 0}, {200, 100}, {200, 100}}}});
    }
};

} // namespace tasks_pages_test

TEST_CLASS(tasks_pages_test::PagesTest, Widgets)
#include "tests/ui/tasks/pages_test.moc"

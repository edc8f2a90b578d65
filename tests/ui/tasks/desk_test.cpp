// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/tasks/desk_player.h"

namespace tasks_desk_test {

using namespace desk_tasks;

namespace {

// A file has one object of two lines: four points.
const Counts one{4}, two{4, 4}, none{};

QString faultOfTabs(const DeskPlayer& player, const QStringList& tabs, const QString& shown)
{
    if (player.tabs() != tabs)
        return "tabs: " + player.tabs().join(", ");
    return player.shownTab() == shown ? QString() : "shown: " + player.shownTab();
}

QString faultOfCounts(const char* what, const Counts& found, const Counts& expected)
{
    return found == expected ? QString() : QString("%1: %2 objects").arg(what).arg(found.size());
}

} // namespace

// Tasks of README.md with several drawings.
class DeskTasksTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void carriedOver()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), carry({50, 50}, "plan.svg", Qt::ShiftModifier),
                   key("Ctrl+S"), key("Ctrl+Tab"), key("Ctrl+S")},
                  [](const DeskPlayer& player) {
                      return faultOfCounts("plan", player.saved("plan.svg"), two)
                             + faultOfCounts("part", player.saved("part.svg"), none);
                  });
    }
    void copiedOver()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), key("Ctrl+A"), key("Ctrl+C"), key("Ctrl+Tab"),
                   key("Ctrl+V"), key("Ctrl+S")},
                  [](const DeskPlayer& player) {
                      return faultOfTabs(player, {"plan.svg", "part.svg"}, "plan.svg")
                             + faultOfCounts("plan", player.saved("plan.svg"), two)
                             + faultOfCounts("part", player.saved("part.svg"), one);
                  });
    }
    void closedUnsaved()
    {
        checkDesk(
            {key("Ctrl+V"), key("Ctrl+O"), key("Ctrl+Shift+Tab"), key("Ctrl+W"), key("Right"),
             key("Return")},
            [](const DeskPlayer& player) { return faultOfTabs(player, {"plan.svg"}, "plan.svg"); });
    }
    void closedSaved()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), key("Ctrl+A"), key("Delete"), key("Ctrl+W"),
                   key("Return")},
                  [](const DeskPlayer& player) {
                      return faultOfTabs(player, {"plan.svg"}, "plan.svg")
                             + faultOfCounts("part", player.saved("part.svg"), none);
                  });
    }
    void tabReopened()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), key("Ctrl+Shift+Tab"), key("Ctrl+W"),
                   key("Ctrl+Shift+T")},
                  [](const DeskPlayer& player) {
                      return faultOfTabs(player, {"part.svg", "plan.svg"}, "plan.svg");
                  });
    }
    void tabsOrdered()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), dragTab("plan.svg", "part.svg")},
                  [](const DeskPlayer& player) {
                      return faultOfTabs(player, {"part.svg", "plan.svg"}, "plan.svg");
                  });
    }
    void quitSaving()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+A"), key("Delete"), key("Ctrl+O"), key("Ctrl+A"),
                   key("Delete"), key("Ctrl+Q"), key("Return"), key("Return")},
                  [](const DeskPlayer& player) {
                      return (player.isOpen() ? "it is open. " : QString())
                             + faultOfCounts("plan", player.saved("plan.svg"), none)
                             + faultOfCounts("part", player.saved("part.svg"), none);
                  });
    }
    void tabsRemembered()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+O"), clickTab("plan.svg"), startAgain()},
                  [](const DeskPlayer& player) {
                      return faultOfTabs(player, {"plan.svg", "part.svg"}, "plan.svg")
                             + (player.readTabs() == 1 ? QString() : "both were read");
                  });
    }
    void recoveredTab()
    {
        checkDesk(
            {key("Return"), key("Ctrl+S")},
            [](const DeskPlayer& player) {
                return faultOfCounts("plan", player.saved("plan.svg"), two);
            },
            true);
    }
    void textPasted()
    {
        checkDesk({key("Ctrl+O"), key("Ctrl+V"), key("Ctrl+S")}, [](const DeskPlayer& player) {
            return player.saved("plan.svg").size() == 2 ? QString() : "no text";
        });
    }
    void helpFound()
    {
        checkDesk({key("F1"), type("isometric"), key("Return")},
                  [](const DeskPlayer& player) {
                      const QString page = player.helpPage();
                      return page.contains("grid", Qt::CaseInsensitive) ? QString()
                                                                        : "page: " + page;
                  });
    }
};

} // namespace tasks_desk_test

TEST_CLASS(tasks_desk_test::DeskTasksTest, Widgets)
#include "tests/ui/tasks/desk_test.moc"

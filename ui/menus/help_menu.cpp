// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"
#include "ui/menus/other_windows.h"
#include "ui/menus/pages.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCoreApplication>

namespace ui {

namespace {

struct HelpMenu {
    Q_DECLARE_TR_FUNCTIONS(HelpMenu)
};

} // namespace

MenuInfo helpMenu()
{
    using K = QKeySequence;
    return {
        .title = HelpMenu::tr("&Help"),
        .rows =
            {
                {
                    .key = "manual",
                    .text = HelpMenu::tr("&Manual"),
                    .icon = "book",
                    .show = &OtherWindows::showManual,
                },
                {
                    .key = "start",
                    .text = HelpMenu::tr("Show &start panel"),
                    .run = [](MainWindow& w) { w.raisePanel("start"); },
                },
                {
                    .key = "shortcuts",
                    .text = HelpMenu::tr("&Keyboard shortcuts"),
                    .keys = {K("Ctrl+?")},
                    .icon = "keyboard",
                    .run = [](MainWindow& w) { showShortcuts(w); },
                },
                {},
                {
                    .key = "about",
                    .text = HelpMenu::tr("A&bout Clearcut"),
                    .run = [](MainWindow& w) { showAbout(w); },
                },
                {
                    .key = "about-qt",
                    .text = HelpMenu::tr("About &Qt"),
                    .run = [](MainWindow&) { QApplication::aboutQt(); },
                },
            },
    };
}

} // namespace ui

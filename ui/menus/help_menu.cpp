// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"
#include "ui/menus/other_windows.h"
#include "ui/menus/pages.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCoreApplication>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("HelpMenu", text); }

} // namespace

MenuInfo helpMenu()
{
    using K = QKeySequence;
    return {
        .title = tr("&Help"),
        .rows =
            {
                {
                    .key = "manual",
                    .text = tr("&Manual"),
                    .icon = "book",
                    .show = &OtherWindows::showManual,
                },
                {
                    .key = "start",
                    .text = tr("Show &start panel"),
                    .run = [](MainWindow& w) { w.raisePanel("start"); },
                },
                {
                    .key = "shortcuts",
                    .text = tr("&Keyboard shortcuts"),
                    .keys = {K("Ctrl+?")},
                    .icon = "keyboard",
                    .run = [](MainWindow& w) { showShortcuts(w); },
                },
                {},
                {
                    .key = "about",
                    .text = tr("A&bout Clearcut"),
                    .run = [](MainWindow& w) { showAbout(w); },
                },
                {
                    .key = "about-qt",
                    .text = tr("About &Qt"),
                    .run = [](MainWindow&) { QApplication::aboutQt(); },
                },
            },
    };
}

} // namespace ui

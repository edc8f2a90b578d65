// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/actions.h"
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
    return {tr("&Help"),
            {
                {"start",
                 tr("Show &start panel"),
                 {},
                 Reach::Window,
                 "book",
                 [](MainWindow& w) { w.raisePanel("start"); }},
                {"shortcuts",
                 tr("&Keyboard shortcuts"),
                 {K("Ctrl+?")},
                 Reach::Window,
                 "keyboard",
                 [](MainWindow& w) { showShortcuts(w); }},
                {},
                {"about",
                 tr("A&bout Clearcut"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { showAbout(w); }},
                {"about-qt",
                 tr("About &Qt"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow&) { QApplication::aboutQt(); }},
            }};
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/text.h"
#include "ui/menus/actions.h"
#include "ui/menus/other_windows.h"
#include "ui/menus/pages.h"
#include "ui/window/main_window.h"

#include <QApplication>

namespace ui {

MenuInfo helpMenu()
{
    using K = QKeySequence;
    return {
        .title = Text::tr("&Help"),
        .rows =
            {
                {
                    .key = "help",
                    .text = Text::tr("&Help"),
                    .keys = keys(K::HelpContents, {K("F1")}),
                    .icon = "book",
                    .show = &OtherWindows::help,
                },
                {
                    .key = "first-lesson",
                    .text = Text::tr("&First lesson"),
                    .run =
                        [](MainWindow& w) {
                            w.showLessons();
                            w.session().course.begin(0);
                        },
                },
                {
                    .key = "start",
                    .text = Text::tr("Show &start panel"),
                    .run = [](MainWindow& w) { w.raisePanel("start"); },
                },
                {
                    .key = "shortcuts",
                    .text = Text::tr("&Keyboard shortcuts"),
                    .keys = {K("Ctrl+?")},
                    .icon = "keyboard",
                    .run = [](MainWindow& w) { showShortcuts(w); },
                },
                {},
                {
                    .key = "about",
                    .text = Text::tr("A&bout Clearcut"),
                    .run = [](MainWindow& w) { showAbout(w); },
                },
                {
                    .key = "about-qt",
                    .text = Text::tr("About &Qt"),
                    .run = [](MainWindow&) { QApplication::aboutQt(); },
                    .paletteOnly = true,
                },
            },
    };
}

} // namespace ui

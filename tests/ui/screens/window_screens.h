// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/workspaces.h"

#include <QMenu>
#include <QMenuBar>

#include "tests/ui/screens/screen.h"

// The whole window, its menus, and the dialogs that its commands open.

namespace ui {

namespace window_screens_parts {

/// The window with a sample, after `prepare`.
inline QImage withWindow(const std::function<QWidget*(TestWindow&)>& prepare)
{
    TestWindow test;
    test.show();
    test.open(QStringLiteral(SOURCE_DIR "/resources/samples/nine-regions.svg"));
    QWidget* shown = prepare(test);
    settle();
    const QImage picture = atRest(*shown);
    shown->close();
    return picture;
}

inline Screen dialog(const char* name, const char* command)
{
    return {name, [command] {
                return withWindow([command](TestWindow& test) -> QWidget* {
                    test.action("select-all")->trigger();
                    QWidget* opened = test.window.get();
                    test.action(command)->trigger();
                    for (QWidget* top : QApplication::topLevelWidgets())
                        if (top->isVisible() && top != test.window.get())
                            opened = top;
                    return opened;
                });
            }};
}

} // namespace window_screens_parts

inline void addWindows(std::vector<Screen>& screens)
{
    using namespace window_screens_parts;
    for (const Workspace& workspace : workspaces())
        screens.push_back({"window-" + QString::fromUtf8(workspace.key.data()), [&workspace] {
                               return withWindow([&workspace](TestWindow& test) {
                                   test.window->choose(workspace);
                                   return test.window.get();
                               });
                           }});
    screens.push_back({"window-dark", [] {
                           return withWindow([](TestWindow& test) {
                               test.window->setTheme(Theme::Dark);
                               return test.window.get();
                           });
                       }});
    screens.push_back(dialog("dialog-repeat", "repeat"));
    screens.push_back(dialog("dialog-margin", "window-inside-margin"));
    for (const qsizetype number : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9})
        screens.push_back({QStringLiteral("menu-%1").arg(number), [number] {
                               return withWindow([number](TestWindow& test) -> QWidget* {
                                   QMenu* menu =
                                       test.window->menuBar()->actions().value(number)->menu();
                                   emit menu->aboutToShow();
                                   menu->adjustSize();
                                   return menu;
                               });
                           }});
}

} // namespace ui

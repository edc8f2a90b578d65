// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/waiting_dialog.h"
#include "ui/explanation/explanation_window.h"
#include "ui/menus/context_menus.h"
#include "ui/menus/palette.h"
#include "ui/microscope/export_steps.h"
#include "ui/sheets/settings_sheet.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/workspaces.h"

#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTableView>

#include "tests/ui/screens/screen.h"

// The whole window, its menus, and the dialogs that its commands open.

namespace ui {

namespace window_screens_parts {

/// The window with a sample, after `prepare`.
inline Seen withWindow(const std::function<QWidget*(TestWindow&)>& prepare)
{
    TestWindow test;
    test.show();
    test.open(QStringLiteral(SOURCE_DIR "/resources/samples/nine-regions.svg"));
    QWidget* shown = prepare(test);
    settle();
    const Seen seen = atRest(*shown);
    shown->close();
    return seen;
}

/// A part of its own, without a window.
template <class Make>
Screen part(const char* name, const Make& make)
{
    return {name, [make] {
                applyTheme(*qApp, Theme::Light);
                const std::unique_ptr<QWidget> shown = make();
                shown->setAttribute(Qt::WA_DontShowOnScreen);
                shown->show();
                return atRest(*shown);
            }};
}

inline std::unique_ptr<QWidget> exportSteps()
{
    app::Microscope microscope;
    microscope.open(
        {{clipping::findAlgorithm("CS")}, {{-160, -30}, {70, 130}}, {{-100, -75}, {100, 75}}});
    return std::make_unique<ExportStepsDialog>(
        app::TraceExport{microscope.tracedLine(), microscope.narration()}, 3, nullptr);
}

inline std::unique_ptr<QWidget> strip(Message::Kind kind)
{
    auto strip = std::make_unique<MessageStrip>();
    strip->resize(700, 36);
    strip->tell(
        {kind, QStringLiteral("12 lines were left out."), QStringLiteral("Show them"), [] {}});
    return strip;
}

inline std::unique_ptr<QWidget> question()
{
    auto strip = std::make_unique<MessageStrip>();
    strip->resize(700, 36);
    strip->ask({QStringLiteral("plan.svg has unsaved changes."),
                {{QStringLiteral("Save"), [] {}},
                 {QStringLiteral("Don't save"), [] {}},
                 {QStringLiteral("Cancel"), [] {}}}});
    return strip;
}

inline std::unique_ptr<QWidget> waiting()
{
    auto dialog = std::make_unique<WaitingDialog>(QStringLiteral("Cutting 1,000 objects"), nullptr);
    dialog->showProgress({});
    return dialog;
}

/// The explanation of an algorithm while a word is looked for.
inline Seen finding()
{
    return withWindow([](TestWindow& test) -> QWidget* {
        emit test.window->explanationWanted(clipping::algorithms().front());
        auto* shown = [&]() -> QWidget* {
            for (QWidget* top : QApplication::topLevelWidgets())
                if (qobject_cast<ExplanationWindow*>(top))
                    return top;
            return nullptr;
        }();
        shown->resize(580, 480);
        settle();
        QTest::keyClick(shown, Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(shown->focusWidget(), "line");
        return shown;
    });
}

inline Screen palette(const char* name, Theme theme, const char* typed)
{
    return {name, [theme, typed] {
                return withWindow([theme, typed](TestWindow& test) -> QWidget* {
                    test.window->setTheme(theme);
                    test.action("find-command")->trigger();
                    auto* shown = test.window->findChild<Palette*>();
                    shown->findChild<QLineEdit*>("palette-typed")->insert(typed);
                    return shown;
                });
            }};
}

/// The sheet Settings beside the drawing.
inline Screen settings(const char* name, Theme theme, SettingsSheet::Page page)
{
    return {name, [theme, page] {
                return withWindow([=](TestWindow& test) -> QWidget* {
                    test.window->setTheme(theme);
                    test.action("settings")->trigger();
                    auto* sheet = static_cast<SettingsSheet*>(test.window->sheet());
                    sheet->turnTo(page);
                    if (auto* keys = sheet->findChild<QTableView*>("keys"))
                        keys->selectRow(3);
                    return test.window.get();
                });
            }};
}

/// A sheet about output beside its preview, after a click at one of its buttons.
inline Screen output(const char* name, Theme theme, const char* command, const char* button)
{
    return {name, [theme, command, button] {
                return withWindow([=](TestWindow& test) -> QWidget* {
                    test.window->setTheme(theme);
                    test.action(command)->trigger();
                    test.window->sheet()->findChild<QAbstractButton*>(button)->click();
                    if (auto* file = test.window->sheet()->findChild<QLineEdit*>("export-file"))
                        file->setText("~/nine-regions-cut"); // wherever the sources are
                    settle();
                    return test.window.get();
                });
            }};
}

/// A page of a lesson in the window.
inline Screen lessonPage(const char* name, Theme theme, std::size_t lesson, std::size_t page)
{
    return {name, [theme, lesson, page] {
                return withWindow([=](TestWindow& test) -> QWidget* {
                    test.window->setTheme(theme);
                    test.window->showLessons();
                    app::Course& course = test.window->session().course;
                    course.begin(lesson);
                    while (course.page() < page)
                        course.isOpen() ? course.skip() : course.next();
                    return test.window.get();
                });
            }};
}

/// *Do it yourself* at the first move of a kind, after a wrong answer if the move has a mistake; or
/// at the end, after one wrong move.
inline Screen practice(const char* name, Theme theme, const char* variant,
                       std::optional<app::MoveKind> kind)
{
    return {name, [theme, variant, kind] {
                return withWindow([=](TestWindow& test) -> QWidget* {
                    test.window->setTheme(theme);
                    test.window->showLessons();
                    app::Practice& practice = test.window->session().practice;
                    practice.begin(*app::findVariant(QString::fromLatin1(variant)));
                    if (!kind)
                        practice.answer(practice.move()->mistakes.front().answer);
                    while (practice.move() && practice.move()->kind != kind) {
                        practice.answer(practice.move()->right);
                        practice.next();
                    }
                    if (practice.move() && !practice.move()->mistakes.empty())
                        practice.answer(practice.move()->mistakes.front().answer);
                    return test.window.get();
                });
            }};
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
    screens.push_back(settings("settings", Theme::Light, SettingsSheet::General));
    screens.push_back(settings("settings-keyboard", Theme::Light, SettingsSheet::Keyboard));
    screens.push_back(settings("settings-keyboard-dark", Theme::Dark, SettingsSheet::Keyboard));
    screens.push_back(output("export", Theme::Light, "export", "export-as-svg"));
    screens.push_back(output("export-dark", Theme::Dark, "export", "export-as-png"));
    screens.push_back(output("print", Theme::Light, "print", "export-page"));
    screens.push_back(lessonPage("lesson-window", Theme::Light, 1, 3));
    screens.push_back(lessonPage("lesson-window-dark", Theme::Dark, 0, 1));
    using enum app::MoveKind;
    screens.push_back(practice("practice-bits", Theme::Light, "cs:published", Bits));
    screens.push_back(practice("practice-edge", Theme::Dark, "cs", Edge));
    screens.push_back(practice("practice-place", Theme::Light, "md:published", Place));
    screens.push_back(practice("practice-line", Theme::Dark, "lb:published", Line));
    screens.push_back(practice("practice-value", Theme::Light, "cb", Value));
    screens.push_back(practice("practice-end", Theme::Light, "kwc:published", std::nullopt));
    screens.push_back({"explanation-finding", finding});
    screens.push_back(part("dialog-export-steps", exportSteps));
    screens.push_back(part("dialog-waiting", waiting));
    screens.push_back(part("strip-done", [] { return strip(Message::Kind::Done); }));
    screens.push_back(part("strip-warning", [] { return strip(Message::Kind::Warning); }));
    screens.push_back(part("strip-question", question));
    screens.push_back(dialog("dialog-repeat", "repeat"));
    screens.push_back(dialog("dialog-margin", "window-inside-margin"));
    screens.push_back(palette("palette", Theme::Light, "window"));
    screens.push_back(palette("palette-dark", Theme::Dark, "rotate"));
    screens.push_back({"menu-of-window", [] {
                           return withWindow([](TestWindow& test) -> QWidget* {
                               QMenu* menu = windowMenu(*test.window);
                               menu->adjustSize();
                               return menu;
                           });
                       }});
    for (const qsizetype number : {0, 1, 2, 3, 4, 5, 6, 7})
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/fresh/made.h"
#include "tests/ui/screens/screen.h"

// Every widget of makers.h with a full drawing, and some in other states.

namespace ui {

namespace maker_screens_parts {

enum class Pointed : std::uint8_t { No, Yes };

/// Of a maker of this name, on a desk that `prepare` has changed. The pointer may be above all of
/// its parts.
template <class Prepare>
Screen screen(const char* name, const char* made, const Prepare& prepare,
              Pointed pointed = Pointed::No)
{
    return {QString::fromLatin1(name), [made, prepare, pointed] {
                Desk desk(3);
                desk_changes::openFull(desk);
                prepare(desk);
                const auto all = makers();
                const Maker& maker = *std::ranges::find(all, std::string_view(made), &Maker::name);
                const std::unique_ptr<QWidget> window(maker.make(desk));
                window->resize(maker.size);
                open(maker, *window, desk);
                settle();
                for (QWidget* part : window->findChildren<QWidget*>())
                    part->setAttribute(Qt::WA_UnderMouse, pointed == Pointed::Yes);
                return atRest(*window);
            }};
}

/// The microscope in the middle of a trace.
inline Screen traced(const char* name, const char* algorithm, clipping::Form form)
{
    return screen(name, "microscope", [algorithm, form](Desk& desk) {
        desk.session.course.end();
        desk.session.microscope.open({{clipping::findAlgorithm(algorithm), form},
                                      {{-160, -30}, {70, 130}},
                                      {{-100, -75}, {100, 75}}});
        desk.session.microscope.goTo(desk.session.microscope.narration().steps.size() * 2 / 3);
    });
}

inline void goToQuestion(Desk& desk)
{
    app::Course& course = desk.session.course;
    while (!course.isOpen() && !course.atLastPage())
        course.next();
}

} // namespace maker_screens_parts

inline void addMakers(std::vector<Screen>& screens)
{
    using namespace maker_screens_parts;
    int number = 0;
    for (const Maker& maker : makers())
        screens.push_back({QString(maker.name).replace(u' ', u'-'), [number = number++] {
                               const Made made(number);
                               return atRest(*made.window);
                           }});
    using enum clipping::Form;
    screens.push_back(traced("microscope-cs", "CS", Published));
    screens.push_back(traced("microscope-nln", "NLN", Corrected));
    screens.push_back(traced("microscope-lb", "LB", Corrected));
    screens.push_back(traced("microscope-ms", "MS", Corrected));
    screens.push_back(screen("lesson-question", "lessons", goToQuestion));
    screens.push_back(screen("lesson-answered", "lessons", [](Desk& desk) {
        goToQuestion(desk);
        desk.session.course.showAnswer();
    }));
    screens.push_back(
        screen("lesson-list", "lessons", [](Desk& desk) { desk.session.course.pause(); }));
    for (const char* under : {"start", "lessons", "options", "status", "properties", "tiles"})
        screens.push_back(screen(
            qPrintable(under + QStringLiteral("-pointed")), under,
            [](Desk& desk) { desk.session.course.pause(); }, Pointed::Yes));
    for (const char* made : {"algorithm", "compare", "options", "microscope", "lessons", "tiles"})
        screens.push_back(screen(qPrintable(made + QStringLiteral("-dark")), made,
                                 [](Desk&) { applyTheme(*qApp, Theme::Dark); }));
    screens.push_back(screen("tiles-rows", "tiles", [](Desk& desk) {
        app::SheetSettings settings = desk.sheets.settings();
        settings.plan.scale = 2;
        desk.sheets.change(settings);
    }));
    const auto nothing = [](Desk& desk) {
        desk.sheets.close();
        desk.session.load({{}, {}});
    };
    for (const char* empty :
         {"algorithm", "windows", "properties", "line", "layers", "compare", "options"})
        screens.push_back(screen(qPrintable(empty + QStringLiteral("-empty")), empty, nothing));
}

} // namespace ui

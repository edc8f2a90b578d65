// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/set_containers.h"
#include "app/practice/plan.h"
#include "app/session/arrange_selection.h"
#include "app/session/layer_steps.h"
#include "app/session/selection_style.h"
#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "app/view/frame_times.h"
#include "ui/editing/keeping.h"
#include "ui/tools/tool.h"
#include "ui/widgets/unit_box.h"
#include "ui/window/workspaces.h"

#include <QLocale>

#include "tests/app/document/random_documents.h"
#include "tests/ui/fresh/desk.h"

// THE CATALOGUE of what changes elsewhere while a panel is open.

namespace ui {

struct DeskChange {
    const char* name;
    void (*make)(Desk&);
};

namespace desk_changes {

inline app::Page dividedPage(Desk& desk)
{
    app::Page page;
    page.sheets.emplace();
    page.sheets->paper = desk.below(2) ? "A4" : "A5";
    page.sheets->landscape = desk.below(2);
    page.sheets->plan.marks = {desk.below(2) == 0, desk.below(2) == 0, desk.below(2) == 0};
    return page;
}

/// Lines and areas on one or two layers, with windows, or with nothing.
inline void open(Desk& desk)
{
    app::Sheet sheet;
    sheet.layers = {{QStringLiteral("Ground")}, {QStringLiteral("Walls")}};
    for (int i = desk.below(2) * (4 + desk.below(40)); i > 0; --i) {
        app::Shape shape;
        const auto number = [&] { return double(desk.below(2000)) / 10; };
        shape.paths = {{{number(), number()}, {{{number(), number()}}, {{number(), number()}}}}};
        shape.style.stroke = app::Colour{std::uint8_t(desk.below(256)), 80, 20};
        shape.style.width = 0.5 + desk.below(3);
        if (desk.below(4) == 0)
            shape.style.fill = app::Colour{200, 220, std::uint8_t(desk.below(256))};
        sheet.shapes.push_back(shape);
    }
    for (std::size_t i = sheet.shapes.size() / 2; i < sheet.shapes.size(); ++i)
        sheet.shapes[i].layer = 1;
    sheet.window = {{20, 20}, {150 + double(desk.below(40)), 160}};
    app::Document document = app::documentOf(sheet);
    app::Edit edit;
    edit.page = dividedPage(desk);
    if (desk.below(3) == 0)
        edit.windows = app::ClipWindows{};
    app::EditedDocument edited(document);
    edited.apply(edit);
    desk.session.load({edited.now(), {}});
    desk.canvas.fitPage();
}

/// Lines, selected and at a window; the microscope with a lesson, and the sheets are open.
inline void openFull(Desk& desk)
{
    do
        open(desk);
    while (desk.session.now().objects().size() < 5 || !desk.session.windowNumber());
    desk.session.select({0, 1});
    desk.session.course.setSeed(0); // as the file has it
    desk.session.practice.setSeed(5);
    desk.session.course.begin(0);
    desk.session.course.showAnswer(); // until then the steps are covered
    desk.sheets.open();
}

/// Everything that a file can hold.
inline void openStrange(Desk& desk)
{
    desk.sheets.close(); // it may need thousands
    do {
        RandomDocuments random(unsigned(desk.below(1000)));
        desk.session.load({random.document(6), {}});
    } while (desk.session.scene.lines().size() >= app::leastLinesToTime); // times are never equal
    desk.canvas.fitPage();
}

inline void select(Desk& desk)
{
    app::ObjectRanges chosen;
    const std::size_t count = desk.session.now().objects().size();
    for (std::size_t i = 0; i < count; ++i)
        if (desk.below(3) == 0)
            chosen.insert(i);
    desk.session.select(chosen);
}

inline void addWindow(Desk& desk)
{
    const auto kinds = app::windowKinds();
    const double x = desk.below(100), y = desk.below(100);
    for (const app::WindowKind& kind : kinds.subspan(std::size_t(desk.below(int(kinds.size())))))
        if (kind.make) {
            app::addWindow(desk.session, {.shape = kind.make({{x, y}, {x + 60, y + 40}}),
                                          .operation = app::WindowOperation(desk.below(4))});
            return;
        }
}

template <class Change>
void changeWindow(Desk& desk, const Change& change)
{
    if (const auto number = desk.session.windowNumber())
        app::changeWindow(desk.session, *number, QStringLiteral("change"), change);
}

template <class Change>
void display(Desk& desk, const Change& change)
{
    desk.session.changeDisplay([&](app::Display& display) { change(display); });
}

inline void changeLayer(Desk& desk)
{
    const app::Containers& tree = desk.session.now().containers();
    const auto layers = tree.childrenOf(0);
    app::Container layer = tree[desk.oneOf(layers)];
    switch (desk.below(3)) {
    case 0:
        layer.visible = !layer.visible;
        break;
    case 1:
        layer.locked = !layer.locked;
        break;
    default:
        layer.name += u'x';
    }
    desk.session.history.push(
        new app::SetContainers(desk.session.document, tree.with(layer), QStringLiteral("layer")));
}

} // namespace desk_changes

inline std::vector<DeskChange> deskChanges()
{
    using namespace desk_changes;
    return {
        {"theme",
         [](Desk&) {
             const bool dark = lookOf(qApp->palette()).dark;
             applyTheme(*qApp, dark ? Theme::Light : Theme::Dark);
         }},
        {"language",
         [](Desk& desk) {
             static const QLocale all[]{QLocale::English, QLocale::German, QLocale::French};
             QLocale::setDefault(desk.oneOf(all));
             QEvent change(QEvent::LocaleChange);
             QCoreApplication::sendEvent(qApp, &change);
             emit desk.session.displayChanged(); // as the main window does
         }},
        {"unit",
         [](Desk& desk) {
             display(desk, [&](app::Display& d) { d.unit = desk.oneOf(shownUnits()); });
         }},
        {"open a drawing", open},
        {"open a strange drawing", openStrange},
        {"select", select},
        {"deselect", [](Desk& desk) { desk.session.select({}); }},
        {"add a window", addWindow},
        {"remove the window", [](Desk& desk) { app::removeWindow(desk.session); }},
        {"choose a window",
         [](Desk& desk) {
             if (const auto& list = desk.session.windows().list; !list.empty())
                 desk.session.chooseWindow(std::size_t(desk.below(int(list.size()))));
         }},
        {"move the window",
         [](Desk& desk) {
             app::moveWindow(desk.session, {double(desk.below(40)) - 20, double(desk.below(30))});
         }},
        {"hide the window",
         [](Desk& desk) { changeWindow(desk, [](app::ClipWindow& w) { w.visible = false; }); }},
        {"colour the window",
         [](Desk& desk) {
             changeWindow(desk, [&](app::ClipWindow& w) {
                 w.colour = app::Colour{std::uint8_t(desk.below(256)), 0, 120};
             });
         }},
        {"keep the other side",
         [](Desk& desk) {
             setKeep(desk.session, app::Keep(1 - int(desk.session.windows().keep)));
         }},
        {"algorithm",
         [](Desk& desk) {
             display(desk, [&](app::Display& d) {
                 d.variant = {&desk.oneOf(clipping::algorithms()), clipping::Form(desk.below(2))};
             });
         }},
        {"removed part",
         [](Desk& desk) {
             display(desk, [&](app::Display& d) { d.removed = app::RemovedPart(desk.below(3)); });
         }},
        {"grid",
         [](Desk& desk) {
             display(desk, [&](app::Display& d) {
                 d.grid.shown = !d.grid.shown;
                 d.grid.spacing = 1 + desk.below(9);
             });
         }},
        {"dark paper",
         [](Desk& desk) { display(desk, [](app::Display& d) { d.darkPaper = !d.darkPaper; }); }},
        {"what the algorithm sees",
         [](Desk& desk) { display(desk, [](app::Display& d) { d.overlay = !d.overlay; }); }},
        {"inspect",
         [](Desk& desk) {
             const std::size_t lines = desk.session.scene.lines().size();
             desk.session.inspect(lines ? std::optional(std::size_t(desk.below(int(lines))))
                                        : std::nullopt);
         }},
        {"style",
         [](Desk& desk) {
             app::restyle(
                 desk.session, [&](app::Style& style) { style.width = 1 + desk.below(5); },
                 QStringLiteral("width"));
         }},
        {"stroke colour",
         [](Desk& desk) {
             app::setColour(desk.session, &app::Style::stroke,
                            app::Colour{std::uint8_t(desk.below(256)), 90, 30});
         }},
        {"delete",
         [](Desk& desk) {
             app::restyle(
                 desk.session,
                 [](app::Style& s) {
                     s.dashes = {3, 1};
                 },
                 "dashes");
         }},
        {"undo", [](Desk& desk) { desk.session.history.undo(); }},
        {"redo", [](Desk& desk) { desk.session.history.redo(); }},
        {"add a layer", [](Desk& desk) { app::addLayer(desk.session, QStringLiteral("New")); }},
        {"change a layer", changeLayer},
        {"tool", [](Desk& desk) { desk.canvas.setTool(desk.oneOf(tools()).key); }},
        {"panes",
         [](Desk& desk) {
             app::Panes panes = desk.canvas.panes();
             panes.show(1 + std::size_t(desk.below(4)));
             desk.canvas.setPanes(panes);
         }},
        {"snapping", [](Desk& desk) { desk.canvas.switchSnapping(!desk.canvas.snaps()); }},
        {"zoom", [](Desk& desk) { desk.canvas.setZoom(0.5 + desk.below(4)); }},
        {"workspace", [](Desk& desk) { desk.choose(desk.oneOf(workspaces())); }},
        {"align to",
         [](Desk& desk) { app::alignTo(desk.session, desk.oneOf(app::alignmentTargets())); }},
        {"scale strokes",
         [](Desk& desk) {
             app::scaleStrokes(desk.session,
                               app::StrokeScaling(1 - int(desk.session.arrange.strokes)));
         }},
        {"open the microscope", [](Desk& desk) { desk.drawn.look(); }},
        {"step", [](Desk& desk) { desk.session.microscope.next(); }},
        {"close the microscope", [](Desk& desk) { desk.session.microscope.close(); }},
        {"begin a lesson",
         [](Desk& desk) { desk.session.course.begin(std::size_t(desk.below(3))); }},
        {"answer",
         [](Desk& desk) {
             if (desk.session.course.lesson())
                 desk.session.course.showAnswer();
         }},
        {"play an algorithm",
         [](Desk& desk) {
             const auto variants = app::practiceVariants();
             desk.session.practice.begin(variants[std::size_t(desk.below(int(variants.size())))]);
         }},
        {"answer a move",
         [](Desk& desk) {
             if (!desk.session.practice.move())
                 return;
             desk.session.practice.answer(desk.below(5));
             desk.session.practice.next();
         }},
        {"open the sheets",
         [](Desk& desk) {
             if (desk.session.now().page().size.x < 1000) // not thousands of sheets
                 desk.sheets.open();
         }},
        {"close the sheets", [](Desk& desk) { desk.sheets.close(); }},
    };
}

} // namespace ui

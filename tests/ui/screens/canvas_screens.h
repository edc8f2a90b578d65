// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

#include "tests/ui/canvas/pane_stage.h"
#include "tests/ui/screens/screen.h"

// What is painted above the drawing: handles, guides, numbers, and what the algorithms see.

namespace ui {

namespace canvas_screens_parts {

inline Seen seen(Stage& stage)
{
    settle();
    stage.canvas->settle();
    return atRest(*stage.canvas);
}

inline std::vector<app::Shape> someShapes()
{
    app::Shape curve;
    curve.paths = {{{100, 90}, {{{180, 60}, {120, 20}, {160, 110}, true}, {{190, 90}}}, false}};
    curve.style.stroke = app::Colour{200, 60, 0};
    curve.style.width = 2;
    return {line({10, 50}, {190, 50}), line({20, 10}, {40, 80}), curve};
}

/// A drag that goes on, with a tool.
inline Screen drag(const char* name, std::string_view tool, app::Point from, app::Point to)
{
    return {name, [=] {
                Stage stage(Backend::Raster, someShapes());
                stage.canvas->setTool(tool);
                stage.move(from);
                stage.press(from);
                stage.move((from + to) * 0.5, Qt::LeftButton);
                stage.move(to, Qt::LeftButton);
                const Seen shown = seen(stage);
                stage.key(Qt::Key_Escape);
                stage.release(to);
                return shown;
            }};
}

/// After some steps of a person.
inline Screen after(const char* name, std::string_view tool, void (*steps)(Stage&))
{
    return {name, [=] {
                Stage stage(Backend::Raster, someShapes());
                stage.canvas->setTool(tool);
                steps(stage);
                return seen(stage);
            }};
}

inline void display(Stage& stage, void (*change)(app::Display&))
{
    stage.session.changeDisplay([change](app::Display& d) { change(d); });
}

inline void addOverlays(std::vector<Screen>& screens)
{
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        screens.push_back(
            {"canvas-overlay-" + QString::fromUtf8(algorithm.key.data()).toLower(), [&algorithm] {
                 Stage stage(Backend::Raster, {line({10, 90}, {120, 5})});
                 stage.session.inspect(0);
                 stage.session.changeDisplay([&](app::Display& d) {
                     d.overlay = true;
                     d.variant = {&algorithm, clipping::Form::Corrected};
                 });
                 return seen(stage);
             }});
}

} // namespace canvas_screens_parts

inline void addCanvases(std::vector<Screen>& screens)
{
    using namespace canvas_screens_parts;
    for (const char* tool :
         {"line", "polyline", "pencil", "rectangle", "ellipse", "polygon", "star", "arc", "window"})
        screens.push_back(
            drag(qPrintable(QStringLiteral("canvas-drawing-") + tool), tool, {30, 30}, {85, 66}));
    screens.push_back(drag("canvas-window-moved", "window", {100, 40}, {110, 46}));
    screens.push_back(drag("canvas-window-resized", "window", {150, 80}, {170, 90}));
    screens.push_back(drag("canvas-object-moved", "select", {30, 45}, {40, 52}));
    screens.push_back(drag("canvas-selecting", "select", {5, 5}, {60, 60}));
    screens.push_back(after("canvas-selected", "select", [](Stage& s) {
        s.session.select({0, 2});
    }));
    screens.push_back(after("canvas-nodes", "nodes", [](Stage& s) {
        s.session.select({2});
        s.click({180, 60});
        s.move({100, 90});
    }));
    screens.push_back(after("canvas-nodes-handle", "nodes", [](Stage& s) {
        s.session.select({2});
        s.click({100, 90});
        s.move({120, 20});
    }));
    screens.push_back(after("canvas-pen", "pen", [](Stage& s) {
        s.drag({20, 30}, {40, 20});
        s.drag({90, 70}, {110, 90});
        s.move({150, 40});
    }));
    screens.push_back(after("canvas-grid", "line", [](Stage& s) {
        display(s, [](app::Display& d) {
            d.grid.shown = true;
            d.grid.spacing = 10;
        });
        s.move({50, 20}); // snaps
    }));
    screens.push_back(after("canvas-presenting", "window", [](Stage& s) {
        display(s, [](app::Display& d) { d.presenting = true; });
    }));
    screens.push_back({"canvas-panes", [] {
                           PaneStage stage(4);
                           return seen(stage);
                       }});
    addOverlays(screens);
    for (const char* light : {"canvas-drawing-line", "canvas-nodes", "canvas-window-moved",
                              "canvas-overlay-cohen-sutherland"})
        screens.push_back(
            inTheDark(*std::ranges::find(screens, QString::fromLatin1(light), &Screen::name)));
}

} // namespace ui

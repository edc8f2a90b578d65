// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/styles_in_use.h"
#include "app/experiment/study.h"
#include "app/judge/verdict.h"
#include "ui/bars/arrange_row.h"
#include "ui/bars/option_bar.h"
#include "ui/bars/status_bar.h"
#include "ui/bars/tool_bar.h"
#include "ui/dialogs/find_dialog.h"
#include "ui/dialogs/grid_dialog.h"
#include "ui/dialogs/margin_dialog.h"
#include "ui/dialogs/repeat_dialog.h"
#include "ui/dialogs/waiting_dialog.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/cut_options.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/exactness_panel.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/layers_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/experiment/experiment_window.h"
#include "ui/experiment/results.h"
#include "ui/explanation/explanation_window.h"
#include "ui/hard_cases/hard_cases_window.h"
#include "ui/judge/judge_window.h"
#include "ui/judge/verdict_view.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/microscope/export_steps.h"
#include "ui/microscope/microscope_page.h"
#include "ui/properties/node_fields.h"
#include "ui/properties/properties_panel.h"
#include "ui/properties/stroke_row.h"
#include "ui/properties/style_panel.h"
#include "ui/properties/style_popup.h"
#include "ui/showing/show_bar.h"
#include "ui/tiles/tiles_page.h"
#include "ui/widgets/colour_popup.h"
#include "ui/widgets/message_strip.h"
#include "ui/window/workspace_tabs.h"

#include <QVBoxLayout>

#include "tests/app/charts/sample_charts.h"
#include "tests/ui/fresh/desk.h"

// THE CATALOGUE of what is made on a desk: every panel, bar, page, dialog and window.

namespace ui {

struct Maker {
    const char* name;
    QSize size; ///< the first one
    std::function<QWidget*(Desk&)> make;
    /// Shows it, where that takes more than show().
    std::function<void(QWidget&, Desk&)> open = nullptr;
    /// It asks the session for what it shows, which answers one at a time.
    bool alone = false;
    /// Takes long to make, and shows little of what changes.
    bool slow = false;
    /// Whether the mode is on in which it is shown; null: always.
    bool (*isShown)(const Desk&) = nullptr;
};

inline void open(const Maker& maker, QWidget& widget, Desk& desk)
{
    maker.open ? maker.open(widget, desk) : widget.show();
}

namespace makers_parts {

template <class Widget>
QWidget* onSession(Desk& desk)
{
    return new Widget(desk.session);
}

/// The tool, the panes, the snapping and the place that is seen belong to a canvas, not to the
/// session.
inline QWidget* canvas(Desk& desk)
{
    auto* fresh = new Canvas(desk.session, Backend::Raster);
    fresh->resize(desk.canvas.size());
    fresh->setTool(desk.canvas.tool());
    fresh->setPanes(desk.canvas.panes());
    fresh->setSnapping(desk.canvas.snapping());
    fresh->switchSnapping(desk.canvas.snaps());
    return fresh;
}

/// Of made-up measurements.
inline QWidget* results()
{
    static const auto study = std::make_shared<const app::Study>(
        app::Study{app::measures(),
                   {{std::nullopt, sample::seven()}, {app::paperTables().front(), sample::seven()}},
                   app::Explanation{sample::classes(), sample::operations(), {}}});
    auto* shown = new Results({});
    shown->show(study);
    return shown;
}

inline QWidget* showBar()
{
    auto* bar = new ShowBar;
    bar->say(2, 5, QStringLiteral("Drag beside the windows: one more"));
    return bar;
}

inline QWidget* verdict()
{
    static const auto verdict = [] {
        app::plug_in::Verdict made;
        made.name = QStringLiteral("Mine");
        made.categories.resize(app::plug_in::categories().size() - 1);
        for (auto& category : made.categories)
            category.lines = category.judged = 1000;
        made.categories.front().wrong = 3;
        made.byFault.front() = 3;
        for (int i = 0; i < 3; ++i)
            made.findings.push_back({app::plug_in::Fault(0),
                                     0,
                                     {{{0, 0}, {double(i), 9}}, {{1, 1}, {8, 8}}},
                                     clipping::Segment{{1, 1}, {2, 2}},
                                     {}});
        return std::make_shared<const app::plug_in::Verdict>(std::move(made));
    }();
    auto* shown = new VerdictView;
    shown->show(verdict);
    return shown;
}

inline void openColours(QWidget& widget, Desk& desk)
{
    const app::Objects& objects = desk.session.now().objects();
    static_cast<ColourPopup&>(widget).open(desk.canvas, {app::coloursInUse(objects, 20), {}, {}});
}

/// Both panels that say how clip windows cut.
inline QWidget* windowsAndEdges(Desk& desk)
{
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(new WindowPanel(desk.session));
    column->addWidget(new CutOptionsBox(desk.session));
    return both;
}

} // namespace makers_parts

inline std::vector<Maker> makers()
{
    using namespace makers_parts;
    return {
        // Panels
        {"start", {320, 500}, [](Desk&) { return new StartPanel; }, nullptr, false, true},
        {"algorithm", {320, 400}, onSession<AlgorithmPanel>},
        {"windows", {320, 330}, windowsAndEdges},
        {"properties",
         {320, 340},
         [](Desk& desk) { return new PropertiesPanel(desk.session, desk.canvas); }},
        {"line", {320, 300}, onSession<LinePanel>},
        {"layers", {320, 300}, onSession<LayersPanel>},
        {"history", {320, 300}, [](Desk& desk) { return new HistoryPanel(desk.session.history); }},
        {"compare",
         {560, 400},
         onSession<ComparePanel>,
         [](QWidget& widget, Desk&) {
             widget.show();
             static_cast<ComparePanel&>(widget).setWatched(true);
         }},
        {"difference", {560, 400}, onSession<DifferencePanel>, nullptr, true},
        {"cost map", {560, 480}, onSession<CostMapPanel>},
        {"exactness", {560, 480}, onSession<ExactnessPanel>, nullptr, true},
        // Bars
        {"options",
         {1280, 40},
         [](Desk& desk) { return new OptionBar(desk.session, desk.canvas); }},
        {"arranging", {640, 40}, onSession<ArrangeRow>},
        {"stroke",
         {300, 40},
         [](Desk& desk) {
             return new StrokeRow(desk.session, desk.canvas, StrokeRow::Frame::Plain);
         }},
        {"tools", {44, 640}, [](Desk& desk) { return new ToolBar(desk.session, desk.canvas); }},
        {"status",
         {1280, 26},
         [](Desk& desk) { return new StatusBar(desk.session, desk.canvas); },
         [](QWidget& widget, Desk& desk) {
             widget.show();
             desk.canvas.settle(); // the times are those of the next frame
         }},
        {"show bar", {620, 44}, [](Desk&) { return showBar(); }},
        {"workspaces", {400, 24}, [](Desk& desk) { return new WorkspaceTabs(desk.layout()); }},
        // Pages
        {"canvas",
         {480, 360},
         canvas,
         [](QWidget& widget, Desk& desk) {
             widget.show();
             static_cast<Canvas&>(widget).go(desk.canvas.view());
         },
         true},
        {"microscope",
         {900, 600},
         [](Desk& desk) { return new MicroscopePage(desk.session, desk.drawn); },
         nullptr,
         false,
         false,
         [](const Desk& desk) { return desk.session.microscope.isOpen(); }},
        {"lessons",
         {480, 640},
         [](Desk& desk) { return new LessonPanel(desk.session.course, desk.session.practice); },
         nullptr,
         false,
         false,
         [](const Desk& desk) { return desk.session.microscope.isOpen(); }},
        {"tiles",
         {800, 600},
         [](Desk& desk) { return new TilesPage(desk.session, desk.sheets); },
         nullptr,
         false,
         false,
         [](const Desk& desk) { return desk.sheets.isOpen(); }},
        // Windows of their own
        {"explanation",
         {580, 480},
         [](Desk& desk) { return new ExplanationWindow(desk.session, desk.frame()); },
         [](QWidget& widget, Desk&) {
             static_cast<ExplanationWindow&>(widget).show(clipping::algorithms().front());
         },
         false,
         true},
        {"hard cases",
         {580, 480},
         [](Desk& desk) { return new HardCasesWindow(desk.session, desk.files(), desk.frame()); },
         nullptr,
         false,
         true},
        {"experiment",
         {580, 480},
         [](Desk& desk) {
             const auto name = [] { return QStringLiteral("name"); };
             return new ExperimentWindow(desk.session, name, &desk.frame());
         }},
        {"judge",
         {580, 480},
         [](Desk& desk) { return new JudgeWindow(desk.session, &desk.frame()); },
         nullptr,
         false,
         true},
        {"results",
         {580, 480},
         [](Desk&) { return makers_parts::results(); },
         nullptr,
         false,
         true},
        {"verdict",
         {580, 480},
         [](Desk&) { return makers_parts::verdict(); },
         nullptr,
         false,
         true},
        // Dialogs
        {"grid", {300, 200}, onSession<GridDialog>},
        {"find", {300, 200}, onSession<FindDialog>},
        // Popups
        {"style popup",
         {300, 280},
         [](Desk& desk) { return new StylePopup(desk.session, desk.canvas, &desk.canvas); },
         [](QWidget& widget, Desk& desk) { static_cast<StylePopup&>(widget).open(desk.canvas); }},
        {"colour popup",
         {300, 280},
         [](Desk& desk) { return new ColourPopup(&desk.canvas); },
         openColours},
        {"window note", {400, 30}, onSession<WindowNote>},
    };
}

} // namespace ui

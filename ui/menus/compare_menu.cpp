// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"
#include "app/document/editable.h"
#include "app/view/looking.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/difference_panel.h"
#include "ui/experiment/experiment_window.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("CompareMenu", text); }

/// Selects the objects with lines that some algorithm clips differently, except locked ones.
void selectDiffering(MainWindow& window)
{
    AlgorithmPanel& panel = window.algorithmPanel();
    panel.compare();
    const app::Session& session = window.session();
    app::ObjectRanges objects;
    for (const app::Dissent& dissent : panel.dissents()) {
        app::ObjectRanges treated; // in ascending order, so each one is appended
        for (const std::uint32_t segment : dissent.segments)
            treated.insert(session.scene.lines().objectOf(segment));
        objects = united(objects, treated);
    }
    window.tell({objects.empty() ? Message::Kind::Done : Message::Kind::Warning, panel.verdict()});
    window.session().select(common(objects, app::editableObjects(session.now())));
}

/// Inspects the next or previous line; begins with the first or last one.
void inspectNext(MainWindow& window, std::ptrdiff_t by)
{
    app::Session& session = window.session();
    if (session.microscope.isOpen())
        return window.drawnLine().go(by);
    const auto count = std::ptrdiff_t(session.scene.lines().size());
    const auto now = session.inspected() ? std::ptrdiff_t(*session.inspected())
                     : by > 0            ? -1
                                         : count;
    const auto line = std::size_t((now + by + count) % count);
    session.inspect(line);
    window.canvas().go(app::bringing(window.canvas().view(), session.scene.lines()[line]));
    window.raisePanel("line");
}

/// Opens the panel if it is closed, and brings it to the front.
void showDifferences(MainWindow& window)
{
    if (window.differencePanel().visibleRegion().isEmpty())
        window.togglePanel("difference");
}

void goToDifference(MainWindow& window, int rows)
{
    showDifferences(window);
    window.differencePanel().go(rows);
}

void showMisprint(MainWindow& window)
{
    showDifferences(window);
    const app::Misprint& misprint = app::misprints().front();
    window.differencePanel().compare({misprint.meant, clipping::Form::Published, &misprint},
                                     app::exactVariant());
}

void choose(MainWindow& window, clipping::Form form)
{
    app::Display display = window.session().display();
    display.variant.form = form;
    window.session().setDisplay(display);
}

template <std::size_t count>
void showPanes(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.show(count);
    window.canvas().setPanes(panes);
}

template <std::size_t count>
bool showsPanes(const MainWindow& window)
{
    return window.canvas().panes().size() == count;
}

void showAllPanes(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.showAll();
    window.canvas().setPanes(panes);
}

bool severalPanes(const MainWindow& window) { return window.canvas().panes().size() > 1; }

void activatePane(MainWindow& window, std::size_t by)
{
    const app::Panes& panes = window.canvas().panes();
    window.canvas().activatePane((panes.active() + by) % panes.size());
    window.canvas().setFocus();
}

void closePane(MainWindow& window)
{
    app::Panes panes = window.canvas().panes();
    panes.close(panes.active());
    window.canvas().setPanes(panes);
}

/// Moves the pane commands into a submenu.
void gatherPanes(MainWindow&, QMenu& menu)
{
    auto* panes = new QMenu(tr("Pan&es"), &menu);
    for (QAction* action : menu.actions())
        if (action->objectName().contains(QStringLiteral("pane"))) {
            menu.removeAction(action);
            panes->addAction(action);
        }
    menu.addMenu(panes);
}

bool someLines(const MainWindow& window) { return window.session().scene.lines().size() > 0; }

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo compareMenu()
{
    return {tr("Co&mpare"),
            {
                {"form-corrected",
                 tr("&Corrected form"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { choose(w, clipping::Form::Corrected); },
                 nullptr,
                 [](const MainWindow& w) {
                     return w.session().variant().form == clipping::Form::Corrected;
                 },
                 "form"},
                {"form-published",
                 tr("&Published form"),
                 {},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { choose(w, clipping::Form::Published); },
                 [](const MainWindow& w) {
                     return w.session().display().variant.algorithm->published != nullptr;
                 },
                 [](const MainWindow& w) {
                     return w.session().variant().form == clipping::Form::Published;
                 },
                 "form"},
                {},
                {"agree",
                 tr("Compare &all algorithms"),
                 {QKeySequence("F7")},
                 Reach::Window,
                 "tick",
                 [](MainWindow& w) {
                     w.raisePanel("algorithm");
                     w.algorithmPanel().compare();
                 },
                 someLines},
                {"select-differing",
                 tr("&Select lines that differ"),
                 {QKeySequence("Shift+F7")},
                 Reach::Window,
                 {},
                 selectDiffering,
                 someLines},
                {},
                {"compare-live",
                 tr("Compare algorithms &live"),
                 {QKeySequence("F9")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.togglePanel("compare"); },
                 nullptr,
                 [](const MainWindow& w) { return w.showsPanel("compare"); }},
                {"differences",
                 tr("&Differences between two algorithms"),
                 {QKeySequence("Shift+F9")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.togglePanel("difference"); },
                 nullptr,
                 [](const MainWindow& w) { return w.showsPanel("difference"); }},
                {"misprint",
                 tr("Show the paper's &misprint (Step 2)"),
                 {},
                 Reach::Window,
                 {},
                 showMisprint,
                 nullptr},
                {"next-difference",
                 tr("Next d&ifference"),
                 {QKeySequence("F4")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { goToDifference(w, 1); },
                 someLines},
                {"previous-difference",
                 tr("Previo&us difference"),
                 {QKeySequence("Shift+F4")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { goToDifference(w, -1); },
                 someLines},
                {},
                {"next-line",
                 tr("Inspect &next line"),
                 {QKeySequence("F8")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { inspectNext(w, 1); },
                 someLines},
                {"previous-line",
                 tr("Inspect p&revious line"),
                 {QKeySequence("Shift+F8")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { inspectNext(w, -1); },
                 someLines},
                {},
                {"reproduce-paper",
                 tr("Reproduce t&he paper…"),
                 {QKeySequence("Ctrl+F7")},
                 Reach::Window,
                 "chart",
                 showExperiment},
                {},
                {"panes-1",
                 tr("&One pane"),
                 {QKeySequence("Ctrl+1")},
                 Reach::Window,
                 {},
                 showPanes<1>,
                 nullptr,
                 showsPanes<1>,
                 "panes"},
                {"panes-2",
                 tr("&Two panes"),
                 {QKeySequence("Ctrl+2")},
                 Reach::Window,
                 {},
                 showPanes<2>,
                 nullptr,
                 showsPanes<2>,
                 "panes"},
                {"panes-4",
                 tr("&Four panes"),
                 {QKeySequence("Ctrl+4")},
                 Reach::Window,
                 "panes",
                 showPanes<4>,
                 nullptr,
                 showsPanes<4>,
                 "panes"},
                {"panes-all",
                 tr("A pane for &every algorithm"),
                 {QKeySequence("Ctrl+9")},
                 Reach::Window,
                 {},
                 showAllPanes,
                 nullptr,
                 [](const MainWindow& w) { return w.canvas().panes().showsAll(); },
                 "panes"},
                {"next-pane",
                 tr("&Next pane"),
                 {QKeySequence("F6")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { activatePane(w, 1); },
                 severalPanes},
                {"previous-pane",
                 tr("&Previous pane"),
                 {QKeySequence("Shift+F6")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { activatePane(w, w.canvas().panes().size() - 1); },
                 severalPanes},
                {"close-pane",
                 tr("&Close pane"),
                 {QKeySequence("Ctrl+Shift+W")},
                 Reach::Window,
                 {},
                 closePane,
                 severalPanes},
            },
            gatherPanes};
}

} // namespace ui

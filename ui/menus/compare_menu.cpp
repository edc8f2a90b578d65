// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"
#include "app/document/hidden_objects.h"
#include "app/view/view.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/difference_panel.h"
#include "ui/look/text.h"
#include "ui/menus/actions.h"
#include "ui/menus/other_windows.h"
#include "ui/menus/panes_menu.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <iterator>

namespace ui {

namespace {

/// Selects the objects with lines that some algorithm clips differently, except locked ones.
void selectDisagreements(MainWindow& window)
{
    const AlgorithmPanel& panel = window.algorithmPanel();
    const app::Session& session = window.session();
    app::ObjectRanges objects;
    for (const app::Disagreement& disagreement : panel.disagreements()) {
        app::ObjectRanges treated; // in ascending order, so each one is appended
        for (const std::uint32_t segment : disagreement.segments)
            treated.insert(session.scene.lines().objectOf(segment));
        objects = united(objects, treated);
    }
    window.tell({objects.empty() ? Message::Kind::Done : Message::Kind::Warning, panel.verdict()});
    window.session().select(common(objects, app::editableObjects(session.now())));
}

void selectDiffering(MainWindow& window)
{
    window.algorithmPanel().compare([&window] { selectDisagreements(window); });
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

void goToDifference(MainWindow& window, int rows)
{
    window.raisePanel("difference");
    window.differencePanel().go(rows);
}

void showMisprint(MainWindow& window)
{
    window.raisePanel("difference");
    const app::Misprint& misprint = app::misprints().front();
    window.differencePanel().compare({misprint.meant, clipping::Form::Published, &misprint},
                                     app::exactVariant());
}

void chooseForm(MainWindow& window, clipping::Form form)
{
    window.session().changeDisplay([form](app::Display& display) { display.variant.form = form; });
}

bool someLines(const MainWindow& window) { return window.session().scene.lines().size() > 0; }

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo compareMenu()
{
    MenuInfo menu{
        .title = Text::tr("Co&mpare"),
        .rows =
            {
                {
                    .key = "form-corrected",
                    .text = Text::tr("&Corrected form"),
                    .run = [](MainWindow& w) { chooseForm(w, clipping::Form::Corrected); },
                    .checked =
                        [](const MainWindow& w) {
                            return w.session().variant().form == clipping::Form::Corrected;
                        },
                    .group = "form",
                },
                {
                    .key = "form-published",
                    .text = Text::tr("&Published form"),
                    .run = [](MainWindow& w) { chooseForm(w, clipping::Form::Published); },
                    .enabled =
                        [](const MainWindow& w) {
                            return w.session().display().variant.algorithm->published != nullptr;
                        },
                    .checked =
                        [](const MainWindow& w) {
                            return w.session().variant().form == clipping::Form::Published;
                        },
                    .group = "form",
                },
                {},
                {
                    .key = "agree",
                    .text = Text::tr("Compare &all algorithms"),
                    .keys = {QKeySequence("F7")},
                    .icon = "compare",
                    .run =
                        [](MainWindow& w) {
                            w.raisePanel("algorithm");
                            w.algorithmPanel().compare();
                        },
                    .enabled = someLines,
                },
                {
                    .key = "select-differing",
                    .text = Text::tr("&Select lines that differ"),
                    .keys = {QKeySequence("Shift+F7")},
                    .run = selectDiffering,
                    .enabled = someLines,
                },
                {},
                {
                    .key = "compare-live",
                    .text = Text::tr("Compare algorithms &live"),
                    .keys = {QKeySequence("F9")},
                    .run = [](MainWindow& w) { w.togglePanel("compare"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("compare"); },
                },
                {
                    .key = "differences",
                    .text = Text::tr("&Differences between two algorithms"),
                    .keys = {QKeySequence("Shift+F9")},
                    .run = [](MainWindow& w) { w.togglePanel("difference"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("difference"); },
                },
                {
                    .key = "misprint",
                    .text = Text::tr("Show the paper's &misprint (Step 2)"),
                    .run = showMisprint,
                },
                {
                    .key = "next-difference",
                    .text = Text::tr("Next d&ifference"),
                    .keys = {QKeySequence("F4")},
                    .run = [](MainWindow& w) { goToDifference(w, 1); },
                    .enabled = someLines,
                },
                {
                    .key = "previous-difference",
                    .text = Text::tr("Previo&us difference"),
                    .keys = {QKeySequence("Shift+F4")},
                    .run = [](MainWindow& w) { goToDifference(w, -1); },
                    .enabled = someLines,
                },
                {},
                {
                    .key = "next-line",
                    .text = Text::tr("Inspect &next line"),
                    .keys = {QKeySequence("F8")},
                    .run = [](MainWindow& w) { inspectNext(w, 1); },
                    .enabled = someLines,
                },
                {
                    .key = "previous-line",
                    .text = Text::tr("Inspect p&revious line"),
                    .keys = {QKeySequence("Shift+F8")},
                    .run = [](MainWindow& w) { inspectNext(w, -1); },
                    .enabled = someLines,
                },
                {},
                {
                    .key = "reproduce-paper",
                    .text = Text::tr("Reproduce t&he paper…"),
                    .keys = {QKeySequence("Ctrl+F7")},
                    .icon = "chart",
                    .show = &OtherWindows::showExperiment,
                },
                {},
            },
    };
    std::ranges::move(panesRows(), std::back_inserter(menu.rows));
    return menu;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/agreement.h"
#include "app/document/hidden_objects.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/compare_table.h"
#include "ui/docks/difference_panel.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/menus/other_windows.h"
#include "ui/window/main_window.h"

#include <algorithm>

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

void goToDifference(MainWindow& window, int rows)
{
    window.raisePanel("difference");
    window.differencePanel().go(rows);
}

void showMisprint(MainWindow& window)
{
    window.raisePanel("difference");
    const app::Misprint& misprint = app::misprints().front();
    window.differencePanel().compare(app::variantOf(misprint), app::exactVariant());
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo compareMenu()
{
    return {
        .title = Text::tr("Co&mpare"),
        .rows =
            {
                {
                    .key = "compare-live",
                    .text = Text::tr("Compare algorithms &live"),
                    .keys = {QKeySequence("F9")},
                    .run = [](MainWindow& w) { w.togglePanel("compare"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("compare"); },
                },
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
                    .key = "differences",
                    .text = Text::tr("&Differences between two algorithms"),
                    .keys = {QKeySequence("Shift+F9")},
                    .run = [](MainWindow& w) { w.togglePanel("difference"); },
                    .checked = [](const MainWindow& w) { return w.showsPanel("difference"); },
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
                {
                    .key = "select-differing",
                    .text = Text::tr("&Select lines that differ"),
                    .keys = {QKeySequence("Shift+F7")},
                    .run = selectDiffering,
                    .enabled = someLines,
                },
                {
                    .key = "sort-by-time",
                    .text = Text::tr("Sort by &time"),
                    .run =
                        [](MainWindow& w) {
                            w.raisePanel("compare");
                            w.comparePanel().table().sortByTime();
                        },
                    .enabled = someLines,
                },
                {
                    .key = "misprint",
                    .text = Text::tr("Show the paper's &misprint (Step 2)"),
                    .run = showMisprint,
                },
                {},
                {
                    .key = "hard-cases",
                    .text = Text::tr("&Hard cases…"),
                    .keys = {QKeySequence("Ctrl+F2")},
                    .show = &OtherWindows::showHardCases,
                },
                {
                    .key = "judge",
                    .text = Text::tr("&Judge your own algorithm…"),
                    .keys = {QKeySequence("Ctrl+F3")},
                    .show = &OtherWindows::showJudge,
                },
                {
                    .key = "reproduce-paper",
                    .text = Text::tr("Repr&oduce the paper…"),
                    .keys = {QKeySequence("Ctrl+F7")},
                    .icon = "chart",
                    .show = &OtherWindows::showExperiment,
                },
            },
    };
}

} // namespace ui

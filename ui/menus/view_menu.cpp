// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_page_parts.h"
#include "ui/dialogs/grid_dialog.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/tiles/tiles_page.h"
#include "ui/window/main_window.h"
#include "ui/window/workspaces.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>

namespace ui {

namespace {

void toggle(MainWindow& window, bool app::Display::*member)
{
    window.session().changeDisplay(
        [member](app::Display& display) { display.*member = !(display.*member); });
}

/// Zooms the drawing, or the microscope or the sheets if they are open.
template <int over, int under>
void zoom(MainWindow& window)
{
    constexpr double factor = double(over) / under;
    if (window.session().microscope.isOpen())
        window.microscopePage()->view().zoomBy(factor);
    else if (window.sheets().isOpen())
        window.tilesPage()->view().zoomBy(factor);
    else
        window.canvas().zoomBy(factor);
}

template <void (Canvas::*fit)()>
void fitAll(MainWindow& window)
{
    if (window.sheets().isOpen())
        window.tilesPage()->view().fit();
    else
        (window.canvas().*fit)();
}

void addThemes(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    const std::pair<Theme, QString> themes[]{{Theme::System, Text::tr("As the &desktop")},
                                             {Theme::Light, Text::tr("&Light")},
                                             {Theme::Dark, Text::tr("D&ark")}};
    for (const auto& [theme, text] : themes) {
        QAction* action =
            menu.addAction(text, &window, [&window, theme = theme] { window.setTheme(theme); });
        action->setObjectName(QStringLiteral("theme-%1").arg(int(theme)));
        action->setCheckable(true);
        const auto follow = [&window, action, theme = theme] {
            action->setChecked(window.theme() == theme);
        };
        QObject::connect(&window, &MainWindow::actionsOutdated, action, follow);
        follow();
        group->addAction(action);
    }
}

void changeGrid(MainWindow& window, const std::function<void(app::Grid&)>& change)
{
    window.session().changeDisplay([&](app::Display& display) { change(display.grid); });
}

template <app::Grid::Marks marks>
ActionInfo marksRow(std::string_view key, const QString& text)
{
    return {
        .key = key,
        .text = text,
        .run = [](MainWindow& w) { changeGrid(w, [](app::Grid& grid) { grid.marks = marks; }); },
        .checked = [](const MainWindow& w) { return w.session().display().grid.marks == marks; },
        .group = "grid-marks"};
}

template <app::Grid::Pattern pattern>
ActionInfo patternRow(std::string_view key, const QString& text)
{
    return {
        .key = key,
        .text = text,
        .run =
            [](MainWindow& w) { changeGrid(w, [](app::Grid& grid) { grid.pattern = pattern; }); },
        .checked =
            [](const MainWindow& w) { return w.session().display().grid.pattern == pattern; },
        .group = "grid-pattern"};
}

ActionInfo ownGridRow()
{
    ActionInfo row =
        patternRow<app::Grid::Pattern::Own>("grid-own", Text::tr("Own an&gle and spacing…"));
    row.run = [](MainWindow& w) {
        changeGrid(w, [](app::Grid& grid) {
            grid.pattern = app::Grid::Pattern::Own;
            grid.shown = true;
        });
        auto* dialog = new GridDialog(w.session(), &w);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    };
    return row;
}

std::vector<ActionInfo> workspaceRows()
{
    std::vector<ActionInfo> rows;
    for (const Workspace& workspace : workspaces()) {
        rows.push_back({
            .key = workspace.key,
            .text = workspace.name,
            .keys = {QKeySequence(QStringLiteral("Ctrl+Alt+%1").arg(rows.size() + 1))},
            .run = [&workspace](MainWindow& w) { w.choose(workspace); },
            .checked = [&workspace](const MainWindow& w) { return &w.workspace() == &workspace; },
            .group = "workspace",
        });
    }
    rows.push_back({});
    rows.push_back({
        .key = "reset-layout",
        .text = Text::tr("Reset la&yout"),
        .run = [](MainWindow& w) { w.resetLayout(); },
    });
    return rows;
}

void addPanels(MainWindow& window, QMenu& menu) { menu.addActions(window.panelToggles()); }

template <app::RemovedPart removed>
ActionInfo removedRow(std::string_view key, const QString& text)
{
    return {
        .key = key,
        .text = text,
        .run =
            [](MainWindow& w) {
                w.session().changeDisplay([](app::Display& display) { display.removed = removed; });
            },
        .checked = [](const MainWindow& w) { return w.session().display().removed == removed; },
        .group = "removed",
    };
}

/// Also a button while the tool Hand or Zoom is in hand.
void addToBar(MainWindow& window, QAction& action) { window.optionBar().addViewStep(action); }

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
std::vector<ActionInfo> zoomRows()
{
    using K = QKeySequence;
    return {
        {
            .key = "zoom-in",
            .text = Text::tr("Zoom &in"),
            .keys = keys(K::ZoomIn, {K("Ctrl+=")}),
            .run = zoom<5, 4>,
        },
        {
            .key = "zoom-out",
            .text = Text::tr("Zoom &out"),
            .keys = keys(K::ZoomOut),
            .run = zoom<4, 5>,
        },
        {
            .key = "zoom-100",
            .text = Text::tr("Ac&tual size"),
            .keys = {K("Ctrl+0")},
            .run = [](MainWindow& w) { w.canvas().setZoom(1); },
            .made = addToBar,
        },
        {},
        {
            .key = "fit-drawing",
            .text = Text::tr("&Fit drawing"),
            .keys = {K("Shift+1")},
            .scope = ShortcutScope::Canvas,
            .run = fitAll<&Canvas::fitDrawing>,
            .made = addToBar,
        },
        {
            .key = "fit-selection",
            .text = Text::tr("Fit &selection"),
            .keys = {K("Shift+2")},
            .scope = ShortcutScope::Canvas,
            .run = [](MainWindow& w) { w.canvas().fitSelection(); },
            .enabled = [](const MainWindow& w) { return !w.session().selection().empty(); },
            .made = addToBar,
        },
        {
            .key = "fit-window",
            .text = Text::tr("Fit clip &window"),
            .keys = {K("Shift+3")},
            .scope = ShortcutScope::Canvas,
            .run = [](MainWindow& w) { w.canvas().fitWindow(); },
            .enabled = [](const MainWindow& w) { return w.session().clipWindow().has_value(); },
            .needs = Text::tr("There is no clip window. Draw one first ({tool-window})."),
        },
        {
            .key = "fit-page",
            .text = Text::tr("Fit pa&ge"),
            .keys = {K("Shift+4")},
            .scope = ShortcutScope::Canvas,
            .run = fitAll<&Canvas::fitPage>,
            .made = addToBar,
        },
        {},
        {
            .key = "previous-view",
            .text = Text::tr("&Previous view"),
            .keys = {K("`")},
            .scope = ShortcutScope::Canvas,
            .run = [](MainWindow& w) { w.canvas().previousView(); },
        },
        {
            .key = "next-view",
            .text = Text::tr("&Next view"),
            .keys = {K("~")},
            .scope = ShortcutScope::Canvas,
            .run = [](MainWindow& w) { w.canvas().nextView(); },
        },
        {},
    };
}

std::vector<ActionInfo> gridRows()
{
    using K = QKeySequence;
    return {
        {
            .key = "grid",
            .text = Text::tr("Show g&rid"),
            .keys = {K("Shift+F5")},
            .icon = "grid",
            .run = [](MainWindow& w) { changeGrid(w, [](app::Grid& g) { g.shown = !g.shown; }); },
            .checked = [](const MainWindow& w) { return w.session().display().grid.shown; },
        },
        {},
        marksRow<app::Grid::Marks::Lines>("grid-lines", Text::tr("&Lines")),
        marksRow<app::Grid::Marks::Dots>("grid-dots", Text::tr("&Dots")),
        {},
        patternRow<app::Grid::Pattern::Square>("grid-square", Text::tr("&Square")),
        patternRow<app::Grid::Pattern::Diagonal>("grid-diagonal", Text::tr("Di&agonal, 45°")),
        patternRow<app::Grid::Pattern::Isometric>("grid-isometric", Text::tr("&Isometric, 30°")),
        ownGridRow(),
    };
}

std::vector<ActionInfo> guideRows()
{
    using K = QKeySequence;
    return {
        {
            .key = "guides",
            .text = Text::tr("&Show guides"),
            .keys = {K("Ctrl+F5")},
            .run = [](MainWindow& w) { toggle(w, &app::Display::guides); },
            .checked = [](const MainWindow& w) { return w.session().display().guides; },
        },
        {
            .key = "remove-guides",
            .text = Text::tr("&Remove all guides"),
            .run =
                [](MainWindow& w) {
                    w.session().history.push(
                        new app::SetGuides(w.session().document, {}, Text::tr("Remove guides")));
                },
            .enabled =
                [](const MainWindow& w) { return !w.session().now().page().guides.list.empty(); },
            .needs = Text::tr("The page has no guides. Drag one from a ruler."),
        },
    };
}

std::vector<ActionInfo> removedRows()
{
    using app::RemovedPart;
    return {
        removedRow<RemovedPart::Ghosted>("removed-ghosted", Text::tr("&Ghosted")),
        removedRow<RemovedPart::Hidden>("removed-hidden", Text::tr("&Hidden")),
        removedRow<RemovedPart::Shown>("removed-shown", Text::tr("&Shown")),
    };
}

std::vector<ActionInfo> panelRows() { return {{.text = Text::tr("Panels"), .fill = addPanels}}; }

} // namespace

MenuInfo viewMenu()
{
    using K = QKeySequence;
    const std::vector<ActionInfo> separator(1);
    return {
        .title = Text::tr("&View"),
        .rows = joined({
            inSubmenu(Text::tr("&Zoom"), {zoomRows(), toolRows({"hand", "zoom"})}),
            inSubmenu(Text::tr("&Panes"), {panesRows()}),
            {
                {},
                {
                    .key = "snap",
                    .text = Text::tr("Snappin&g"),
                    .keys = {K("F5")},
                    .run = [](MainWindow& w) { w.canvas().switchSnapping(!w.canvas().snaps()); },
                    .checked = [](const MainWindow& w) { return w.canvas().snaps(); },
                },
            },
            inSubmenu(Text::tr("Gri&d"), {gridRows()}),
            inSubmenu(Text::tr("Gu&ides"), {guideRows()}),
            separator,
            inSubmenu(Text::tr("&Removed part"), {removedRows()}),
            {
                {
                    .key = "dark-paper",
                    .text = Text::tr("Dark p&aper"),
                    .run = [](MainWindow& w) { toggle(w, &app::Display::darkPaper); },
                    .checked = [](const MainWindow& w) { return w.session().display().darkPaper; },
                },
                {
                    .text = Text::tr("T&heme"),
                    .fill = addThemes,
                },
                {},
            },
            inSubmenu(Text::tr("Pane&ls"), {panelRows()}),
            inSubmenu(Text::tr("Wor&kspace"), {workspaceRows()}),
            {
                {
                    .key = "presentation",
                    .text = Text::tr("Pres&entation"),
                    .keys = {K("F11")},
                    .run = [](MainWindow& w) { w.togglePresenting(); },
                    .checked = [](const MainWindow& w) { return w.isPresenting(); },
                },
                {
                    .key = "full-screen",
                    .text = Text::tr("F&ull screen"),
                    .keys = {K("Shift+F11")},
                    .run =
                        [](MainWindow& w) {
                            QWidget& whole = *w.window();
                            whole.setWindowState(whole.windowState() ^ Qt::WindowFullScreen);
                        },
                    .checked = [](const MainWindow& w) { return w.window()->isFullScreen(); },
                },
            },
        }),
    };
}

} // namespace ui

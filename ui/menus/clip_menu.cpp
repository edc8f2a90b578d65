// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"
#include "app/base/text.h"
#include "app/document/window_operations.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_places.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"
#include "app/view/picking.h"
#include "ui/bars/option_bar.h"
#include "ui/dialogs/margin_dialog.h"
#include "ui/docks/window_panel.h"
#include "ui/editing/keeping.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/menus/actions.h"
#include "ui/menus/menu_rows.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/window/main_window.h"
#include "ui/window/workspaces.h"

#include <QActionGroup>
#include <QMenu>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

void chooseAlgorithm(MainWindow& window, const clipping::Algorithm& algorithm)
{
    window.session().changeDisplay(
        [&](app::Display& display) { display.variant.algorithm = &algorithm; });
}

/// Says why a digit does not choose the algorithm.
void explainDigits(MainWindow& window)
{
    auto* action = new QAction(&window);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    window.canvas().addAction(action);
    QList<QKeySequence> digits;
    for (const clipping::Algorithm& row : clipping::algorithms())
        if (const QString digit = digitOf(row); !digit.isEmpty())
            digits << QKeySequence(digit);
    QObject::connect(action, &QAction::triggered, &window, [&window] {
        window.statusBar()->showMessage(
            Text::tr(
                "In the workspace Draw digits choose the algorithm only while a clip window is "
                "chosen. Choose it in the menu Clip, or in another workspace."),
            MainWindow::messageMilliseconds);
    });
    QObject::connect(&window, &MainWindow::actionsOutdated, action, [&window, digits, action] {
        action->setShortcuts(window.canvas().digitsChoose() ? QList<QKeySequence>() : digits);
    });
    const auto follow = [&window, chose = false]() mutable {
        if (std::exchange(chose, window.canvas().digitsChoose()) != window.canvas().digitsChoose())
            window.refreshActions();
    };
    QObject::connect(&window.canvas(), &Canvas::toolChanged, action, follow);
    QObject::connect(&window.canvas(), &Canvas::hint, action, follow);
}

/// Adds the algorithms, with digits as shortcuts while the canvas has the focus.
void addAlgorithms(MainWindow& window, QMenu& menu)
{
    auto* group = new QActionGroup(&menu);
    for (const clipping::Algorithm& row : clipping::algorithms()) {
        auto* action = menu.addAction(app::latin(row.name), &window,
                                      [&window, &row] { chooseAlgorithm(window, row); });
        action->setCheckable(true);
        group->addAction(action);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        window.canvas().addAction(action);
        QObject::connect(&window, &MainWindow::actionsOutdated, action, [&window, &row, action] {
            const bool digits = window.canvas().digitsChoose();
            action->setShortcut(QKeySequence(digits ? digitOf(row) : QString()));
            action->setChecked(window.session().display().variant.algorithm == &row);
            action->setText(app::limitedName(row, app::needsInHand(window.session())));
        });
    }
    explainDigits(window);
}

// A command for each place that a window can be laid on.
std::vector<ActionInfo> placeRows()
{
    std::vector<ActionInfo> rows;
    for (const app::LayingPlace& place : app::windowPlaces())
        rows.push_back({
            .key = place.key,
            .text = Text::tr(place.text.data()),
            .run = [&place](MainWindow& w) { app::layWindow(w.session(), place); },
            .enabled = [&place](const MainWindow& w) { return place.box(w.session()).has_value(); },
            .needs = place.needs.empty() ? QString() : Text::tr(place.needs.data()),
        });
    rows.push_back({
        .key = "window-inside-margin",
        .text = Text::tr("Lay window inside the page's &margins…"),
        .run = [](MainWindow& w) { MarginDialog::show(w.session(), w); },
    });
    rows.emplace_back();
    rows.push_back({
        .key = "windows-of-selection",
        .text = Text::tr("Make clip &windows of selection"),
        .run = [](MainWindow& w) { app::addWindowsOfSelection(w.session()); },
        .enabled = [](const MainWindow& w) { return !w.session().selection().empty(); },
        .needs = nothingSelected(),
    });
    return rows;
}

void removeWindow(MainWindow& window) { app::removeWindow(window.session()); }

void toggleTiles(MainWindow& window)
{
    app::LiveSheets& sheets = window.sheets();
    if (sheets.isOpen())
        return sheets.close();
    sheets.open();
}

QString emptyDrawing() { return Text::tr("The drawing is empty."); }

QString whyNoTiles(const MainWindow& window)
{
    if (window.isPresenting())
        return app::withKeys(Text::tr("Leave the presentation first ({presentation})."));
    return someLines(window) ? QString() : emptyDrawing();
}

bool hasWindow(const MainWindow& window) { return window.session().windowNumber().has_value(); }

ActionInfo occludeRow()
{
    return {
        .key = "occlude",
        .text = Text::tr("Remo&ve covered lines"),
        .run = [](MainWindow& w) { w.files().cutPermanently(app::permanentCut("occlude")); },
        .enabled = someLines,
        .needs = emptyDrawing(),
    };
}

QString noWindow()
{
    return Text::tr("No clip window is visible. Draw one first ({tool-window}).");
}

QString whyNoCut(const MainWindow& window)
{
    return !someLines(window)   ? emptyDrawing()
           : !hasWindow(window) ? app::withKeys(noWindow())
                                : QString();
}

ActionInfo operationRow(const app::WindowOperationInfo& info)
{
    const app::WindowOperation operation = info.operation;
    return {
        .key = info.key,
        .text = info.entry,
        .keys = {QKeySequence(info.letter)},
        .scope = ShortcutScope::Shown,
        .run =
            [operation](MainWindow& w) {
                if (const auto number = w.session().windowNumber())
                    app::setWindowOperation(w.session(), *number, operation);
            },
        .checked =
            [operation](const MainWindow& w) {
                const auto number = w.session().windowNumber();
                return number && w.session().windows().list[*number].operation == operation;
            },
        .group = "operation",
        .refusal =
            [operation](const MainWindow& w) {
                const auto number = w.session().windowNumber();
                return number ? app::whyNot(w.session().windows(), *number, operation)
                              : app::withKeys(noWindow());
            },
    };
}

std::vector<ActionInfo> operationRows()
{
    std::vector<ActionInfo> rows;
    for (const app::WindowOperationInfo& each : app::windowOperations())
        rows.push_back(operationRow(each));
    rows.emplace_back();
    return rows;
}

std::vector<ActionInfo> windowRows()
{
    return {
        {
            .key = "rename-window",
            .text = Text::tr("Re&name…"),
            .run =
                [](MainWindow& w) {
                    w.raisePanel(QStringLiteral("window"));
                    w.windowPanel().rename();
                },
            .enabled = hasWindow,
            .needs = noWindow(),
        },
        {
            .key = "window-to-path",
            .text = Text::tr("Draw window's outline as &path"),
            .run = [](MainWindow& w) { app::windowToPath(w.session()); },
            .enabled = hasWindow,
            .needs = noWindow(),
        },
        {
            .key = "remove-window",
            .text = Text::tr("&Remove clip window"),
            .run = removeWindow,
            .enabled = hasWindow,
            .needs = noWindow(),
        },
    };
}

std::vector<ActionInfo> cutRows()
{
    return {
        {
            .key = "crop",
            .text = Text::tr("&Crop to windows"),
            .keys = {QKeySequence("Ctrl+Shift+X")},
            .run = [](MainWindow& w) { w.files().cutPermanently(app::permanentCut("crop")); },
            .refusal = whyNoCut,
        },
        {
            .key = "cut-out",
            .text = Text::tr("Cut o&ut windows"),
            .run = [](MainWindow& w) { w.files().cutPermanently(app::permanentCut("cut-out")); },
            .refusal = whyNoCut,
        },
        {
            .key = "split",
            .text = Text::tr("Spli&t at windows"),
            .run = [](MainWindow& w) { w.files().cutPermanently(app::permanentCut("split")); },
            .refusal = whyNoCut,
        },
        occludeRow(),
    };
}

ActionInfo tilesRow()
{
    return {
        .key = "tiles",
        .text = Text::tr("Til&es…"),
        .keys = {QKeySequence("Ctrl+T")},
        .icon = "tiles",
        .run = toggleTiles,
        .refusal = whyNoTiles,
    };
}

ActionInfo keepOutsideRow()
{
    return {
        .key = "keep-outside",
        .text = Text::tr("&Keep outside"),
        .keys = {QKeySequence("X")},
        .scope = ShortcutScope::Shown,
        .run = [](MainWindow& w) { keepOtherSide(w.session()); },
        .checked =
            [](const MainWindow& w) {
                return w.session().now().windows().keep == app::Keep::Outside;
            },
    };
}

/// The usual form of an algorithm is the corrected one.
ActionInfo publishedRow()
{
    using clipping::Form;
    return {
        .key = "form-published",
        .text = Text::tr("As pu&blished"),
        .run =
            [](MainWindow& w) {
                w.session().changeDisplay([](app::Display& display) {
                    const bool published = display.variant.form == Form::Published;
                    display.variant.form = published ? Form::Corrected : Form::Published;
                });
            },
        .enabled =
            [](const MainWindow& w) {
                return w.session().display().variant.algorithm->published != nullptr;
            },
        .checked =
            [](const MainWindow& w) { return w.session().variant().form == Form::Published; },
        .needs = Text::tr("This algorithm has no published form of its own."),
    };
}

} // namespace

MenuInfo clipMenu()
{
    const std::vector<ActionInfo> separator(1);
    return {
        .title = Text::tr("&Clip"),
        .rows = joined({
            toolRows({"window"}),
            inSubmenu(Text::tr("&Lay a window"), {placeRows()}),
            inSubmenu(Text::tr("This &window"), {operationRows(), windowRows()}),
            {keepOutsideRow()},
            separator,
            cutRows(),
            inSubmenu(Text::tr("Cut ed&ges"), {cutEdgesRows()}),
            {tilesRow()},
            separator,
            {{.text = Text::tr("&Algorithm"), .fill = addAlgorithms}, publishedRow()},
        }),
        .ofDrawing = true,
    };
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/select_alike.h"
#include "ui/dialogs/find_dialog.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

namespace ui {

namespace {

bool someObjects(const MainWindow& window) { return !window.session().now().objects().empty(); }

ActionInfo alike(const app::Likeness& likeness)
{
    return {
        .key = likeness.key,
        .text = likeness.name,
        .run = [&likeness](MainWindow& w) { app::selectAlike(w.session(), likeness); },
        .enabled = someSelected,
        .needs = Text::tr("Nothing is selected. Select an object first."),
    };
}

void showFind(MainWindow& window)
{
    auto* dialog = new FindDialog(window.session(), &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(true);
    QObject::connect(dialog, &FindDialog::found, &window, [&window] {
        showIfUnseen(window.canvas(), window.session().selectionBounds(), &Canvas::fitSelection);
    });
    dialog->show();
}

} // namespace

std::vector<ActionInfo> selectRows()
{
    using K = QKeySequence;
    std::vector<ActionInfo> rows{
        {
            .key = "deselect",
            .text = Text::tr("D&eselect"),
            .keys = keys(K::Deselect, {K("Ctrl+Shift+A")}),
            .run = [](MainWindow& w) { w.session().select({}); },
            .enabled = someSelected,
        },
        {
            .key = "select-layer",
            .text = Text::tr("Select all in the la&yer"),
            .keys = {K("Ctrl+Alt+A")},
            .run = [](MainWindow& w) { app::selectLayer(w.session(), w.session().pen.layer); },
            .enabled = someObjects,
        },
        {
            .key = "invert-selection",
            .text = Text::tr("In&vert selection"),
            .keys = {K("Ctrl+I")},
            .run = [](MainWindow& w) { app::invertSelection(w.session()); },
            .enabled = someObjects,
        },
    };
    for (const app::Likeness& likeness : app::likenesses())
        rows.push_back(alike(likeness));
    return rows;
}

ActionInfo findRow()
{
    using K = QKeySequence;
    return {
        .key = "find",
        .text = Text::tr("&Find…"),
        .keys = keys(K::Find, {K("Ctrl+F")}),
        .run = showFind,
        .enabled = someObjects,
    };
}

} // namespace ui

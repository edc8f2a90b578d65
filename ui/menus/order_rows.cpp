// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/rearrange_selection.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/window/main_window.h"

#include <QMenu>

namespace ui {

namespace {

ActionInfo stack(std::string_view key, const QString& text, const QKeySequence& shortcut,
                 app::Stacking how)
{
    return {
        .key = key,
        .text = text,
        .keys = {shortcut},
        .scope = ShortcutScope::Canvas,
        .run = [how](MainWindow& w) { app::stackSelection(w.session(), how); },
        .enabled = someSelected,
        .needs = nothingSelected(),
    };
}

ActionInfo moveBy(std::string_view key, const QString& text, const QKeySequence& shortcut,
                  int layers)
{
    return {
        .key = key,
        .text = text,
        .keys = {shortcut},
        .scope = ShortcutScope::Canvas,
        .run = [layers](MainWindow& w) { app::moveSelectionBy(w.session(), layers); },
        .enabled = someSelected,
        .needs = nothingSelected(),
    };
}

/// The layers, each time the menu opens.
void fillLayers(MainWindow& window, QMenu& menu)
{
    menu.setObjectName(QStringLiteral("move-to-layer"));
    const auto refill = [&window, &menu] {
        menu.clear();
        const app::Containers& tree = window.session().now().containers();
        for (const app::ContainerId layer : app::usableLayers(window.session())) {
            QString name = tree[layer].name;
            QAction* action = menu.addAction(name.replace('&', "&&"));
            action->setEnabled(someSelected(window));
            action->setStatusTip(action->isEnabled() ? QString() : nothingSelected());
            QObject::connect(action, &QAction::triggered, &window, [&window, layer] {
                if (window.session().now().containers().contains(layer))
                    app::moveSelectionTo(window.session(), layer);
            });
        }
    };
    QObject::connect(&menu, &QMenu::aboutToShow, &window, refill);
    refill();
}

} // namespace

std::vector<ActionInfo> orderRows()
{
    using K = QKeySequence;
    using app::Stacking;
    return {
        stack("to-front", Text::tr("Bring to &front"), K("Home"), Stacking::ToFront),
        stack("raise", Text::tr("&Raise"), K("PgUp"), Stacking::Raise),
        stack("lower", Text::tr("&Lower"), K("PgDown"), Stacking::Lower),
        stack("to-back", Text::tr("Send to &back"), K("End"), Stacking::ToBack),
        {},
        moveBy("to-layer-above", Text::tr("To the layer &above"), K("Shift+PgUp"), 1),
        moveBy("to-layer-below", Text::tr("To the layer b&elow"), K("Shift+PgDown"), -1),
    };
}

ActionInfo moveToLayerRow() { return {.text = Text::tr("Move to la&yer"), .fill = fillLayers}; }

} // namespace ui

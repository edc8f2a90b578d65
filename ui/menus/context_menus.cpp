// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/context_menus.h"

#include "app/base/text.h"
#include "ui/canvas/ruler.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/compare_table.h"
#include "ui/docks/layer_list.h"
#include "ui/docks/window_panel.h"
#include "ui/menus/algorithm_menu.h"
#include "ui/widgets/unit_box.h"
#include "ui/window/main_window.h"

#include <QAction>

#include <array>

namespace ui {
namespace {

// THE CATALOGUES. To add a command to a menu: add its key.
constexpr std::array<std::string_view, 23> onObject{"enter-group",
                                                    "leave-group",
                                                    "group",
                                                    "ungroup",
                                                    "",
                                                    "cut",
                                                    "copy",
                                                    "paste",
                                                    "duplicate",
                                                    "delete",
                                                    "",
                                                    "copy-style",
                                                    "paste-style",
                                                    "style",
                                                    "",
                                                    ">to-front",
                                                    "move-to-layer",
                                                    ">same-colour",
                                                    "invert-selection",
                                                    "",
                                                    "fit-selection",
                                                    "find",
                                                    "microscope"};
/// While nodes are shown.
constexpr std::array<std::string_view, 20> onNodes{"corner-nodes",
                                                   "smooth-nodes",
                                                   "symmetric-nodes",
                                                   "",
                                                   "straighten-segments",
                                                   "curve-segments",
                                                   "",
                                                   "add-nodes",
                                                   "delete-nodes",
                                                   "split-path",
                                                   "join-ends",
                                                   "close-path",
                                                   "open-path",
                                                   "reverse-path",
                                                   "",
                                                   "convert-to-path",
                                                   "select-all",
                                                   "",
                                                   "fit-selection",
                                                   "microscope"};
constexpr std::array<std::string_view, 14> onNothing{
    "paste",    "paste-in-place", "", "leave-group", "select-all", "select-layer",
    "deselect", "find",           "", "fit-drawing", "snap",       "grid",
    "",         "window-on-page"};

/// On the outline, the name or the row of a clip window, and in its capsule.
constexpr std::array<std::string_view, 14> onWindow{"window-adds",
                                                    "window-cuts-out",
                                                    "window-intersects",
                                                    "window-replaces",
                                                    "",
                                                    "rename-window",
                                                    "",
                                                    "crop",
                                                    "cut-out",
                                                    "split",
                                                    "",
                                                    "keep-outside",
                                                    "window-to-path",
                                                    "remove-window"};

std::vector<std::string> onRuler()
{
    std::vector<std::string> keys;
    for (const app::Unit unit : shownUnits())
        keys.push_back("unit-" + std::string(app::infoOf(unit).suffix));
    for (const char* const other : {"", "guides", "remove-guides", "", "snap", "grid"})
        keys.emplace_back(other);
    return keys;
}

/// Whether there are nodes, which may lie on the outline of a window.
bool showsNodes(const app::Session& session)
{
    return session.nodes.shown() && !session.selection().empty();
}

void showAt(QMenu* menu, const QPoint& place)
{
    if (menu->isEmpty())
        menu->deleteLater();
    else
        menu->popup(place);
}

/// The action of the menu bar; ">KEY" is the submenu that holds it, "KEY" may also name a submenu.
QAction* actionOf(const MainWindow& window, std::string_view key)
{
    const bool submenu = key.starts_with('>');
    const QString name = app::latin(submenu ? key.substr(1) : key);
    auto* action = window.findChild<QAction*>(name);
    if (action && submenu) {
        for (const QObject* holder : action->associatedObjects())
            if (const auto* menu = qobject_cast<const QMenu*>(holder))
                return action->isEnabled() ? menu->menuAction() : nullptr;
        return nullptr;
    }
    if (action)
        return action->isEnabled() ? action : nullptr;
    const auto* menu = window.findChild<QMenu*>(name);
    return menu ? menu->menuAction() : nullptr;
}

} // namespace

QMenu* contextMenu(MainWindow& window, std::span<const std::string_view> keys)
{
    auto* menu = new QMenu(&window);
    menu->setObjectName(QStringLiteral("context-menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    bool separated = true; // no separator comes first, or after another one
    for (const std::string_view key : keys) {
        if (key.empty()) {
            if (!separated)
                menu->addSeparator();
            separated = true;
        } else if (QAction* action = actionOf(window, key)) {
            menu->addAction(action);
            separated = false;
        }
    }
    if (separated && !menu->isEmpty())
        menu->removeAction(menu->actions().last());
    return menu;
}

/// With its upper right corner there.
static void showLeftOf(QMenu* menu, const QPoint& corner)
{
    showAt(menu, corner - QPoint(menu->sizeHint().width(), 0));
}

QMenu* windowMenu(MainWindow& window) { return contextMenu(window, onWindow); }

void addContextMenus(MainWindow& window)
{
    Canvas& canvas = window.canvas();
    canvas.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&canvas, &QWidget::customContextMenuRequested, &window,
                     [&window, &canvas](const QPoint& at) {
                         if (!showsNodes(window.session()) && canvas.chooseWindowAt(at))
                             return showAt(windowMenu(window), canvas.mapToGlobal(at));
                         const bool object = canvas.selectAt(at);
                         const bool nodes = object && window.session().nodes.shown();
                         const auto keys = nodes    ? std::span<const std::string_view>(onNodes)
                                           : object ? std::span<const std::string_view>(onObject)
                                                    : std::span<const std::string_view>(onNothing);
                         showAt(contextMenu(window, keys), canvas.mapToGlobal(at));
                     });
    QObject::connect(&canvas, &Canvas::windowMenuWanted, &window,
                     [&window](QPoint corner) { showLeftOf(windowMenu(window), corner); });
    QObject::connect(&canvas, &Canvas::objectMenuWanted, &window, [&window](QPoint corner) {
        showLeftOf(contextMenu(window, onObject), corner);
    });
    QObject::connect(&window.windowPanel(), &WindowPanel::menuWanted, &window,
                     [&window](const QPoint& place) { showAt(windowMenu(window), place); });
    QObject::connect(
        window.findChild<LayerList*>(), &LayerList::objectMenuWanted, &window,
        [&window](const QPoint& place) { showAt(contextMenu(window, onObject), place); });
    QObject::connect(&window.algorithmPanel(), &AlgorithmPanel::menuWanted, &window,
                     [&window](const clipping::Algorithm& algorithm, const QPoint& place) {
                         showAt(algorithmMenu(window, algorithm), place);
                     });
    QObject::connect(&window.comparePanel().table(), &CompareTable::menuWanted, &window,
                     [&window](const clipping::Algorithm& algorithm, const QPoint& place) {
                         showAt(algorithmMenu(window, algorithm), place);
                     });
    for (auto* ruler : canvas.findChildren<Ruler*>()) {
        ruler->setContextMenuPolicy(Qt::CustomContextMenu);
        QObject::connect(ruler, &QWidget::customContextMenuRequested, &window,
                         [&window, ruler](const QPoint& at) {
                             const auto names = onRuler();
                             const std::vector<std::string_view> keys(names.begin(), names.end());
                             showAt(contextMenu(window, keys), ruler->mapToGlobal(at));
                         });
    }
}

} // namespace ui

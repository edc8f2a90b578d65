// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QMainWindow>
#include <QString>

#include <span>
#include <string_view>
#include <vector>

class QAction;
class QMenu;

namespace ui {

class MainWindow;

/// Where a command's keys work: everywhere in the window, or only while the canvas has the focus
/// (single letters and digits, which fields need for typing).
enum class Reach : std::uint8_t { Window, Canvas };

/// One row of the catalogue of commands. Menus, tool bars, the list of shortcuts and the tests loop
/// over it.
struct ActionInfo {
    std::string_view key; ///< the action's objectName; empty: a separator
    QString text;         ///< with its mnemonic; "…" if more is asked
    QList<QKeySequence> keys = {};
    Reach reach = Reach::Window;
    std::string_view icon = {};
    void (*run)(MainWindow& window) = nullptr;
    bool (*enabled)(const MainWindow& window) = nullptr; ///< null: always
    bool (*checked)(const MainWindow& window) = nullptr; ///< null: not a switch
    std::string_view group = {};                         ///< of which one is on
    QString needs = {}; ///< why it is disabled, and what to do first; its keys say so, too
};

/// One menu: its commands, and what is filled in from another catalogue (tools, algorithms …).
struct MenuInfo {
    QString title;
    std::vector<ActionInfo> rows;
    void (*complete)(MainWindow& window, QMenu& menu) = nullptr;
};

/// Every menu, in the order of the menu bar.
std::span<const MenuInfo> menus();

/// Puts them into the window. The commands then follow the session by themselves.
void addMenus(MainWindow& window);

/// A standard key with fallbacks for desktops that have none, and further keys.
QList<QKeySequence> keys(QKeySequence::StandardKey standard,
                         const QList<QKeySequence>& further = {});

} // namespace ui

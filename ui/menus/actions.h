// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QMainWindow>
#include <QObject>
#include <QString>

#include <functional>
#include <span>
#include <string_view>
#include <vector>

class QAction;
class QMenu;

namespace ui {

class MainWindow;
class OtherWindows;

/// Where a command's keys work: everywhere in the window; or only while the canvas has the focus
/// (single letters and digits, which fields need for typing). Shown: they are no shortcuts, but
/// keys that the canvas itself understands where they fit what is chosen.
enum class ShortcutScope : std::uint8_t { Window, Canvas, Shown };

/// One row of the catalogue of commands. Menus, tool bars, the list of shortcuts and the tests loop
/// over it.
struct ActionInfo {
    std::string_view key = {}; ///< the action's objectName; empty: a submenu or a separator
    /// With its mnemonic; ends in "…" if the command opens a dialog. Empty: a separator.
    QString text = {};
    QList<QKeySequence> keys = {};
    ShortcutScope scope = ShortcutScope::Window;
    std::string_view icon = {};
    std::function<void(MainWindow& window)> run = nullptr;
    void (OtherWindows::*show)() = nullptr;                          ///< instead of run
    std::function<bool(const MainWindow& window)> enabled = nullptr; ///< null: always
    std::function<bool(const MainWindow& window)> checked = nullptr; ///< null: not checkable
    std::string_view group = {}; ///< exclusive: one of its actions is checked; empty: none
    /// Why it is disabled, and what to do first; its disabled shortcut shows this too.
    /// Names no thing of the drawing: it may name keys (`app::withKeys`).
    QString needs = {};
    QString submenu = {}; ///< the title of the submenu that holds the command; empty: none
    /// Instead of `enabled` and `needs`: why it is disabled now, in one sentence; empty: it is not.
    std::function<QString(const MainWindow& window)> refusal = nullptr;
    /// Fills the submenu that this row is, or its part of `submenu`, from another catalogue
    /// (algorithms, panels …).
    void (*fill)(MainWindow& window, QMenu& menu) = nullptr;
    std::string_view tool = {}; ///< instead of all others: the entry of this tool
    bool paletteOnly = false;   ///< no entry in the menu: in the palette, and where `made` puts it
    /// Puts the new action in a bar, too.
    void (*made)(MainWindow& window, QAction& action) = nullptr;
};

/// One menu: its commands, below entries that are not rows (tools, Undo).
struct MenuInfo {
    QString title;
    std::vector<ActionInfo> rows = {};
    void (*begin)(MainWindow& window, QMenu& menu) = nullptr; ///< adds the entries above the rows
    /// Its commands change the drawing, or what is selected, and need to show it: not while a
    /// preview of an export is in its place.
    bool ofDrawing = false;
};

/// Every menu, in the order of the menu bar.
std::span<const MenuInfo> menus();

/// Adds every menu to a new window, the buttons of its bar, and the windows that it opens. Every
/// window needs this once. The actions are updated whenever the session changes.
void addMenus(MainWindow& window);

/// A standard key, with fallbacks for desktops that do not define it, and further keys.
QList<QKeySequence> keys(QKeySequence::StandardKey standard,
                         const QList<QKeySequence>& further = {});

/// Gives an open menu all keys. Without it a letter would be the shortcut of a tool, because the
/// canvas behind the menu keeps the focus, and the entry with this letter could not be chosen.
class MenuKeys : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* receiver, QEvent* event) override;
};

} // namespace ui

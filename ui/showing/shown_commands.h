// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QString>

class QAction;
class QWidget;

namespace app {
struct ShownStep;
}

namespace ui {

class MainWindow;

/// The command of this name that steps may run: it changes nothing but the drawing, its view and
/// its panels. Null: there is none, or it writes files, fills the clipboard, opens windows of its
/// own or ends the program.
QAction* commandToShow(MainWindow& window, const QString& key);

/// The enabled command whose shortcut this is while the widget has the keyboard; null: none. Keys
/// of the chosen clip window are no shortcuts: the canvas understands them.
QAction* commandWith(MainWindow& window, const QWidget& receiver, const QKeySequence& keys);
bool mayBeShown(MainWindow& window, const QAction& command);

/// What a step does, for a person: "Rectangle (R)".
QString wordsFor(const MainWindow& window, const app::ShownStep& step);

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing/editing.h"
#include "ui/look/look_icon.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("EditMenu", text); }

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

QString nothingSelected() { return tr("Nothing is selected. Select an object first."); }

/// The clipboard now holds a drawing, so a warning that it does not is outdated.
void withdrawWarning(MainWindow& window)
{
    if (window.message() == nothingToPaste())
        window.tell({});
}

void pasteOrWarn(MainWindow& window)
{
    if (paste(window.session()))
        withdrawWarning(window);
    else
        window.tell({Message::Kind::Warning, nothingToPaste()});
}

struct StepEntry {
    const char* key;
    QString verb;
    void (Canvas::*run)();
    bool (Canvas::*can)() const;
    QString (Canvas::*step)() const; ///< the name of the step
};

/// The Undo or Redo action, whose text names the step.
QAction* stepAction(Canvas& canvas, QMenu& menu, const StepEntry& entry)
{
    auto* action = new QAction(icon(entry.key), entry.verb, &menu);
    action->setObjectName(QLatin1StringView(entry.key));
    const auto refresh = [action, entry, &canvas] {
        const QString name = (canvas.*entry.step)();
        action->setText(name.isEmpty() ? entry.verb : entry.verb + u' ' + name);
        action->setEnabled((canvas.*entry.can)());
    };
    QObject::connect(action, &QAction::triggered, &canvas, entry.run);
    QObject::connect(&canvas, &Canvas::stepsChanged, action, refresh);
    refresh();
    return action;
}

void complete(MainWindow& window, QMenu& menu)
{
    QAction* undo =
        stepAction(window.canvas(), menu,
                   {"undo", tr("&Undo"), &Canvas::undo, &Canvas::canUndo, &Canvas::undoText});
    undo->setShortcuts(keys(QKeySequence::Undo));
    QAction* redo =
        stepAction(window.canvas(), menu,
                   {"redo", tr("&Redo"), &Canvas::redo, &Canvas::canRedo, &Canvas::redoText});
    redo->setShortcuts(keys(QKeySequence::Redo, {QKeySequence("Ctrl+Y")}));
    QAction* first = menu.actions().front();
    menu.insertActions(first, {undo, redo});
    menu.insertSeparator(first);
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo editMenu()
{
    using K = QKeySequence;
    return {tr("&Edit"),
            {
                {"cut",
                 tr("Cu&t"),
                 keys(K::Cut),
                 Reach::Window,
                 {},
                 [](MainWindow& w) {
                     cutSelection(w.session());
                     withdrawWarning(w);
                 },
                 someSelected,
                 {},
                 {},
                 nothingSelected()},
                {"copy",
                 tr("&Copy"),
                 keys(K::Copy),
                 Reach::Window,
                 {},
                 [](MainWindow& w) {
                     copySelection(w.session());
                     withdrawWarning(w);
                 },
                 someSelected,
                 {},
                 {},
                 nothingSelected()},
                {"paste", tr("&Paste"), keys(K::Paste), Reach::Window, {}, pasteOrWarn},
                {"duplicate",
                 tr("Dup&licate"),
                 {K("Ctrl+D")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { duplicateSelection(w.session()); },
                 someSelected,
                 {},
                 {},
                 nothingSelected()},
                {"delete",
                 tr("&Delete"),
                 {K(Qt::Key_Delete), K(Qt::Key_Backspace)},
                 Reach::Canvas,
                 "bin",
                 [](MainWindow& w) { deleteSelection(w.session()); },
                 someSelected,
                 {},
                 {},
                 nothingSelected()},
                {},
                {"select-all",
                 tr("Select &all"),
                 keys(K::SelectAll),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { selectAll(w.session()); },
                 [](const MainWindow& w) { return !w.session().now().objects().empty(); }},
                {"deselect",
                 tr("D&eselect"),
                 keys(K::Deselect, {K("Ctrl+Shift+A")}),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { w.session().select({}); },
                 someSelected},
            },
            complete};
}

} // namespace ui

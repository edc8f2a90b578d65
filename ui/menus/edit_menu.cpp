// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions.h"
#include "ui/editing.h"
#include "ui/look_icon.h"
#include "ui/main_window.h"

#include <QCoreApplication>
#include <QMenu>

namespace ui {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("EditMenu", text); }

bool someSelected(const MainWindow& window) { return !window.session().selection().empty(); }

/// Undo or Redo, which carry the name of the step.
QAction* stepAction(Canvas& canvas, QMenu& menu, const char* key, const QString& verb,
                    void (Canvas::*run)(), bool (Canvas::*can)() const,
                    QString (Canvas::*step)() const)
{
    auto* action = new QAction(icon(key), verb, &menu);
    action->setObjectName(QLatin1StringView(key));
    const auto refresh = [=, &canvas] {
        const QString name = (canvas.*step)();
        action->setText(name.isEmpty() ? verb : verb + u' ' + name);
        action->setEnabled((canvas.*can)());
    };
    QObject::connect(action, &QAction::triggered, &canvas, run);
    QObject::connect(&canvas, &Canvas::stepsChanged, action, refresh);
    refresh();
    return action;
}

void complete(MainWindow& window, QMenu& menu)
{
    QAction* undo = stepAction(window.canvas(), menu, "undo", tr("&Undo"), &Canvas::undo,
                               &Canvas::canUndo, &Canvas::undoText);
    undo->setShortcuts(keys(QKeySequence::Undo));
    QAction* redo = stepAction(window.canvas(), menu, "redo", tr("&Redo"), &Canvas::redo,
                               &Canvas::canRedo, &Canvas::redoText);
    redo->setShortcuts(keys(QKeySequence::Redo, {QKeySequence("Ctrl+Y")}));
    QAction* first = menu.actions().front();
    menu.insertActions(first, {undo, redo});
    menu.insertSeparator(first);
}

} // namespace

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
                 [](MainWindow& w) { cutSelection(w.session()); },
                 someSelected},
                {"copy",
                 tr("&Copy"),
                 keys(K::Copy),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { copySelection(w.session()); },
                 someSelected},
                {"paste",
                 tr("&Paste"),
                 keys(K::Paste),
                 Reach::Window,
                 {},
                 [](MainWindow& w) {
                     if (const auto error = paste(w.session()))
                         w.tell({Message::Kind::Warning, *error});
                 }},
                {"duplicate",
                 tr("Dup&licate"),
                 {K("Ctrl+D")},
                 Reach::Window,
                 {},
                 [](MainWindow& w) { duplicateSelection(w.session()); },
                 someSelected},
                {"delete",
                 tr("&Delete"),
                 {K(Qt::Key_Delete), K(Qt::Key_Backspace)},
                 Reach::Canvas,
                 "bin",
                 [](MainWindow& w) { deleteSelection(w.session()); },
                 someSelected},
                {},
                {"select-all",
                 tr("Select &all"),
                 keys(K::SelectAll),
                 Reach::Window,
                 {},
                 [](MainWindow& w) { selectAll(w.session()); },
                 [](const MainWindow& w) { return !w.session().sheet().shapes.empty(); }},
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

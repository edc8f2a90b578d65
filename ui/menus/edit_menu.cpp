// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"
#include "ui/bars/option_bar.h"
#include "ui/editing/editing.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/menus/other_windows.h"
#include "ui/window/main_window.h"

#include <QClipboard>
#include <QCursor>
#include <QGuiApplication>
#include <QMenu>

namespace ui {

namespace {

/// The last warning that nothing was pasted.
QString& pasteWarning()
{
    static QString warning;
    return warning;
}

/// The clipboard now holds something else, so a warning about it is outdated.
void withdrawWarning(MainWindow& window)
{
    if (!window.message().isEmpty() && window.message() == pasteWarning())
        window.tell({});
}

/// A text stands where the pointer is, or in the middle of the drawing.
app::PastedText textToPaste(const Canvas& canvas)
{
    if (const QWidget* surface = canvas.paneSurface(canvas.panes().active())) {
        const QPoint pointer = surface->mapFromGlobal(QCursor::pos());
        if (surface->isVisible() && surface->rect().contains(pointer))
            return canvas.textAt(pointer);
    }
    return canvas.textAt(QPointF(canvas.view().size.x, canvas.view().size.y) / 2);
}

void pasteOrWarn(MainWindow& window, app::PastePlace place)
{
    const QString why =
        paste(window.session(), QGuiApplication::clipboard()->mimeData(), place,
              textToPaste(window.canvas()), window.placing(), window.canvas().view().visible());
    withdrawWarning(window);
    pasteWarning() = why;
    if (!why.isEmpty())
        window.tell({Message::Kind::Warning, why});
}

/// With the tool Nodes, the selected nodes are meant.
void deleteChosen(MainWindow& window)
{
    app::NodeEditing& nodes = window.session().nodes;
    if (window.canvas().actsOnWindow())
        app::removeWindow(window.session());
    else if (nodes.someSelected())
        nodes.run(app::nodeStep("delete-nodes"));
    else
        deleteSelection(window.session());
}

void selectAllNodesOrObjects(MainWindow& window)
{
    window.canvas().setFocus(); // keys are for what is selected, not for a list
    app::Session& session = window.session();
    if (session.nodes.shown() && !session.selection().empty())
        session.nodes.selectAll(true);
    else
        selectAll(session);
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

void addSteps(MainWindow& window, QMenu& menu)
{
    QAction* undo =
        stepAction(window.canvas(), menu,
                   {"undo", Text::tr("&Undo"), &Canvas::undo, &Canvas::canUndo, &Canvas::undoText});
    undo->setShortcuts(keys(QKeySequence::Undo));
    QAction* redo =
        stepAction(window.canvas(), menu,
                   {"redo", Text::tr("&Redo"), &Canvas::redo, &Canvas::canRedo, &Canvas::redoText});
    redo->setShortcuts(keys(QKeySequence::Redo, {QKeySequence("Ctrl+Y")}));
    menu.addActions({undo, redo});
    menu.addSeparator();
    window.optionBar().addSteps(*undo, *redo);
}

ActionInfo findCommandRow()
{
    return {
        .key = "find-command",
        .text = Text::tr("Find a co&mmand…"),
        .keys = {QKeySequence("Ctrl+K")},
        .icon = "zoom",
        .show = &OtherWindows::showPalette,
    };
}

} // namespace

// NOLINTNEXTLINE(readability-function-size): a table, a row for each entry
MenuInfo editMenu()
{
    using K = QKeySequence;
    MenuInfo menu{
        .title = Text::tr("&Edit"),
        .rows =
            {
                {
                    .key = "cut",
                    .text = Text::tr("Cu&t"),
                    .keys = keys(K::Cut),
                    .run =
                        [](MainWindow& w) {
                            cutSelection(w.session());
                            withdrawWarning(w);
                        },
                    .enabled = someSelected,
                    .needs = nothingSelected(),
                },
                {
                    .key = "copy",
                    .text = Text::tr("&Copy"),
                    .keys = keys(K::Copy),
                    .run =
                        [](MainWindow& w) {
                            copySelection(w.session());
                            withdrawWarning(w);
                        },
                    .enabled = someSelected,
                    .needs = nothingSelected(),
                },
                {
                    .key = "paste",
                    .text = Text::tr("&Paste"),
                    .keys = keys(K::Paste),
                    .run = [](MainWindow& w) { pasteOrWarn(w, app::PastePlace::Offset); },
                },
                {
                    .key = "paste-in-place",
                    .text = Text::tr("Paste &in place"),
                    .keys = {K("Ctrl+Alt+V")},
                    .run = [](MainWindow& w) { pasteOrWarn(w, app::PastePlace::InPlace); },
                },
                {
                    .key = "duplicate",
                    .text = Text::tr("Dup&licate in place"),
                    .keys = {K("Ctrl+D")},
                    .run = [](MainWindow& w) { app::duplicateInPlace(w.session()); },
                    .enabled = someSelected,
                    .needs = nothingSelected(),
                },
                {
                    .key = "delete",
                    .text = Text::tr("&Delete"),
                    .keys = {K(Qt::Key_Delete), K(Qt::Key_Backspace)},
                    .scope = ShortcutScope::Canvas,
                    .icon = "bin",
                    .run = deleteChosen,
                    .enabled =
                        [](const MainWindow& w) {
                            return someSelected(w) || w.canvas().actsOnWindow();
                        },
                    .needs = nothingSelected(),
                },
                {},
                {
                    .key = "select-all",
                    .text = Text::tr("Select &all"),
                    .keys = keys(K::SelectAll),
                    .run = selectAllNodesOrObjects,
                    .enabled =
                        [](const MainWindow& w) { return !w.session().now().objects().empty(); },
                },
            },
        .begin = addSteps,
    };
    menu.rows = joined({menu.rows,
                        inSubmenu(Text::tr("S&elect"), {toolRows({"select", "nodes"}),
                                                        std::vector<ActionInfo>(1), selectRows()}),
                        {findRow(), findCommandRow()}});
    menu.ofDrawing = true;
    return menu;
}

} // namespace ui

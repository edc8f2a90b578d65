// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_files.h"
#include "ui/editing/editing.h"
#include "ui/files/files.h"
#include "ui/look/window_place.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/sheet.h"
#include "ui/window/centre.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_layout.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>

#include <algorithm>

namespace ui {

namespace {

bool isModifier(int key) { return key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock; }

/// The enabled command of the canvas with this key, or null.
QAction* canvasCommand(QMainWindow& window, const QKeySequence& pressed)
{
    const auto all = commands(window);
    const auto found = std::ranges::find_if(all, [&](const QAction* action) {
        return action->shortcutContext() == Qt::WidgetWithChildrenShortcut && action->isEnabled()
               && action->shortcuts().contains(pressed);
    });
    return found == all.end() ? nullptr : *found;
}

/// A key that a list of a panel did not take does what it does on the canvas.
void passToCanvas(const QKeyEvent& event, QWidget& canvas, QMainWindow& window)
{
    canvas.setFocus();
    QWidget* target = canvas.window()->focusWidget();
    const auto send = [&](QEvent::Type type) {
        QKeyEvent copy(type, event.key(), event.modifiers(), event.nativeScanCode(),
                       event.nativeVirtualKey(), event.nativeModifiers(), event.text(),
                       event.isAutoRepeat());
        copy.setAccepted(type == QEvent::KeyPress);
        QApplication::sendEvent(target, &copy);
        return copy.isAccepted();
    };
    QAction* command = canvasCommand(window, QKeySequence(event.keyCombination()));
    if (command && !send(QEvent::ShortcutOverride))
        command->trigger();
    else
        send(QEvent::KeyPress);
}

} // namespace

// close() inside this function would do nothing, so a later answer closes the window again.
void MainWindow::closeEvent(QCloseEvent* event)
{
    event->ignore();
    if (closing_ == Closing::No) {
        closing_ = Closing::Asking;
        files_->mayClose([this](bool yes) {
            const bool later = closing_ == Closing::Waiting;
            closing_ = yes ? Closing::Agreed : Closing::No;
            if (yes && later)
                close();
        });
        if (closing_ == Closing::Asking)
            closing_ = Closing::Waiting;
    }
    if (closing_ != Closing::Agreed)
        return;
    closing_ = Closing::No;
    rememberPlace(*this, placeKey());
    saveLayout();
    event->accept();
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    panelLayout_->fit();
}

/// Handles a key that no widget took: says why the key's command is disabled, treats the key as the
/// American one at the same place, or runs the command, whose shortcut Qt ignores in a window that
/// is not the active one.
void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (centre_->showsCanvas() && qobject_cast<PanelList*>(focusWidget())
        && !isModifier(event->key()))
        return passToCanvas(*event, *canvas_, *this);
    if (event->key() == Qt::Key_Escape && centre_->showsCanvas()) {
        if (canvas_->focusProxy()->hasFocus() && isPresenting())
            return togglePresenting();
        if (sheet() && canvas_->focusProxy()->hasFocus())
            return sheet()->leave();
        return canvas_->setFocus(); // from a list or a field
    }
    const auto key = keyAtItsPlace(*event);
    const bool onCanvas = canvas_->isAncestorOf(focusWidget());
    const QKeySequence pressed(event->keyCombination());
    for (QAction* action : commands(*this)) {
        const bool reached =
            action->shortcutContext() != Qt::WidgetWithChildrenShortcut || onCanvas;
        if (reached && !action->isEnabled() && !action->statusTip().isEmpty()
            && action->shortcuts().contains(pressed))
            return statusBar()->showMessage(action->statusTip(), messageMilliseconds);
        const bool shown = action->shortcutContext() == Qt::WidgetShortcut; // is no shortcut
        const QList<QKeySequence> keys = action->shortcuts();
        if (reached && !shown && action->isEnabled()
            && (keys.contains(pressed) || (key && keys.contains(QKeySequence(*key)))))
            return action->trigger();
    }
    QMainWindow::keyPressEvent(event);
}

static QStringList localFiles(const QMimeData& data)
{
    QStringList paths;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            paths << url.toLocalFile();
    return paths;
}

/// What was dragged out of this program and back changes nothing.
void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!event->source()
        && (!localFiles(*event->mimeData()).isEmpty() || canPaste(*event->mimeData())))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    event->acceptProposedAction();
    const QStringList paths = localFiles(*event->mimeData());
    if (paths.isEmpty())
        return takeDropped(*event->mimeData(), event->position());
    QStringList lessons, drawings;
    for (const QString& path : paths) {
        if (app::isNamedLikeImage(path))
            placing_->place(path);
        else
            (app::isLessonPath(path) ? lessons : drawings) << path;
    }
    if (!lessons.isEmpty())
        openLessons(lessons);
    if (!drawings_) // one file replaces the drawing
        drawings = drawings.first(std::min<qsizetype>(1, drawings.size()));
    // Queued until the drop is finished, because a question may follow while the other program
    // waits.
    for (const QString& path : drawings)
        QMetaObject::invokeMethod(
            this, [this, path] { files_->open(path); }, Qt::QueuedConnection);
}

/// The drawing or text of another program comes to the place where it was dropped; an image lies
/// below all.
void MainWindow::takeDropped(const QMimeData& data, const QPointF& position)
{
    const QWidget* surface = canvas_->paneSurface(canvas_->panes().active());
    const QPointF at = surface ? surface->mapFromGlobal(mapToGlobal(position)) : position;
    const app::PastedText text = canvas_->textAt(at);
    const QString why = paste(session_, &data, app::PastePlace::Offset, text, *placing_,
                              clipping::Window{text.centre, text.centre});
    if (!why.isEmpty())
        tell({Message::Kind::Warning, why});
}

/// Whether a key is of a command that does not need to show the drawing, or opens a menu.
bool MainWindow::isKeyOfPreview(const QKeyEvent& event) const
{
    if (event.modifiers() & Qt::AltModifier)
        return true;
    const QKeySequence pressed(event.keyCombination());
    return std::ranges::any_of(findChildren<QAction*>(), [&](const QAction* action) {
        return action->property(worksInPreview).toBool() && action->shortcuts().contains(pressed);
    });
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && isPreviewing()
        && !isKeyOfPreview(*static_cast<QKeyEvent*>(event))) {
        event->accept(); // the key is no shortcut
        return true;
    }
    if (event->type() == QEvent::WindowActivate)
        refreshActions();
    if (event->type() == QEvent::LocaleChange)
        emit session_.displayChanged(); // numbers look different
    return QMainWindow::event(event);
}

} // namespace ui

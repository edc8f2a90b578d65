// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/step_player.h"

#include "ui/files/files.h"
#include "ui/showing/actor.h"
#include "ui/showing/show_bar.h"
#include "ui/showing/shown_commands.h"
#include "ui/widgets/sheet.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QKeyEvent>

#include <utility>

namespace ui {

namespace {

constexpr int beforeStep = 1100, afterStep = 1500, whileBusy = 50; // milliseconds

} // namespace

StepPlayer::StepPlayer(MainWindow& window, std::vector<app::ShownStep> steps)
    : QObject(&window), window_(window), steps_(std::move(steps))
{
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &StepPlayer::goOn);
}

StepPlayer::~StepPlayer() = default;

void StepPlayer::begin()
{
    playing_ = true;
    window_.canvas().fitPage();
    window_.canvas().setFocus();
    actor_ = std::make_unique<Actor>(window_);
    bar_ = new ShowBar(window_.centralWidget());
    connect(bar_, &ShowBar::nextWanted, this, &StepPlayer::next);
    connect(bar_, &ShowBar::stopWanted, this, &StepPlayer::stop);
    qApp->installEventFilter(this);
    bar_->show();
    beginStep();
}

void StepPlayer::beginStep()
{
    bar_->say(int(step_) + 1, int(steps_.size()), wordsFor(window_, steps_[step_]));
    bar_->raise();
    beats_ = beatsOf(steps_[step_], window_, *actor_);
    timer_.start(beforeStep);
}

void StepPlayer::next()
{
    if (!playing_)
        return;
    timer_.stop();
    if (beats_.empty())
        return goOn();
    while (playing_ && !beats_.empty() && !window_.files().busy())
        act();
    if (playing_ && !beats_.empty())
        timer_.start(whileBusy);
}

/// The next beat, or the next step.
void StepPlayer::goOn()
{
    if (!playing_)
        return;
    if (window_.files().busy())
        return timer_.start(whileBusy);
    if (!beats_.empty())
        return act();
    if (step_ + 1 == steps_.size())
        return finish(true);
    ++step_;
    beginStep();
}

void StepPlayer::act()
{
    const Beat beat = std::move(beats_.front());
    beats_.pop_front();
    acts_ = true;
    beat.act();
    acts_ = false;
    if (!playing_)
        return;
    if (isPersonsTurn())
        return stop();
    if (beats_.empty())
        emit stepDone();
    timer_.start(beats_.empty() ? afterStep : beats_.front().wait);
}

/// A dialog, or a sheet that writes files.
bool StepPlayer::isPersonsTurn() const
{
    const Sheet* sheet = window_.sheet();
    return QApplication::activeModalWidget()
           || (sheet && sheet->objectName() != QStringLiteral("page"));
}

void StepPlayer::stop()
{
    if (playing_)
        finish(false);
}

void StepPlayer::finish(bool wholly)
{
    playing_ = false;
    timer_.stop();
    beats_.clear();
    qApp->removeEventFilter(this);
    actor_->letGo();
    actor_.reset();
    if (bar_) {
        bar_->hide();
        bar_->deleteLater(); // its button may have been pressed
    }
    emit ended(wholly);
}

/// Whether a widget is the bar, or on it. It asks the widgets, not `bar_`: while the bar is being
/// deleted with its window, it is no ShowBar any more.
static bool isOfBar(const QWidget* widget)
{
    while (widget && !qobject_cast<const ShowBar*>(widget))
        widget = widget->parentWidget();
    return widget != nullptr;
}

/// Everything that the mouse and the keyboard do in the window, but not on the bar.
bool StepPlayer::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &window_ && event->type() == QEvent::Hide && playing_) { // another tab
        QMetaObject::invokeMethod(this, &StepPlayer::stop, Qt::QueuedConnection);
        return false;
    }
    const auto* widget = qobject_cast<const QWidget*>(watched);
    const bool isOfWindow = widget && (widget == &window_ || window_.isAncestorOf(widget));
    if (!playing_ || acts_ || !isOfWindow || isOfBar(widget))
        return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        if (!event->spontaneous())
            return false;
        stop();
        return true;
    case QEvent::KeyPress:
        obey(static_cast<const QKeyEvent*>(event)->key());
        return true;
    case QEvent::ShortcutOverride: // so that no command is run
        event->accept();
        return true;
    case QEvent::KeyRelease:
        return true;
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::ContextMenu:
    case QEvent::Wheel:
        return event->spontaneous();
    default:
        return false;
    }
}

void StepPlayer::obey(int key)
{
    if (key == Qt::Key_Escape)
        stop();
    else if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space)
        next();
}

} // namespace ui

#include "moc_step_player.cpp"

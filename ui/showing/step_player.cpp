// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/showing/step_player.h"

#include "app/base/text.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/sheets/command_keys.h"
#include "ui/showing/pointer_mark.h"
#include "ui/showing/show_bar.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

// Milliseconds.
constexpr int beforeStep = 1100, afterStep = 1500, perPlace = 22, perKey = 260, perButton = 220,
              whileBusy = 50;
constexpr int places = 24; // of the pointer, from one point of a step to the next

QWidget& areaOf(MainWindow& window) { return *window.canvas().focusProxy(); }

/// A field or list that has the keyboard, else the drawing.
QWidget& receiverIn(MainWindow& window)
{
    QWidget* const focused = window.focusWidget();
    return focused && focused->isVisible() && window.isAncestorOf(focused) ? *focused
                                                                           : areaOf(window);
}

/// The enabled command whose shortcut this is now. Keys of the chosen clip window are no
/// shortcuts: the canvas understands them.
QAction* commandWith(MainWindow& window, const QKeySequence& keys)
{
    const bool onCanvas = window.canvas().isAncestorOf(&receiverIn(window));
    for (QAction* action : commands(window)) {
        const Qt::ShortcutContext where = action->shortcutContext();
        if (action->isEnabled() && action->shortcuts().contains(keys)
            && where != Qt::WidgetShortcut && (onCanvas || where != Qt::WidgetWithChildrenShortcut))
            return action;
    }
    return nullptr;
}

/// The shortcut of a page around the widget, such as the microscope's; null: none has these keys.
QShortcut* shortcutWith(const QWidget& receiver, const QKeySequence& keys)
{
    for (const QWidget* around = &receiver; around; around = around->parentWidget())
        for (auto* shortcut :
             around->findChildren<QShortcut*>(QString(), Qt::FindDirectChildrenOnly))
            if (shortcut->isEnabled() && shortcut->key() == keys)
                return shortcut;
    return nullptr;
}

bool contains(const QWidget& menu, const QAction* action)
{
    return std::ranges::any_of(menu.actions(), [action](const QAction* one) {
        return one == action || (one->menu() && contains(*one->menu(), action));
    });
}

/// Whether a command changes nothing but the drawing, its view and its panels. The others leave
/// it: they write files, fill the clipboard, open windows of their own or end the program.
bool staysInDrawing(MainWindow& window, const QAction& action)
{
    static const QStringList leaves{
        "cut",         "copy",           "copy-style",   "find-command", "hard-cases",
        "judge",       "reproduce-paper", "agree",       "export-steps", "full-screen",
        "presentation", "reset-layout",  "about-algorithm", "next-drawing", "previous-drawing",
        "reopen"};
    static const QStringList menus{Text::tr("&File"), Text::tr("&Help")};
    const QString key = action.objectName();
    if (key == QStringLiteral("page"))
        return true;
    if (leaves.contains(key) || key.startsWith(QStringLiteral("theme-")))
        return false;
    for (const QWidget* all : {static_cast<QWidget*>(window.menuBar()),
                               static_cast<QWidget*>(&furtherCommands(window))})
        for (const QAction* menu : all->actions())
            if (menu->menu() && contains(*menu->menu(), &action))
                return !menus.contains(menu->text()) && menu->text() != Text::tr("Settings");
    return false;
}

const app::KeyedCommand* infoOf(const MainWindow& window, const QString& key)
{
    const auto& all = CommandKeys::of(const_cast<MainWindow&>(window)).table().commands();
    const auto found = std::ranges::find(all, key, &app::KeyedCommand::key);
    return found == all.end() ? nullptr : &*found;
}

} // namespace

QAction* commandToShow(MainWindow& window, const QString& key)
{
    for (QAction* action : commands(window))
        if (!key.isEmpty() && action->objectName() == key)
            return staysInDrawing(window, *action) ? action : nullptr;
    return nullptr;
}

QString wordsFor(const MainWindow& window, const app::ShownStep& step)
{
    using Kind = app::ShownStep::Kind;
    if (step.kind == Kind::Command) {
        const app::KeyedCommand* info = infoOf(window, step.command);
        const auto* action = window.findChild<QAction*>(step.command);
        const QString name = step.sentence.isEmpty() ? info ? info->name : step.command
                                                     : step.sentence;
        const QString key =
            action ? action->shortcut().toString(QKeySequence::NativeText) : QString();
        return key.isEmpty() ? name : Text::tr("%1 (%2)").arg(name, key);
    }
    if (step.kind == Kind::Press && step.sentence.isEmpty())
        return Text::tr("Press %1").arg(step.button);
    if (step.kind == Kind::Type)
        return step.sentence.isEmpty() ? Text::tr("Type %1").arg(step.typed)
                                       : Text::tr("%1: %2").arg(step.sentence, step.typed);
    return step.sentence;
}

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
    Canvas& canvas = window_.canvas();
    canvas.fitPage();
    canvas.setFocus();
    bar_ = new ShowBar(window_.centralWidget());
    mark_ = new PointerMark(&window_);
    connect(bar_, &ShowBar::nextWanted, this, &StepPlayer::next);
    connect(bar_, &ShowBar::stopWanted, this, &StepPlayer::stop);
    const app::View& view = canvas.view();
    at_ = aim_ = view.toDrawing(view.size * 0.5);
    qApp->installEventFilter(this);
    bar_->show();
    mark_->show();
    beginStep();
}

void StepPlayer::beginStep()
{
    bar_->say(int(step_) + 1, int(steps_.size()), wordsFor(window_, steps_[step_]));
    bar_->raise();
    aim_ = at_;
    beats_.clear();
    add(steps_[step_]);
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
    beat.act();
    if (!playing_)
        return;
    if (QApplication::activeModalWidget()) // the person's turn
        return stop();
    if (beats_.empty())
        emit stepDone();
    timer_.start(beats_.empty() ? afterStep : beats_.front().wait);
}

void StepPlayer::stop()
{
    if (playing_)
        finish(false);
}

void StepPlayer::finish(bool wholly)
{
    if (down_)
        point(QEvent::MouseButtonRelease, Qt::LeftButton, {}, {});
    down_ = {};
    playing_ = false;
    timer_.stop();
    beats_.clear();
    qApp->removeEventFilter(this);
    delete mark_;
    if (bar_) {
        bar_->hide();
        bar_->deleteLater(); // its button may have been pressed
    }
    emit ended(wholly);
}

app::Point StepPlayer::inDrawing(const app::Point& millimetres) const
{
    const app::Page& page = window_.session().now().page();
    return page.min + millimetres / page.millimetresPerUnit();
}

void StepPlayer::add(const app::ShownStep& step)
{
    using Kind = app::ShownStep::Kind;
    for (std::size_t i = 0; i < step.points.size(); ++i) {
        const bool drags = step.kind == Kind::Drag && i > 0;
        addWay(inDrawing(step.points[i]), drags ? Qt::LeftButton : Qt::NoButton, step.with);
        if (i > 0 || step.kind == Kind::Move)
            continue;
        addPress(step.with, QEvent::MouseButtonPress);
        if (step.kind == Kind::Drag)
            continue;
        addRelease(step.with);
        if (step.kind == Kind::DoubleClick) {
            addPress(step.with, QEvent::MouseButtonDblClick);
            addRelease(step.with);
        }
    }
    if (step.kind == Kind::Drag)
        addRelease(step.with);
    if (step.kind == Kind::Press)
        addButton(step.button);
    for (const auto& key : step.keys)
        beats_.push_back({perKey, [this, key] { press(key); }});
    if (step.kind == Kind::Command)
        beats_.push_back({perButton, [this, name = step.command] {
                              QAction* action = commandToShow(window_, name);
                              if (action && action->isEnabled())
                                  action->trigger();
                          }});
}

/// In a straight line, slowly at its ends.
void StepPlayer::addWay(const app::Point& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers with,
                        Over over)
{
    const app::Point from = aim_;
    for (int i = 1; i <= places; ++i) {
        const double part = double(i) / places, eased = part * part * (3 - 2 * part);
        const app::Point place = i == places ? to : from + (to - from) * eased;
        beats_.push_back({perPlace, [this, place, buttons, with, over] {
                              at_ = place;
                              if (over == Over::Drawing)
                                  point(QEvent::MouseMove, Qt::NoButton, buttons, with);
                              else
                                  markPlace(false);
                          }});
    }
    aim_ = to;
}

void StepPlayer::addPress(Qt::KeyboardModifiers with, QEvent::Type type)
{
    beats_.push_back({perButton, [this, with, type] {
                          down_ = Qt::LeftButton;
                          point(type, Qt::LeftButton, Qt::LeftButton, with);
                      }});
}

void StepPlayer::addRelease(Qt::KeyboardModifiers with)
{
    beats_.push_back({perButton, [this, with] {
                          down_ = {};
                          point(QEvent::MouseButtonRelease, Qt::LeftButton, {}, with);
                      }});
}

/// A button that is seen, wherever it is in the window.
void StepPlayer::addButton(const QString& name)
{
    for (auto* button : window_.findChildren<QAbstractButton*>()) {
        const QStringList names{button->text().remove(u'&'), button->accessibleName(),
                                button->toolTip()};
        if (!button->isVisible() || !button->isEnabled() || !names.contains(name))
            continue;
        const QPoint middle = button->rect().center();
        const QPoint on = areaOf(window_).mapFromGlobal(button->mapToGlobal(middle));
        addWay(window_.canvas().view().toDrawing({on.x(), on.y()}), {}, {}, Over::Bars);
        const auto send = [button = QPointer(button), middle](QEvent::Type type, bool down) {
            QMouseEvent event(type, middle, button->mapToGlobal(QPointF(middle)), Qt::LeftButton,
                              down ? Qt::LeftButton : Qt::NoButton, {});
            QCoreApplication::sendEvent(button, &event);
        };
        for (const bool down : {true, false})
            beats_.push_back({perButton, [this, send, down, button = QPointer(button)] {
                                  markPlace(down);
                                  if (button)
                                      send(down ? QEvent::MouseButtonPress
                                                : QEvent::MouseButtonRelease,
                                           down);
                              }});
        return;
    }
}

void StepPlayer::markPlace(bool pressed)
{
    if (!mark_)
        return;
    const app::Point screen = window_.canvas().view().toScreen(at_);
    mark_->setPressed(pressed);
    mark_->pointAt(areaOf(window_).mapTo(&window_, QPoint(qRound(screen.x), qRound(screen.y))));
    mark_->raise();
}

void StepPlayer::point(QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons,
                       Qt::KeyboardModifiers with)
{
    QWidget& area = areaOf(window_);
    const app::Point screen = window_.canvas().view().toScreen(at_);
    const QPointF place(std::round(screen.x), std::round(screen.y));
    markPlace(buttons != Qt::NoButton);
    QMouseEvent event(type, place, area.mapToGlobal(place), button, buttons, with);
    QCoreApplication::sendEvent(&area, &event);
}

/// As a keyboard does: what has the focus first, then the commands with this key.
void StepPlayer::press(const app::ShownStep::Key& key)
{
    const QPointer<QWidget> receiver(&receiverIn(window_));
    const auto send = [&](QEvent::Type type) {
        QKeyEvent event(type, key.key.key(), key.key.keyboardModifiers(), key.text);
        event.setAccepted(type != QEvent::ShortcutOverride);
        if (receiver)
            QCoreApplication::sendEvent(receiver, &event);
        return event.isAccepted();
    };
    if (!send(QEvent::ShortcutOverride)) {
        if (QShortcut* shortcut = shortcutWith(*receiver, QKeySequence(key.key)))
            return emit shortcut->activated();
        if (QAction* action = commandWith(window_, QKeySequence(key.key))) {
            if (staysInDrawing(window_, *action))
                action->trigger();
            return;
        }
        if (key.key.keyboardModifiers().testFlag(Qt::ControlModifier))
            return; // of a command that cannot be run now
    } else if (key.key.keyboardModifiers().testFlag(Qt::ControlModifier)) {
        return; // a field would fill the clipboard
    }
    send(QEvent::KeyPress);
    send(QEvent::KeyRelease);
}

/// The person's own events in the window, which Qt calls spontaneous.
bool StepPlayer::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &window_ && event->type() == QEvent::Hide && playing_) { // another tab
        QMetaObject::invokeMethod(this, &StepPlayer::stop, Qt::QueuedConnection);
        return false;
    }
    auto* const widget = event->spontaneous() ? qobject_cast<QWidget*>(watched) : nullptr;
    if (!playing_ || !widget || !window_.isAncestorOf(widget)
        || (bar_ && (bar_ == widget || bar_->isAncestorOf(widget))))
        return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        stop();
        return true;
    case QEvent::KeyPress: {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape)
            stop();
        else if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space)
            next();
        return true;
    }
    case QEvent::ShortcutOverride:
        event->accept();
        return true;
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::KeyRelease:
    case QEvent::ContextMenu:
    case QEvent::Wheel:
        return true;
    default:
        return false;
    }
}

} // namespace ui

#include "moc_step_player.cpp"

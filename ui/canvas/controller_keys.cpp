// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_objects.h"
#include "app/session/window_operations.h"
#include "app/session/window_steps.h"
#include "ui/canvas/controller.h"
#include "ui/editing/keeping.h"
#include "ui/tools/group_choice.h"

#include <array>

// The keys that work while the canvas has the focus.

namespace ui {
namespace {

constexpr double zoomStep = 1.25, panStep = 48; // pixels
constexpr double larger = 10;                   // factor with Shift

bool has(const QKeyEvent& event, Qt::KeyboardModifiers modifiers)
{
    return (event.modifiers() & ~Qt::KeypadModifier) == modifiers;
}

bool isOneOf(int key, std::initializer_list<int> keys)
{
    return std::ranges::find(keys, key) != keys.end();
}

std::optional<app::Point> directionOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return app::Point(-1, 0);
    case Qt::Key_Right:
        return app::Point(1, 0);
    case Qt::Key_Up:
        return app::Point(0, -1);
    case Qt::Key_Down:
        return app::Point(0, 1);
    default:
        return std::nullopt;
    }
}

} // namespace

bool Controller::keyPress(QKeyEvent& event)
{
    if (event.key() == Qt::Key_Space && has(event, Qt::NoModifier) && !tool_->busy()) {
        space_ = true;
        emit changed();
        return true;
    }
    if (beginsTyping(event)) {
        beginTyping(event);
        return true;
    }
    if (keepsFromShortcuts(event))
        return true;
    bool used = false;
    withTool([&] { used = tool_->as<TakesKeys>().key(event, bench_); });
    if (used)
        steer(); // the key may have changed what is measured
    return used || (event.key() == Qt::Key_Escape && escape()) || arrow(event)
           || navigationKey(event) || toolKey(event) || transformKey(event) || windowKey(event)
           || capsuleKey(event);
}

bool Controller::keyRelease(QKeyEvent& event)
{
    if (event.key() != Qt::Key_Space || event.isAutoRepeat())
        return false;
    space_ = false;
    panningFrom_.reset();
    emit changed();
    return true;
}

// Backs out one level: first the gesture, then the group, then the selection, then the tool.
bool Controller::escape()
{
    if (releaseLocked())
        return true;
    if (guide_.going()) {
        guide_.cancel();
        snap_.reset();
    } else if (tool_->busy()) {
        endGesture();
    } else if (session_.entered.id() != 0) {
        leaveGroup(session_);
    } else if (!session_.selection().empty() || session_.inspected()) {
        session_.select({});
        session_.inspect(std::nullopt);
    } else if (toolInfo_ != &tools().front()) {
        setTool(tools().front().key);
    } else {
        return false; // the window may have something to leave
    }
    return true;
}

bool Controller::arrow(const QKeyEvent& event)
{
    const auto direction = directionOf(event.key());
    const auto others =
        Qt::KeyboardModifiers(Qt::KeypadModifier | Qt::ShiftModifier | Qt::AltModifier);
    if (!direction || (event.modifiers() & ~others) || tool_->busy())
        return false;
    const app::Point by = *direction * nudge(bench_, event.modifiers());
    if (event.modifiers() & Qt::AltModifier) {
        app::moveWindow(session_, by, app::Merging::WithLast);
    } else if (!session_.selection().empty()) {
        session_.history.push(new app::MoveObjects(session_.document, session_.selection(), by,
                                                   app::Merging::WithLast));
    } else {
        navigation_.pan(QPointF(-direction->x, -direction->y)
                        * (event.modifiers() & Qt::ShiftModifier ? larger : 1) * panStep);
    }
    return true;
}

bool Controller::actsOnWindow() const
{
    return toolInfo_->showsHandles()
           && (toolInfo_->key == "window" ? session_.windowChosen() : session_.windowChosenLast());
}

/// Of the chosen clip window, as in its capsule.
bool Controller::windowKey(const QKeyEvent& event)
{
    const bool commands = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
    if (commands || gestureGoes() || !actsOnWindow())
        return false;
    for (const app::WindowOperationInfo& each : app::windowOperations())
        if (event.text() == each.letter) {
            app::setWindowOperation(session_, *session_.windowNumber(), each.operation);
            return true;
        }
    if (event.key() == Qt::Key_X) {
        keepOtherSide(session_);
        return true;
    }
    // With this tool only: Esc leaves it, and Tab moves the focus again.
    const bool goesOn = isOneOf(event.key(), {Qt::Key_Tab, Qt::Key_Backtab});
    return goesOn && toolInfo_->key == "window"
           && app::chooseNeighbour(session_, event.key() == Qt::Key_Tab ? 1 : -1);
}

bool Controller::capsuleKey(const QKeyEvent& event)
{
    const bool isEnter = isOneOf(event.key(), {Qt::Key_Return, Qt::Key_Enter});
    if (!isEnter || !has(event, Qt::NoModifier) || gestureGoes() || capsulePlace_.isEmpty())
        return false;
    emit capsuleWanted();
    return true;
}

bool Controller::navigationKey(const QKeyEvent& event)
{
    const QPointF middle(view().size.x / 2, view().size.y / 2);
    const bool control = event.modifiers() & Qt::ControlModifier;
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    if (control && isOneOf(event.key(), {Qt::Key_Plus, Qt::Key_Equal}))
        navigation_.zoomAt(middle, zoomStep);
    else if (control && isOneOf(event.key(), {Qt::Key_Minus, Qt::Key_Underscore}))
        navigation_.zoomAt(middle, 1 / zoomStep);
    else if (control && event.key() == Qt::Key_0)
        setZoom(1);
    // The key with Shift depends on the keyboard layout.
    else if (shift && isOneOf(event.key(), {Qt::Key_1, Qt::Key_Exclam}))
        fitDrawing();
    else if (shift && isOneOf(event.key(), {Qt::Key_2, Qt::Key_At, Qt::Key_QuoteDbl}))
        fitSelection();
    else if (shift && clipWindow()
             && isOneOf(event.key(),
                        {Qt::Key_3, Qt::Key_NumberSign, Qt::Key_sterling, Qt::Key_section}))
        fitWindow();
    else if (shift && isOneOf(event.key(), {Qt::Key_4, Qt::Key_Dollar, Qt::Key_currency}))
        fitPage();
    else if (event.key() == Qt::Key_QuoteLeft)
        navigation_.back();
    else if (event.key() == Qt::Key_AsciiTilde)
        navigation_.forth();
    else
        return false;
    return true;
}

bool Controller::transformKey(const QKeyEvent& event)
{
    if (!has(event, Qt::NoModifier))
        return false;
    for (const app::Transformation& kind : app::transformations())
        if (event.key() == kind.letter.unicode()) {
            transform(kind);
            return true;
        }
    return false;
}

bool Controller::toolKey(const QKeyEvent& event)
{
    if (!has(event, Qt::NoModifier))
        return false;
    for (const ToolInfo& info : tools())
        if (info.shortcut == QKeySequence(event.key())) {
            setTool(info.key);
            return true;
        }
    return false;
}

} // namespace ui

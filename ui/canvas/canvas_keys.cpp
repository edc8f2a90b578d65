// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_keys.h"

#include "app/commands/move_objects.h"
#include "app/document/window_operations.h"
#include "app/session/window_steps.h"
#include "ui/canvas/typing_keys.h"
#include "ui/canvas/view_commands.h"
#include "ui/editing/keeping.h"
#include "ui/tools/group_choice.h"

#include <algorithm>
#include <array>

namespace ui {
namespace {

constexpr double panStep = 48; // pixels
constexpr double larger = 10;  // factor with Shift

bool isPlain(const QKeyEvent& event) { return !(event.modifiers() & ~Qt::KeypadModifier); }

bool isEnter(const QKeyEvent& event)
{
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// Backs out one level: first the gesture, then the group, then the selection, then the tool.
bool escape(const QKeyEvent& event, Controller& controller)
{
    if (event.key() != Qt::Key_Escape)
        return false;
    app::Session& session = controller.session();
    if (controller.typing().releaseLocked())
        return true;
    if (controller.pointing().guide().going()) {
        controller.pointing().cancelGuide();
    } else if (controller.held().busy()) {
        controller.endGesture();
    } else if (session.entered.id() != 0) {
        leaveGroup(session);
    } else if (!session.selection().empty() || session.inspected()) {
        session.select({});
        session.inspect(std::nullopt);
    } else if (&controller.toolInfo() != &tools().front()) {
        controller.held().choose(tools().front().key);
    } else {
        return false; // the window may have something to leave
    }
    return true;
}

bool arrow(const QKeyEvent& event, Controller& controller)
{
    const int key = event.key();
    const app::Point direction(int(key == Qt::Key_Right) - int(key == Qt::Key_Left),
                               int(key == Qt::Key_Down) - int(key == Qt::Key_Up));
    const auto others =
        Qt::KeyboardModifiers(Qt::KeypadModifier | Qt::ShiftModifier | Qt::AltModifier);
    if (direction == app::Point(0) || (event.modifiers() & ~others) || controller.held().busy())
        return false;
    app::Session& session = controller.session();
    const app::Point by = direction * nudge(controller.bench(), event.modifiers());
    if (event.modifiers() & Qt::AltModifier) {
        app::moveWindow(session, by, app::Merging::WithLast);
    } else if (!session.selection().empty()) {
        session.history.push(new app::MoveObjects(session.document, session.selection(), by,
                                                  app::Merging::WithLast));
    } else {
        controller.navigation().pan(QPointF(-direction.x, -direction.y)
                                    * (event.modifiers() & Qt::ShiftModifier ? larger : 1)
                                    * panStep);
    }
    return true;
}

bool viewKey(const QKeyEvent& event, Controller& controller)
{
    return keyOfView(event, controller.session(), controller.navigation());
}

bool toolKey(const QKeyEvent& event, Controller& controller)
{
    if (!isPlain(event))
        return false;
    for (const ToolInfo& info : tools())
        if (info.shortcut == QKeySequence(event.key())) {
            controller.held().choose(info.key);
            return true;
        }
    return false;
}

bool transformKey(const QKeyEvent& event, Controller& controller)
{
    for (const app::Transformation& kind : app::transformations())
        if (controller.keys().isOf(event, kind.key, QKeySequence(QString(kind.letter)))) {
            controller.transform(kind);
            return true;
        }
    return false;
}

/// Of the chosen clip window, as in its capsule.
bool windowKey(const QKeyEvent& event, Controller& controller)
{
    app::Session& session = controller.session();
    if (controller.gestureGoes() || !controller.actsOnWindow())
        return false;
    for (const app::WindowOperationInfo& each : app::windowOperations())
        if (controller.keys().isOf(event, each.key, QKeySequence(each.letter))) {
            app::setWindowOperation(session, *session.windowNumber(), each.operation);
            return true;
        }
    if (controller.keys().isOf(event, keepOutside, QKeySequence(Qt::Key_X))) {
        keepOtherSide(session);
        return true;
    }
    // With this tool only: Esc leaves it, and Tab moves the focus again.
    const bool forth = event.key() == Qt::Key_Tab, back = event.key() == Qt::Key_Backtab;
    const bool commands = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
    return (forth || back) && !commands && controller.toolInfo().key == "window"
           && app::chooseNeighbour(session, forth ? 1 : -1);
}

bool capsuleKey(const QKeyEvent& event, Controller& controller)
{
    if (!isEnter(event) || !isPlain(event) || controller.gestureGoes() || !controller.capsule())
        return false;
    emit controller.capsuleWanted();
    return true;
}

/// Ends a box whose size is known while the pointer waits: the last one's, or what is typed.
bool acceptKey(const QKeyEvent& event, Controller& controller)
{
    const auto& readout = controller.typing().readout();
    if (!isEnter(event) || !isPlain(event) || !controller.held().busy() || !readout
        || !readout->gauge().alike)
        return false;
    controller.typing().accept();
    return true;
}

struct Use {
    bool (*take)(const QKeyEvent& event, Controller& controller);
    bool isOfCommand = false; ///< left to the commands, where these have keys
};
/// In the order in which they are asked.
constexpr std::array uses{Use{acceptKey},     Use{escape},       Use{arrow},     Use{viewKey, true},
                          Use{toolKey, true}, Use{transformKey}, Use{windowKey}, Use{capsuleKey}};

} // namespace

bool takesKey(const QKeyEvent& event, const Controller& controller)
{
    return controller.held().as<TakesKeys>().wants(event, controller.bench())
           || beginsTyping(event, controller) || keepsFromShortcuts(event, controller);
}

bool pressKey(QKeyEvent& event, Controller& controller)
{
    if (event.key() == Qt::Key_Space && isPlain(event) && !controller.held().busy()) {
        controller.pointing().setSpace(true);
        return true;
    }
    if (beginsTyping(event, controller)) {
        beginTyping(event, controller);
        return true;
    }
    if (keepsFromShortcuts(event, controller))
        return true;
    bool used = false;
    controller.held().use(
        [&](Tool& tool, Workbench& bench) { used = tool.as<TakesKeys>().key(event, bench); });
    if (used)
        controller.typing().steer(); // the key may have changed what is measured
    return used || std::ranges::any_of(uses, [&](const Use& use) {
               return !(use.isOfCommand && controller.leavesKeys()) && use.take(event, controller);
           });
}

bool releaseKey(const QKeyEvent& event, Controller& controller)
{
    if (event.key() != Qt::Key_Space || event.isAutoRepeat())
        return false;
    controller.pointing().stopPanning();
    controller.pointing().setSpace(false);
    return true;
}

} // namespace ui

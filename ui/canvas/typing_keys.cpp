// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/typing_keys.h"

#include "app/settings/usable_key.h"

namespace ui {

/// The text with which typing begins; empty: the key types no number.
static QString firstTyped(const QKeyEvent& event, bool points)
{
    // Shift+2 and Shift+3 fit the view, unless a point can begin here.
    const auto others =
        ~Qt::KeyboardModifiers(Qt::ShiftModifier | Qt::KeypadModifier | Qt::GroupSwitchModifier);
    if (event.text().size() != 1 || (event.modifiers() & others))
        return {};
    const QChar first = event.text().front();
    const bool begins =
        app::beginNumber.contains(first) || (points && app::beginPoint.contains(first));
    return begins ? event.text() : QString();
}

/// Enter opens the numbers of what was just done, also where digits have another use.
bool beginsTyping(const QKeyEvent& event, const Controller& controller)
{
    if (!controller.typing().takesNumbers())
        return false;
    const bool busy = controller.held().busy(), goes = controller.gestureGoes();
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    const bool opens =
        goes ? busy && event.key() == Qt::Key_Tab
             : enter && controller.held().as<TypesNumbers>().enterOpens(controller.bench());
    if (opens && !(event.modifiers() & ~Qt::KeypadModifier))
        return true;
    const auto points = controller.typing().readout()->gauge().measure->points;
    const bool point = busy || points == app::GestureMeasure::Points::Absolute;
    const QString first = firstTyped(event, point);
    // A sign says what the chosen clip window does, where digits choose its algorithm.
    const bool forWindow =
        !goes && controller.actsOnWindow() && controller.keys().isOfWindow(event);
    return !first.isEmpty() && !forWindow
           && (!first.front().isDigit() || controller.digitUse() == app::DigitUse::Number);
}

void beginTyping(const QKeyEvent& event, Controller& controller)
{
    controller.typing().begin(firstTyped(event, true), event.key() == Qt::Key_Tab);
}

bool keepsFromShortcuts(const QKeyEvent& event, const Controller& controller)
{
    return controller.gestureGoes() && !firstTyped(event, false).isEmpty();
}

} // namespace ui

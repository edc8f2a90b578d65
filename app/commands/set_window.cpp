// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_window.h"

#include <QCoreApplication>

namespace app {

static QString nameOf(const clipping::Window& before, const clipping::Window& after)
{
    const char* const move = QT_TRANSLATE_NOOP("Commands", "Move clip window");
    const char* const resize = QT_TRANSLATE_NOOP("Commands", "Resize clip window");
    const Point change = (after.max - after.min) - (before.max - before.min);
    const double slack =
        1e-9 * (std::abs(after.max.x) + std::abs(after.max.y) + std::abs(after.min.x));
    const bool same = std::abs(change.x) <= slack && std::abs(change.y) <= slack;
    return QCoreApplication::translate("Commands", same ? move : resize);
}

SetWindow::SetWindow(Drawing& drawing, const clipping::Window& window, Merging merging)
    : UndoCommand(row, nameOf(drawing.sheet().window, window), merging), drawing_(drawing),
      before_(drawing.sheet().window), after_(window)
{
}

bool SetWindow::mergeWith(const UndoCommand& next)
{
    after_ = static_cast<const SetWindow&>(next).after_;
    return true;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_window.h"

#include "app/scene/compared_window.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

static QString nameOf(const std::optional<clipping::Window>& before, const clipping::Window& after)
{
    if (!before)
        return QCoreApplication::translate("Commands", "Draw clip window");
    const char* const move = QT_TRANSLATE_NOOP("Commands", "Move clip window");
    const char* const resize = QT_TRANSLATE_NOOP("Commands", "Resize clip window");
    const Point change = (after.max - after.min) - (before->max - before->min);
    const double slack =
        1e-9 * (std::abs(after.max.x) + std::abs(after.max.y) + std::abs(after.min.x));
    const bool same = std::abs(change.x) <= slack && std::abs(change.y) <= slack;
    return QCoreApplication::translate("Commands", same ? move : resize);
}

SetWindow::SetWindow(EditedDocument& document, const clipping::Window& window, Merging merging)
    : EditCommand(row, document, {.windows = withWindow(document.now().windows(), window)},
                  nameOf(firstWindow(document.now().windows()), window), merging)
{
}

} // namespace app

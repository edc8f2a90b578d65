// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_window.h"

#include "app/document/compared_window.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

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

// The first window that is an axis-aligned rectangle, or a new one.
static Edit moved(const Document& document, const clipping::Window& window)
{
    Edit edit;
    edit.windows = document.windows();
    auto& list = edit.windows->list;
    const auto first = std::ranges::find_if(
        list, [](const ClipWindow& w) { return w.visible && axisAlignedBox(w.shape).has_value(); });
    if (first == list.end())
        list.push_back({.shape = RectangleShape{window}});
    else
        first->shape = RectangleShape{window};
    return edit;
}

SetWindow::SetWindow(EditedDocument& document, const clipping::Window& window, Merging merging)
    : EditCommand(row, document, moved(document.now(), window),
                  nameOf(comparedWindow(document.now().windows(), document.now().page()).window,
                         window),
                  merging)
{
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/which_text.h"

#include "app/base/numbers.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

QString whichText(const ClipWindows& windows)
{
    const auto& list = windows.list;
    const auto found = std::ranges::find_if(
        list, [](const ClipWindow& w) { return w.visible && axisAlignedBox(w.shape); });
    if (list.size() < 2 || found == list.end())
        return {};
    const QString text =
        QCoreApplication::translate("WindowPanel", "Window %1 of %2")
            .arg(countText(std::size_t(found - list.begin()) + 1), countText(list.size()));
    return found->name.isEmpty() ? text : QStringLiteral("%1: %2").arg(text, found->name);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/which_text.h"

#include "app/base/numbers.h"

#include <QCoreApplication>

namespace app {

QString whichText(const ClipWindows& windows, std::optional<std::size_t> number)
{
    const auto& list = windows.list;
    if (list.size() < 2 || !number)
        return {};
    const QString text = QCoreApplication::translate("WindowPanel", "Window %1 of %2")
                             .arg(countText(*number + 1), countText(list.size()));
    const QString& name = list[*number].name;
    return name.isEmpty() ? text : QStringLiteral("%1: %2").arg(text, name);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/fresh_ids.h"

namespace app {

QString FreshIds::next(const QString& id)
{
    if (id.isEmpty())
        return {};
    if (!std::exchange(known_, true)) {
        document_.objects().forEach(
            0, document_.objects().size(),
            [&](std::size_t, const ObjectView& object) { taken_.insert(object.particulars().id); });
        for (const ContainerId each : document_.containers().inOrder())
            taken_.insert(document_.containers()[each].svgId);
    }
    for (int number = 2;; ++number)
        if (const QString fresh = QStringLiteral("%1-%2").arg(id).arg(number);
            !taken_.contains(fresh)) {
            taken_.insert(fresh);
            return fresh;
        }
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/cut_text.h"

#include "app/view/numbers.h"

#include <QCoreApplication>
#include <QStringList>

namespace app {

QString cutText(const CutCounts& counts)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("cut", text); };
    QStringList parts;
    const auto add = [&](std::size_t count, const char* text) {
        if (count > 0)
            parts << tr(text).arg(countText(count));
    };
    add(counts.whole, "%1 whole");
    add(counts.cut, "%1 cut");
    add(counts.gone, "%1 left out");
    QString text = parts.isEmpty() ? tr("there was nothing to cut.")
                                   : tr("shapes %1.").arg(parts.join(tr(", ")));
    if (counts.opened > 0)
        text += u' ' + tr("Opened: %1.").arg(countText(counts.opened));
    if (counts.unfilled > 0)
        text += u' ' + tr("Fill lost: %1.").arg(countText(counts.unfilled));
    return text;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/traced_line.h"

#include "app/base/latin.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("narration", text); }

} // namespace

QString refusalOf(const TracedLine& tracedLine)
{
    if (tracedLine.variant.misprint)
        return tr("This is a known misprint: its steps are not recorded.");
    const auto& [a, b] = tracedLine.line;
    const auto& [min, max] = tracedLine.window;
    struct Row {
        const char* name;
        double value;
    };
    for (const Row& row :
         {Row{"x1", a.x}, Row{"y1", a.y}, Row{"x2", b.x}, Row{"y2", b.y}, Row{"xmin", min.x},
          Row{"ymin", min.y}, Row{"xmax", max.x}, Row{"ymax", max.y}})
        if (!std::isfinite(row.value))
            return tr("%1 is not a finite number: nothing is clipped. Give it another value.")
                .arg(latin(row.name));
    if (min.x > max.x || min.y > max.y)
        return tr("The window's minimum lies beyond its maximum: nothing is clipped. Swap them.");
    return {};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/icon_sign.h"

#include "ui/look/look_icon.h"

namespace ui {

QIcon dashIcon(const app::DashPattern& pattern)
{
    return paintedIcon({36, 12}, [&pattern](QPainter& painter, const Look& look) {
        QPen pen(look.text, 1.5, Qt::SolidLine, Qt::FlatCap);
        if (!pattern.dashes.empty())
            pen.setDashPattern(QList<qreal>(pattern.dashes.begin(), pattern.dashes.end()));
        painter.setPen(pen);
        painter.drawLine(QPointF(0, 6), QPointF(36, 6));
    });
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/dash_icon.h"

#include <QPainter>

namespace ui {

QIcon dashIcon(const app::DashPattern& pattern, const QColor& colour)
{
    QPixmap picture(72, 24);
    picture.setDevicePixelRatio(2);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    QPen pen(colour, 1.5, Qt::SolidLine, Qt::FlatCap);
    if (!pattern.dashes.empty())
        pen.setDashPattern(QList<qreal>(pattern.dashes.begin(), pattern.dashes.end()));
    painter.setPen(pen);
    painter.drawLine(QPointF(0, 6), QPointF(36, 6));
    return picture;
}

} // namespace ui

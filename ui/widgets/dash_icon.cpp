// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/dash_icon.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace ui {

std::span<const DashPattern> dashPatterns()
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("Dashes", text); };
    static const std::array all{
        DashPattern{tr("Solid"), {}},
        DashPattern{tr("Dashed"), {6, 3}},
        DashPattern{tr("Dotted"), {1, 2}},
        DashPattern{tr("Dash and dot"), {8, 3, 1, 3}},
    };
    return all;
}

std::vector<double> scaled(const DashPattern& pattern, double width)
{
    std::vector<double> dashes = pattern.dashes;
    for (double& dash : dashes)
        dash *= width;
    return dashes;
}

int patternOf(const app::Style& style)
{
    const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    for (std::size_t i = 0; i < dashPatterns().size(); ++i)
        if (std::ranges::equal(style.dashes, scaled(dashPatterns()[i], style.width), close))
            return int(i);
    return -1;
}

QIcon dashIcon(const DashPattern& pattern, const QColor& colour)
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

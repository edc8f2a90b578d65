// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/chart_look.h"

#include <QGuiApplication>

namespace app {

ChartLook chartLook(Ground ground)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return ground == Ground::Light
               ? ChartLook{ground, 0xFFFFFF, 0x1B1E23, 0x565D67, 0xD0D4DA, font}
               : ChartLook{ground, 0x2B2D32, 0xE7E9EC, 0xA6ACB6, 0x3A3D44, font};
}

} // namespace app

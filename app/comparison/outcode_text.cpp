// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/outcode_text.h"

namespace app {

QString outcodeText(unsigned code)
{
    return QStringLiteral("%1%2%3%4")
        .arg(code >> 3 & 1U)
        .arg(code >> 2 & 1U)
        .arg(code >> 1 & 1U)
        .arg(code & 1U);
}

QString outcodeBits() { return QStringLiteral("y > ymax, y < ymin, x > xmax, x < xmin"); }

} // namespace app

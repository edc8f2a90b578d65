// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QCoreApplication>

namespace app {

Format svgFormat()
{
    return {"svg", QCoreApplication::translate("formats", "SVG drawing"), nullptr, nullptr};
}

} // namespace app

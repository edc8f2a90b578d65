// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/reader.h"
#include "app/formats/svg/writer.h"

#include <QCoreApplication>

namespace app {

Format svgFormat()
{
    return {"svg", QCoreApplication::translate("formats", "SVG drawing"), svg::read, svg::write};
}

} // namespace app

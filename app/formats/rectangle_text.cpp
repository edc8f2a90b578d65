// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/rectangle_text.h"

#include "app/base/number.h"

namespace app {

QString rectangleText(const clipping::Window& rectangle)
{
    const auto& [min, max] = rectangle;
    std::string text;
    for (const double number : {min.x, min.y, max.x, max.y}) {
        if (!text.empty())
            text += ',';
        appendNumber(text, number);
    }
    return QString::fromStdString(text);
}

} // namespace app

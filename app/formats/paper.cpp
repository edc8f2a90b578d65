// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/paper.h"

namespace app {

Paper paperOf(const Page& page)
{
    const double unit = page.millimetresPerUnit();
    const auto size = [&](Length length, double units) { // in user units
        const double ratio = infoOf(length.unit).millimetres / unit;
        return length.value * ratio > 0 ? length.value * ratio
                                        : units; // an open size equals that of the page
    };
    const Point paper{size(page.width, page.size.x), size(page.height, page.size.y)};
    return {paper * unit, unit, page.min - (paper - page.size) / 2.0};
}

} // namespace app

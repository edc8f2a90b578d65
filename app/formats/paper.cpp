// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/paper.h"

namespace app {

Paper paperOf(const Page& page)
{
    const double unit = page.millimetresPerUnit();
    const auto size = [&](Length length, double units) {
        const double millimetres = length.value * infoOf(length.unit).millimetres;
        return millimetres > 0 ? millimetres
                               : units * unit; // as large as the page where it is open
    };
    const Point paper{size(page.width, page.size.x), size(page.height, page.size.y)};
    return {paper, unit, page.min - (paper / unit - page.size) / 2.0};
}

} // namespace app

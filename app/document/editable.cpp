// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/editable.h"

#include <algorithm>
#include <functional>

namespace app {

// A layer is one range, apart from what is hidden in it.
ObjectRanges editableObjects(const Sheet& sheet)
{
    ObjectRanges editable;
    const auto begin = sheet.shapes.begin();
    auto first = begin;
    for (std::uint32_t layer = 0; layer < sheet.layers.size(); ++layer) {
        const auto end =
            std::ranges::upper_bound(first, sheet.shapes.end(), layer, {}, &Shape::layer);
        const bool open = sheet.layers[layer].visible && !sheet.layers[layer].locked;
        while (open && first != end) {
            const auto hidden = std::find_if(first, end, std::mem_fn(&Shape::hidden));
            editable.insert(ObjectRange{std::size_t(first - begin), std::size_t(hidden - begin)});
            first = std::find_if_not(hidden, end, std::mem_fn(&Shape::hidden));
        }
        first = end;
    }
    return editable;
}

} // namespace app

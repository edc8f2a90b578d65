// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/patch.h"

#include <algorithm>

namespace app {

constexpr std::size_t mostRuns = 16;

static void exchange(Drawing& drawing, Patch& patch)
{
    const std::size_t count = patch.shapes.size();
    patch.shapes = drawing.splice(patch.first, patch.count, std::move(patch.shapes));
    patch.count = count;
}

void apply(Drawing& drawing, Patches& patches)
{
    std::for_each(patches.rbegin(), patches.rend(), [&](Patch& p) { exchange(drawing, p); });
}

void revert(Drawing& drawing, Patches& patches)
{
    std::ranges::for_each(patches, [&](Patch& p) { exchange(drawing, p); });
}

Patches patchesOf(const Sheet& sheet, const std::set<std::size_t>& shapes,
                  const std::function<bool(Shape&)>& change)
{
    std::size_t runs = 0;
    for (auto i = shapes.begin(); i != shapes.end(); ++i)
        runs += i == shapes.begin() || *std::prev(i) + 1 != *i;
    Patches patches;
    for (const std::size_t index : shapes) {
        const bool next = !patches.empty() && patches.back().first + patches.back().count == index;
        if (patches.empty() || (!next && runs <= mostRuns))
            patches.push_back({index, 0, {}});
        Patch& patch = patches.back();
        for (std::size_t between = patch.first + patch.count; between < index;
             ++between, ++patch.count)
            patch.shapes.push_back(sheet.shapes[between]);
        Shape shape = sheet.shapes[index];
        if (change(shape))
            patch.shapes.push_back(std::move(shape));
        ++patch.count;
    }
    return patches;
}

} // namespace app

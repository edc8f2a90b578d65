// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/patch.h"

#include <algorithm>

namespace app {

constexpr std::size_t mostRanges = 16;

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

bool samePlaces(const Patches& first, const Patches& second)
{
    return std::ranges::equal(first, second, [](const Patch& a, const Patch& b) {
        return a.first == b.first && a.count == b.count && a.count == a.shapes.size()
               && b.count == b.shapes.size();
    });
}

Patches patchesOf(const Sheet& sheet, const ObjectRanges& shapes,
                  const std::function<bool(Shape&)>& change)
{
    const bool asOne = shapes.ranges().size() > mostRanges;
    Patches patches;
    for (const ObjectRange& range : shapes.ranges()) {
        if (patches.empty() || !asOne)
            patches.push_back({range.first, 0, {}});
        Patch& patch = patches.back();
        for (std::size_t between = patch.first + patch.count; between < range.first; ++between)
            patch.shapes.push_back(sheet.shapes[between]);
        for (std::size_t index = range.first; index < range.end; ++index) {
            Shape shape = sheet.shapes[index];
            if (change(shape))
                patch.shapes.push_back(std::move(shape));
        }
        patch.count = range.end - patch.first;
    }
    return patches;
}

} // namespace app

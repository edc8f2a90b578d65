// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/styles_in_use.h"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <unordered_set>

namespace app {
namespace {

/// Calls visit(style, count) for each run of objects of the range that have the same style.
template <class Visit>
void forEachRun(const Objects& objects, const ObjectRange& range, const Visit& visit)
{
    std::size_t block = range.empty() ? 0 : objects.blockOf(range.first);
    for (std::size_t i = range.first; i < range.end; ++block) {
        const ObjectBlock& here = *objects.blocks()[block];
        const std::size_t first = objects.firstOf(block);
        const std::size_t end = std::min(range.end, first + here.size());
        if (here.styles.size() == 1)
            visit(here.styles.front(), end - i);
        else
            for (std::size_t j = i; j < end; ++j)
                visit(here.styles[j - first], std::size_t(1));
        i = end;
    }
}

struct Use {
    Colour colour;
    std::size_t count;
};

/// How often each colour is used, in the order of the drawing.
class Uses {
public:
    void add(const std::optional<Colour>& colour, std::size_t count)
    {
        if (!colour || colour->alpha == 0)
            return;
        const auto [at, isNew] =
            known_.try_emplace(std::bit_cast<std::uint32_t>(*colour), all_.size());
        if (isNew)
            all_.push_back({*colour, 0});
        all_[at->second].count += count;
    }
    std::vector<Use> take() { return std::move(all_); }

private:
    std::vector<Use> all_;
    std::unordered_map<std::uint32_t, std::size_t> known_;
};

} // namespace

std::vector<StyleIndex> stylesOf(const Objects& objects, const ObjectRanges& chosen)
{
    std::vector<StyleIndex> found;
    std::unordered_set<StyleIndex> known;
    for (const ObjectRange& range : chosen.ranges())
        forEachRun(objects, range, [&](StyleIndex style, std::size_t) {
            if ((found.empty() || found.back() != style) && known.insert(style).second)
                found.push_back(style);
        });
    return found;
}

std::vector<Colour> coloursInUse(const Objects& objects, std::size_t most)
{
    std::vector<StyleIndex> order;
    std::unordered_map<StyleIndex, std::size_t> counts;
    forEachRun(objects, {0, objects.size()}, [&](StyleIndex style, std::size_t count) {
        const auto [at, isNew] = counts.try_emplace(style, 0);
        if (isNew)
            order.push_back(style);
        at->second += count;
    });
    Uses uses;
    for (const StyleIndex style : order) {
        uses.add(objects.styles()[style].stroke, counts[style]);
        uses.add(objects.styles()[style].fill, counts[style]);
    }
    std::vector<Use> all = uses.take();
    std::ranges::stable_sort(all, std::ranges::greater{}, &Use::count);
    std::vector<Colour> colours;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i)
        colours.push_back(all[i].colour);
    return colours;
}

} // namespace app

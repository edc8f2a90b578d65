// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/finite.h"
#include "app/scene/divided_line.h"
#include "clipping/outside.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

// Whether a point is in the set after a step, given whether it was before and whether it is in the
// step's window.
bool isInAfter(WindowOperation operation, bool before, bool inWindow)
{
    if (operation == WindowOperation::Add)
        return before || inWindow;
    return before && (operation == WindowOperation::CutOut) != inWindow;
}

// Whether points outside all windows are kept.
bool keepsUnseen(const ClipRegion& region)
{
    bool in = region.startsFull();
    for (const auto& step : region.steps)
        in = isInAfter(step.operation, in, false);
    return region.everything() || in == (region.keep == Keep::Inside);
}

// Whether a line is kept if each window contains all or nothing of it; empty if a window cuts it.
std::optional<bool> keepsUncut(const ClipRegion& region, const Segment& line, PiecesOfLine atStep)
{
    bool in = region.startsFull();
    for (std::size_t i = 0; i < atStep.size(); ++i) {
        const bool seen = isSeen(atStep[i]);
        if (seen && std::memcmp(&atStep[i]->segment, &line, sizeof line) != 0)
            return std::nullopt;
        in = isInAfter(region.steps[i].operation, in, seen);
    }
    return in == (region.keep == Keep::Inside);
}

// One window of which the pieces need no dividing.
bool isUndividedWindow(const ClipRegion& region)
{
    return region.steps.size() == 1 && region.steps.front().operation != WindowOperation::CutOut;
}

void foldSingle(Keep keep, const Segment& line, std::uint32_t source, std::optional<Clipped> piece,
                std::vector<Clipped>& kept)
{
    if (keep == Keep::Outside) {
        std::array<Clipped, 2> outside{};
        if (piece)
            piece->source = 0;
        const std::span inside(piece ? &*piece : nullptr, piece ? 1 : 0);
        const std::size_t count = clipping::outsideAll(std::span(&line, 1), inside, outside);
        for (Clipped& each : std::span(outside).first(count))
            kept.push_back({each.segment, source, each.cut});
    } else if (piece) {
        kept.push_back({piece->segment, source, piece->cut});
    }
}

} // namespace

bool isSeen(const std::optional<Clipped>& piece) { return piece && isFinite(piece->segment); }

void fold(const ClipRegion& region, const Segment& line, std::uint32_t source, PiecesOfLine atStep,
          std::vector<Clipped>& kept)
{
    assert(atStep.size() == region.steps.size());
    if (isUndividedWindow(region)) {
        foldSingle(region.keep, line, source, isSeen(atStep[0]) ? atStep[0] : std::nullopt, kept);
        return;
    }
    std::optional<bool> keeps = keepsUnseen(region);
    if (isFinite(line) && std::ranges::any_of(atStep, isSeen))
        keeps = keepsUncut(region, line, atStep);
    if (!keeps)
        foldDivided(region, line, source, atStep, kept);
    else if (*keeps)
        kept.push_back({line, source, 0});
}

} // namespace app

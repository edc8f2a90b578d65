// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/region_clipping.h"

#include "app/scene/area_windows.h"
#include "clipping/outside.h"

#include <algorithm>
#include <cmath>

namespace app {

using clipping::Clipped;
using clipping::Segment;

// Lines clipped at all windows before they are folded; limits the buffer to a few KiB for each
// window.
constexpr std::size_t foldedAtOnce = 1024;

// Pieces between two readings of the stop token: some hundredths of a second where a line has
// thousands of them.
constexpr std::size_t mostPiecesAtOnce = 65'536;

static std::span<Clipped> roomIn(std::vector<Clipped>& buffer, std::size_t count)
{
    if (buffer.size() < count)
        buffer.resize(count);
    return std::span(buffer).first(count);
}

// Pieces of published forms in odd directions are put right only by folding.
static bool isOneWindow(const ClipRegion& region, const RowForms& forms)
{
    return region.steps.size() == 1 && !forms.atRegion
           && (region.single() || forms.exact || !region.steps.front().rings.empty());
}

void RegionClipping::start(const ClipRegion& region, ClipAll clipAll, const std::stop_token& stop)
{
    Started& now = started_ = {.region = &region, .stop = stop, .forms = formsAt(region, clipAll)};
    if (now.forms.atRegion && !region.everything())
        now.prepared = areaWindows(region);
    now.oneWindow = isOneWindow(region, now.forms);
    now.keepsInside =
        (region.keep == Keep::Inside)
        != (now.oneWindow && region.steps.front().operation == WindowOperation::CutOut);
    stopwatch_.reset();
}

void RegionClipping::startAs(const RegionClipping& other)
{
    started_ = other.started_;
    stopwatch_.reset();
}

std::size_t RegionClipping::clip(std::span<const Segment> lines, std::size_t first,
                                 std::span<Clipped> out)
{
    const ClipRegion::Step& step = started_.region->steps.front();
    std::size_t count = 0;
    if (started_.keepsInside) {
        count = clipAt(step, lines, out);
    } else {
        const Pieces inside = roomIn(buffer_, lines.size());
        count = clipAt(step, lines, inside);
        count = clipping::outsideAll(lines, inside.first(count), out);
    }
    for (Clipped& piece : out.first(first == 0 ? 0 : count))
        piece.source += std::uint32_t(first);
    return count;
}

std::size_t RegionClipping::clipAt(const ClipRegion::Step& step, std::span<const Segment> lines,
                                   const Pieces& out)
{
    std::size_t count = 0;
    stopwatch_.time([&] { count = clipAtStep(started_.forms, step, lines, out); });
    return count;
}

void RegionClipping::fold(std::span<const Segment> lines, std::size_t first,
                          std::vector<Clipped>& kept)
{
    if (started_.prepared)
        return clipRegion(lines, first, kept);
    for (; lines.size() > foldedAtOnce; first += foldedAtOnce) {
        if (started_.stop.stop_requested())
            return;
        fold(lines.first(foldedAtOnce), first, kept);
        lines = lines.subspan(foldedAtOnce);
    }
    clipAtAll(lines);
    atStep_.resize(left_.size());
    for (std::size_t line = 0; line < lines.size(); ++line) {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            atStep_[i].reset();
            if (!left_[i].empty() && left_[i].front().source == line) {
                atStep_[i] = left_[i].front();
                left_[i] = left_[i].subspan(1);
            }
        }
        app::fold(*started_.region, lines[line], std::uint32_t(first + line), atStep_, kept);
    }
}

static clipping::Edge edgeOf(std::uint32_t number)
{
    return number == 0 ? clipping::Edge::NoEdge : borderEdge;
}

void RegionClipping::clipRegion(std::span<const Segment> lines, std::size_t first,
                                std::vector<Clipped>& kept)
{
    shaped_.resize(std::clamp<std::size_t>(2 * lines.size(), 64, mostPiecesAtOnce));
    clipping::RegionProgress done;
    while (done.segment < lines.size() && !started_.stop.stop_requested()) {
        stopwatch_.time(
            [&] { done = started_.forms.atRegion(lines, *started_.prepared, shaped_, done); });
        for (const clipping::RegionPiece& piece : std::span(shaped_).first(done.written))
            kept.push_back({piece.segment, std::uint32_t(first + piece.source),
                            clipping::cutAt(edgeOf(piece.edgeOfA), edgeOf(piece.edgeOfB))});
    }
}

void RegionClipping::clipAtAll(std::span<const Segment> lines)
{
    const auto& steps = started_.region->steps;
    const Pieces room = roomIn(buffer_, steps.size() * lines.size());
    left_.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        left_[i] = room.subspan(i * lines.size(), lines.size());
        left_[i] = left_[i].first(clipAt(steps[i], lines, left_[i]));
    }
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/difference_marks.h"

#include "app/view/draw_list_builder.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using Ticks = PictureOptions::Ticks;

namespace {

constexpr double leastWidth = 2.25, thicker = 1.5; // pixels
constexpr double leastGraded = 1;                  // pixels; every line is at least this wide, so
                                                   // none stands out
constexpr double tickLength = 8;                   // pixels
constexpr double tooShort = 6, roomForTick = 16;   // pixels; a shorter piece is too short to be
                                                   // seen, or to have room for a tick among many
constexpr std::size_t severalPieces = 300; // in the view; ticks on all of them hide everything else

bool isSeen(const Clipped& piece, const clipping::Window& view)
{
    const auto& [a, b] = piece.segment;
    return std::max(a.x, b.x) >= view.min.x && std::min(a.x, b.x) <= view.max.x
           && std::max(a.y, b.y) >= view.min.y && std::min(a.y, b.y) <= view.max.y;
}

/// The pieces in the view whose lines still exist.
std::vector<Clipped> seenOf(std::size_t lines, const PictureOptions& options,
                            std::span<const Clipped> pieces)
{
    const clipping::Window view = options.view.visible();
    std::vector<Clipped> seen;
    std::ranges::copy_if(pieces, std::back_inserter(seen), [&](const Clipped& piece) {
        return piece.source < lines && isSeen(piece, view);
    });
    return seen;
}

std::optional<Segment> tickOf(const Segment& piece, const PictureOptions& options, bool few)
{
    const Point along = piece.b - piece.a;
    const double length = glm::length(along), pixels = length * options.view.zoom;
    const bool isShort = pixels < tooShort;
    const bool wanted = isShort || options.ticks == Ticks::Everywhere;
    if (!wanted || (!few && pixels < roomForTick))
        return std::nullopt;
    const Point across = length > 0 ? Point(-along.y, along.x) / length : Point(0.6, 0.8);
    const Point half = across * (tickLength / 2 / options.view.zoom);
    const Point middle = piece.a + along / 2.0;
    return Segment{middle - half, middle + half};
}

std::vector<Segment> ticksOf(std::span<const Clipped> seen, const PictureOptions& options)
{
    const bool few = seen.size() <= severalPieces;
    std::vector<Segment> ticks;
    if (!few && options.ticks == Ticks::WhereShort)
        return ticks;
    for (const Clipped& piece : seen)
        if (const auto tick = tickOf(piece.segment, options, few))
            ticks.push_back(*tick);
    return ticks;
}

/// The styles of lines. Caches the style of the last line's chunk.
class LineStyles {
public:
    LineStyles(const StyleTable& styles, const SceneLines& lines) : styles_(styles), lines_(lines)
    {
    }

    std::size_t lines() const { return lines_.size(); }
    const Style& of(std::size_t line)
    {
        if (line < first_ || line >= end_)
            find(line);
        return *style_;
    }

private:
    void find(std::size_t line)
    {
        const std::size_t run = lines_.runOf(line), before = lines_.runs()[run].firstLine;
        const SceneBlock& block = *lines_.blocks()[run];
        const std::size_t chunk = block.chunkOf(line - before);
        first_ = before + block.chunks[chunk].first;
        end_ = before + block.endOfChunk(chunk);
        style_ = &styles_[block.chunks[chunk].style];
    }

    const StyleTable& styles_;
    const SceneLines& lines_;
    std::size_t first_ = 0, end_ = 0; // the lines that have this style
    const Style* style_ = nullptr;
};

/// The thickness of marks, in pixels.
struct Thickness {
    double least, more;

    double of(const Style& line, double zoom) const
    {
        return std::max(least, (line.stroke ? line.width * zoom : 0) + more);
    }
};

/// Adds marks of one colour, each with the thickness for its line.
void addMarks(DrawListBuilder& builder, LineStyles& styles, const Thickness& thickness, double zoom,
              std::span<const Clipped> seen, Style mark)
{
    std::vector<Segment> alike; // pieces with the same thickness
    const auto paint = [&](double pixels) {
        mark.width = pixels / zoom;
        if (!alike.empty())
            builder.add(mark, alike, 0, untouched(alike));
        alike.clear();
    };
    double width = 0;
    for (const Clipped& piece : seen) {
        if (const double wanted = thickness.of(styles.of(piece.source), zoom); wanted != width) {
            paint(width);
            width = wanted;
        }
        alike.push_back(piece.segment);
    }
    paint(width);
}

DrawList gradedMarks(LineStyles& styles, const PictureOptions& options)
{
    PictureOptions asTheyAre = options; // keep the given colours, which are chosen for the page
    asTheyAre.page.reset();
    DrawListBuilder builder(asTheyAre, 0);
    for (const PictureOptions::Graded& group : options.graded) {
        Style mark;
        mark.stroke = group.colour;
        addMarks(builder, styles, {leastGraded, 0}, options.view.zoom,
                 seenOf(styles.lines(), options, group.pieces), std::move(mark));
    }
    return builder.take();
}

} // namespace

DrawList differenceMarks(const StyleTable& styles, const SceneLines& lines,
                         const PictureOptions& options)
{
    LineStyles lineStyles(styles, lines);
    const std::vector<Clipped> seen = seenOf(lines.size(), options, options.differing);
    DrawListBuilder builder(options, 2 * seen.size());
    Style mark;
    mark.stroke = options.marked;
    addMarks(builder, lineStyles, {leastWidth, thicker}, options.view.zoom, seen, mark);
    if (const std::vector<Segment> ticks = ticksOf(seen, options); !ticks.empty()) {
        mark.width = leastWidth / options.view.zoom;
        builder.add(mark, ticks, 0, untouched(ticks));
    }
    if (options.graded.empty())
        return builder.take();
    DrawList drawList = gradedMarks(lineStyles, options);
    drawList.append(builder.take());
    return drawList;
}

} // namespace app

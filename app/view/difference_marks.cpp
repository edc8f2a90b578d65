// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/difference_marks.h"

#include "app/view/plating.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {

using clipping::Clipped;
using clipping::Segment;
using Ticks = PictureOptions::Ticks;

namespace {

constexpr double leastWidth = 2.25, thicker = 1.5; // pixels
constexpr double leastGraded = 1;                  // pixels: all lines are, so none stands out
constexpr double tickLength = 8;                   // pixels
constexpr double tooShort = 6, withRoom = 16;      // to be seen; for a tick among many
constexpr std::size_t severalPieces = 300; // in the view: with a tick on each nothing else is seen

bool isSeen(const Clipped& piece, const clipping::Window& view)
{
    const auto& [a, b] = piece.segment;
    return std::max(a.x, b.x) >= view.min.x && std::min(a.x, b.x) <= view.max.x
           && std::max(a.y, b.y) >= view.min.y && std::min(a.y, b.y) <= view.max.y;
}

/// Those in the view, of lines that are still there.
std::vector<Clipped> seenOf(const Scene& scene, const PictureOptions& options,
                            std::span<const Clipped> pieces)
{
    const clipping::Window view = options.view.visible();
    std::vector<Clipped> seen;
    std::ranges::copy_if(pieces, std::back_inserter(seen), [&](const Clipped& piece) {
        return piece.source < scene.segments().size() && isSeen(piece, view);
    });
    return seen;
}

std::optional<Segment> tickOf(const Segment& piece, const PictureOptions& options, bool few)
{
    const Point along = piece.b - piece.a;
    const double length = glm::length(along), pixels = length * options.view.zoom;
    const bool isShort = pixels < tooShort;
    const bool wanted = isShort || options.ticks == Ticks::Everywhere;
    if (!wanted || (!few && pixels < withRoom))
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

/// How thick the marks of lines are, in pixels; asked line by line.
class Widths {
public:
    Widths(const Sheet& sheet, const Scene& scene, double zoom, double least, double more)
        : sheet_(sheet), scene_(scene), zoom_(zoom), least_(least), more_(more)
    {
    }

    double of(std::size_t line)
    {
        if (line < scene_.firstSegmentOf(shape_) || line >= scene_.firstSegmentOf(shape_ + 1))
            shape_ = scene_.shapeOf(line);
        const Style& style = sheet_.shapes[shape_].style;
        return std::max(least_, (style.stroke ? style.width * zoom_ : 0) + more_);
    }

private:
    const Sheet& sheet_;
    const Scene& scene_;
    double zoom_, least_, more_;
    std::size_t shape_ = 0; // mostly that of the line before
};

/// In one colour, each as thick as its line wants.
void addMarks(Plating& plating, Widths widths, double zoom, std::span<const Clipped> seen,
              Shape mark)
{
    std::vector<Segment> alike; // as thick as each other
    const auto paint = [&](double pixels) {
        mark.style.width = pixels / zoom;
        if (!alike.empty())
            plating.add(mark, alike, 0, untouched(alike));
        alike.clear();
    };
    double width = 0;
    for (const Clipped& piece : seen) {
        if (const double wanted = widths.of(piece.source); wanted != width) {
            paint(width);
            width = wanted;
        }
        alike.push_back(piece.segment);
    }
    paint(width);
}

void append(Plate& to, Plate plate)
{
    const auto chains = std::uint32_t(to.chains.size()), points = std::uint32_t(to.points.size());
    for (Coat& coat : plate.coats) {
        coat.firstChain += chains;
        to.coats.push_back(coat);
    }
    for (Chain& chain : plate.chains) {
        chain.first += points;
        to.chains.push_back(chain);
    }
    to.points.insert(to.points.end(), plate.points.begin(), plate.points.end());
}

Plate gradedMarks(const Sheet& sheet, const Scene& scene, const PictureOptions& options)
{
    PictureOptions asTheyAre = options; // their colours are for the page
    asTheyAre.page.reset();
    Plating plating(asTheyAre, 0);
    for (const PictureOptions::Graded& group : options.graded) {
        Shape mark;
        mark.style.stroke = group.colour;
        addMarks(plating, {sheet, scene, options.view.zoom, leastGraded, 0}, options.view.zoom,
                 seenOf(scene, options, group.pieces), std::move(mark));
    }
    return plating.take();
}

} // namespace

Plate differenceMarks(const Sheet& sheet, const Scene& scene, const PictureOptions& options)
{
    const std::vector<Clipped> seen = seenOf(scene, options, options.differing);
    Plating plating(options, 2 * seen.size());
    Shape mark;
    mark.style.stroke = options.marked;
    addMarks(plating, {sheet, scene, options.view.zoom, leastWidth, thicker}, options.view.zoom,
             seen, mark);
    if (const std::vector<Segment> ticks = ticksOf(seen, options); !ticks.empty()) {
        mark.style.width = leastWidth / options.view.zoom;
        plating.add(mark, ticks, 0, untouched(ticks));
    }
    if (options.graded.empty())
        return plating.take();
    Plate plate = gradedMarks(sheet, scene, options);
    append(plate, plating.take());
    return plate;
}

} // namespace app

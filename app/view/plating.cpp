// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/plating.h"

#include "app/view/area.h"
#include "app/view/dashes.h"
#include "app/view/ink.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

namespace app {
namespace {

constexpr double closest = 0.25;        // pixels between the points of a chain
constexpr double shortestPattern = 1.5; // pixels; finer dashes are drawn solid
constexpr std::size_t recentChains = 4096;

bool contains(const clipping::Window& w, const Point& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

// Clips to the view; this is part of drawing, so it is the same method whatever is being shown.
std::optional<clipping::Segment> clipToView(const clipping::Segment& s, const clipping::Window& w)
{
    static const auto clip = clipping::algorithms().front().corrected.clip;
    return clip(s, w);
}

bool isWhole(std::span<const clipping::Segment> whole, std::span<const clipping::Clipped> pieces)
{
    return whole.size() == pieces.size()
           && std::ranges::all_of(pieces, [](const auto& piece) { return piece.cut == 0; });
}

// For each segment, the length of its path before it.
std::vector<double> lengthsBefore(std::span<const clipping::Segment> whole)
{
    std::vector<double> before(whole.size(), 0);
    for (std::size_t i = 1; i < whole.size(); ++i)
        if (whole[i].a == whole[i - 1].b)
            before[i] = before[i - 1] + glm::distance(whole[i - 1].a, whole[i - 1].b);
    return before;
}

} // namespace

std::vector<clipping::Clipped> untouched(std::span<const clipping::Segment> segments)
{
    std::vector<clipping::Clipped> all;
    all.reserve(segments.size());
    for (const auto& segment : segments)
        all.push_back({segment, std::uint32_t(all.size()), 0});
    return all;
}

Plating::Plating(const PictureOptions& options, std::size_t expectedPieces)
    : options_(options), recent_(recentChains)
{
    plate_.points.reserve(2 * expectedPieces);
    plate_.chains.reserve(expectedPieces);
}

void Plating::add(const Shape& shape, std::span<const clipping::Segment> whole, std::size_t number,
                  std::span<const clipping::Clipped> pieces)
{
    const Style& style = shape.style;
    const bool filled = style.fill && isWhole(whole, pieces);
    if (filled)
        fill(whole, style);
    if (!style.stroke && (filled || !style.fill))
        return;
    Ink ink{shown(style.stroke ? *style.stroke : *style.fill),
            std::max(style.width * options_.view.zoom, options_.leastWidth) * options_.strokes,
            style.cap, style.join, style.miterLimit};
    beginCoat(ink);
    stroke(style, whole, number, pieces);
}

void Plating::fill(std::span<const clipping::Segment> whole, const Style& style)
{
    Coat coat{std::nullopt, shown(*style.fill), style.fillRule, std::uint32_t(plate_.chains.size()),
              0};
    const clipping::Window view = options_.view.visible();
    const Point margin = (view.max - view.min) * 0.01;
    std::vector<Point> contour;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        contour.push_back(whole[i].a);
        const bool ends = i + 1 == whole.size() || whole[i + 1].a != whole[i].b;
        if (!ends)
            continue;
        contour.push_back(whole[i].b);
        contour = areaInside(contour, {view.min - margin, view.max + margin});
        if (contour.size() >= 3) {
            const auto first = std::uint32_t(plate_.points.size());
            for (const Point& p : contour)
                plate_.points.push_back(onScreen(p));
            plate_.points.push_back(onScreen(contour.front()));
            plate_.chains.push_back({first, std::uint32_t(contour.size() + 1), true, false, false});
            ++coat.chains;
        }
        contour.clear();
    }
    if (coat.chains > 0)
        plate_.coats.push_back(coat);
}

void Plating::beginCoat(const Ink& ink)
{
    if (plate_.coats.empty() || plate_.coats.back().stroke != ink)
        plate_.coats.push_back({ink, {}, {}, std::uint32_t(plate_.chains.size()), 0});
    const double sharp = ink.join == Join::Miter ? std::max(1.0, ink.miterLimit) : 1.5;
    const double room = (0.5 * ink.width * sharp + 2) / options_.view.zoom;
    const clipping::Window view = options_.view.visible();
    seen_ = {view.min - room, view.max + room};
}

void Plating::stroke(const Style& style, std::span<const clipping::Segment> whole,
                     std::size_t number, std::span<const clipping::Clipped> pieces)
{
    const double zoom = options_.view.zoom;
    pattern_.clear();
    std::ranges::transform(style.dashes, std::back_inserter(pattern_),
                           [=](double d) { return d * zoom; });
    const auto before = pattern_.empty() ? std::vector<double>{} : lengthsBefore(whole);
    for (const clipping::Clipped& piece : pieces) {
        const clipping::Segment& source = whole[piece.source - number];
        const auto part = partSeen(piece, source);
        if (!part)
            continue;
        if (open_ && (open_->last != part->segment.a || part->cutA))
            finish(true);
        if (!open_) {
            const double start = before.empty() ? 0 : before[piece.source - number];
            begin(*part, style.dashOffset + start + glm::distance(source.a, part->segment.a));
        }
        proceed(part->segment.b);
        if (part->cutB)
            finish(false);
    }
    if (open_)
        finish(true);
}

// A single point that a longer line has in common with the window is not drawn.
std::optional<Plating::Part> Plating::partSeen(const clipping::Clipped& piece,
                                               const clipping::Segment& source) const
{
    const clipping::Segment& s = piece.segment;
    if (s.a == s.b && source.a != source.b)
        return std::nullopt;
    Part part{s, clipping::cutEdgeOfA(piece.cut) != clipping::Edge::None,
              clipping::cutEdgeOfB(piece.cut) != clipping::Edge::None};
    if (contains(seen_, s.a) && contains(seen_, s.b))
        return part;
    const auto visible = clipToView(s, seen_);
    if (!visible)
        return std::nullopt;
    return Part{*visible, part.cutA || visible->a != s.a, part.cutB || visible->b != s.b};
}

void Plating::begin(const Part& part, double phase)
{
    openAt_ = std::uint32_t(plate_.points.size());
    plate_.points.push_back(onScreen(part.segment.a));
    open_ = Open{part.segment.a, std::nullopt, phase, !part.cutA};
}

void Plating::proceed(const Point& to)
{
    const QPointF p = onScreen(to), step = p - plate_.points.back();
    open_->last = to;
    if (std::abs(step.x()) < closest && std::abs(step.y()) < closest) {
        open_->unsaid = p;
    } else {
        plate_.points.push_back(p);
        open_->unsaid.reset();
    }
}

void Plating::finish(bool capAtEnd)
{
    if (open_->unsaid)
        plate_.points.push_back(*open_->unsaid);
    const auto count = std::uint32_t(plate_.points.size()) - openAt_;
    const bool closed = count > 3 && plate_.points[openAt_] == plate_.points.back()
                        && open_->capAtStart && capAtEnd;
    if (pattern_.empty())
        pushChain({openAt_, count, closed, open_->capAtStart, capAtEnd});
    else
        finishDashed(capAtEnd);
    open_.reset();
}

void Plating::finishDashed(bool capAtEnd)
{
    const std::vector<QPointF> line(plate_.points.begin() + openAt_, plate_.points.end());
    plate_.points.resize(openAt_);
    const auto all = dashes(line, pattern_, open_->phase * options_.view.zoom, shortestPattern);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto first = std::uint32_t(plate_.points.size());
        plate_.points.insert(plate_.points.end(), all[i].begin(), all[i].end());
        const bool atStart = all[i].front() == line.front(), atEnd = all[i].back() == line.back();
        pushChain({first, std::uint32_t(all[i].size()), false, !atStart || open_->capAtStart,
                   !atEnd || capAtEnd});
    }
}

// Painting a chain takes long where it covers many pixels, and a file may hold the same line a
// hundred thousand times. Opaque ink shows only the first of them, translucent ink adds up.
void Plating::pushChain(const Chain& chain)
{
    if (plate_.coats.back().stroke->colour.alpha == 255 && liesOnAnother(chain)) {
        plate_.points.resize(chain.first);
        return;
    }
    plate_.chains.push_back(chain);
    ++plate_.coats.back().chains;
}

// Exactly, on one of the latest chains of the same coat.
bool Plating::liesOnAnother(const Chain& chain)
{
    const auto points = plate_.pointsOf(chain);
    std::uint64_t hash = 0;
    for (const QPointF& p : points)
        for (const double coordinate : {p.x(), p.y()})
            hash = (std::rotl(hash, 5) ^ std::bit_cast<std::uint64_t>(coordinate))
                   * 0x9e3779b97f4a7c15;
    std::uint32_t& slot = recent_[(hash >> 32) % recentChains];
    const std::uint32_t earlier = std::exchange(slot, std::uint32_t(plate_.chains.size()));
    if (earlier < plate_.coats.back().firstChain || earlier >= plate_.chains.size())
        return false;
    const Chain& other = plate_.chains[earlier];
    const bool same = other.closed == chain.closed && other.capAtStart == chain.capAtStart
                      && other.capAtEnd == chain.capAtEnd
                      && std::ranges::equal(plate_.pointsOf(other), points, std::equal_to<>());
    if (same)
        slot = earlier;
    return same;
}

Colour Plating::shown(const Colour& colour)
{
    if (!options_.page)
        return colour;
    if (!lastShown_ || lastAsked_ != colour) {
        lastAsked_ = colour;
        lastShown_ = shownInk(colour, *options_.page);
    }
    return *lastShown_;
}

QPointF Plating::onScreen(const Point& p) const
{
    const Point s = options_.view.toScreen(p);
    return {s.x, s.y};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/draw_list_builder.h"

#include "app/view/cut_fill.h"
#include "app/view/visible_colour.h"
#include "clipping/algorithm.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

bool containsPoint(const clipping::Window& w, const Point& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

// Clips to the view. This belongs to drawing, so it always uses the same algorithm.
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

clipping::Window withMargin(const clipping::Window& view, const Point& room)
{
    return {view.min - room, view.max + room};
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

DrawListBuilder::DrawListBuilder(const PictureOptions& options, std::size_t expectedPieces)
    : options_(options)
{
    const clipping::Window view = options_.view.visible();
    filled_ = withMargin(view, (view.max - view.min) * 0.01);
    drawList_.points.reserve(2 * expectedPieces);
    drawList_.polylines.reserve(expectedPieces);
}

void DrawListBuilder::add(const Style& style, std::span<const clipping::Segment> whole,
                          std::size_t number, std::span<const clipping::Clipped> pieces)
{
    setStyle(style);
    const Outline outline{whole};
    const bool filled = style.fill && isWhole(whole, pieces);
    if (filled)
        fill(outline);
    if (!style.stroke && (filled || !style.fill))
        return;
    beginStrokes();
    LengthsBefore lengths(outline);
    for (const clipping::Clipped& piece : pieces) {
        const std::size_t line = piece.source - number;
        stroke(piece, whole[line], isDashed() ? lengths.of(line) : 0);
    }
}

void DrawListBuilder::setStyle(const Style& style)
{
    style_ = &style;
    const double zoom = options_.view.zoom;
    std::vector<double> pattern(style.dashes);
    for (double& length : pattern)
        length *= zoom;
    polylines_.setDashes(std::move(pattern));
    if (!style.stroke && !style.fill)
        return;
    strokeStyle_ = {shown(style.stroke ? *style.stroke : *style.fill), strokeWidth(style, options_),
                    style.cap, style.join, style.miterLimit};
    const double sharp =
        strokeStyle_.join == Join::Miter ? std::max(1.0, strokeStyle_.miterLimit) : 1.5;
    seen_ =
        withMargin(options_.view.visible(), Point((0.5 * strokeStyle_.width * sharp + 2) / zoom));
}

void DrawListBuilder::fill(const Outline& whole)
{
    polylines_.end();
    DrawCommand command{std::nullopt, shown(*style_->fill), style_->fillRule,
                        std::uint32_t(drawList_.polylines.size()), 0};
    std::vector<Point> contour;
    const auto finish = [&] {
        contour = areaInside(contour, filled_);
        if (contour.size() >= 3) {
            const auto first = std::uint32_t(drawList_.points.size());
            for (const Point& p : contour)
                drawList_.points.push_back(polylines_.onScreen(p));
            drawList_.points.push_back(polylines_.onScreen(contour.front()));
            drawList_.polylines.push_back(
                {first, std::uint32_t(contour.size() + 1), true, false, false});
            ++command.polylines;
        }
        contour.clear();
    };
    for (const auto& lines : whole)
        for (const clipping::Segment& line : lines) {
            if (!contour.empty() && contour.back() != line.a)
                finish();
            if (contour.empty())
                contour.push_back(line.a);
            contour.push_back(line.b);
        }
    if (!contour.empty())
        finish();
    if (command.polylines > 0)
        drawList_.commands.push_back(command);
}

void DrawListBuilder::beginStrokes()
{
    polylines_.end();
    if (drawList_.commands.empty() || drawList_.commands.back().stroke != strokeStyle_)
        drawList_.commands.push_back(
            {strokeStyle_, {}, {}, std::uint32_t(drawList_.polylines.size()), 0});
}

void DrawListBuilder::add(const SharedUnderlay& image)
{
    polylines_.end();
    const View& view = options_.view;
    const Point corner = view.toScreen({0, 0});
    DrawCommand command;
    command.image = std::uint32_t(drawList_.images.size());
    command.firstPolyline = std::uint32_t(drawList_.polylines.size());
    drawList_.commands.push_back(command);
    drawList_.images.push_back({image, QTransform(view.zoom, 0, 0, view.zoom, corner.x, corner.y)});
}

void DrawListBuilder::stroke(const clipping::Clipped& piece, const clipping::Segment& line,
                             double before)
{
    if (const auto part = partSeen(piece, line))
        polylines_.add(*part, [&] {
            return style_->dashOffset + before + glm::distance(line.a, part->segment.a);
        });
}

void DrawListBuilder::strokeSeen(const clipping::Segment& line, double before)
{
    polylines_.add({line, false, false}, [&] { return style_->dashOffset + before; });
}

// The part of a piece in the view. A single point of a longer line is not drawn.
std::optional<SeenPart> DrawListBuilder::partSeen(const clipping::Clipped& piece,
                                                  const clipping::Segment& source) const
{
    const clipping::Segment& s = piece.segment;
    if (s.a == s.b && source.a != source.b)
        return std::nullopt;
    SeenPart part{s, clipping::cutEdgeOfA(piece.cut) != clipping::Edge::NoEdge,
                  clipping::cutEdgeOfB(piece.cut) != clipping::Edge::NoEdge};
    if (containsPoint(seen_, s.a) && containsPoint(seen_, s.b))
        return part;
    const auto visible = clipToView(s, seen_);
    if (!visible)
        return std::nullopt;
    return SeenPart{*visible, part.cutA || visible->a != s.a, part.cutB || visible->b != s.b};
}

Colour DrawListBuilder::shown(const Colour& colour)
{
    if (!options_.page)
        return colour;
    if (!lastShown_ || lastAsked_ != colour) {
        lastAsked_ = colour;
        lastShown_ = visibleColour(colour, *options_.page);
    }
    return *lastShown_;
}

DrawList DrawListBuilder::take()
{
    polylines_.end();
    return std::move(drawList_);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/picking.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {

constexpr double mostCellsPerSide = 512; // more would cost more to fill than looking them up saves
constexpr double mostCellsCrossed = 16;  // by a segment, in the mean: long ones want few cells

double distance(const Point& point, const clipping::Segment& s)
{
    const Point along = s.b - s.a;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(point - s.a, along) / square, 0.0, 1.0) : 0;
    return glm::distance(point, s.a + along * t);
}

Picking::Picking(const EditedDocument& document, const Scene& scene, QObject* parent)
    : QObject(parent), document_(document), scene_(scene)
{
    connect(&document, &EditedDocument::changed, this,
            [this](const DocumentChange& change) { outdated_ |= change.drawing(); });
}

bool Picking::pickable(std::size_t shape) const
{
    return document_.now().editable(shape);
}

std::vector<std::size_t> Picking::near(const Point& point, double radius) const
{
    build();
    std::vector<std::size_t> found;
    const Cells cells = cellsOf(point - radius, point + radius);
    for (std::size_t y = cells.y0; y <= cells.y1; ++y)
        for (std::size_t x = cells.x0; x <= cells.x1; ++x)
            for (auto i = start_[y * columns_ + x]; i < start_[y * columns_ + x + 1]; ++i)
                if (distance(point, scene_.segments()[segments_[i]]) <= radius)
                    found.push_back(segments_[i]);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::optional<std::size_t> Picking::nearest(const Point& point, double radius) const
{
    std::optional<std::size_t> best;
    double least = radius;
    for (const std::size_t segment : near(point, radius)) {
        const double d = distance(point, scene_.segments()[segment]);
        if (d <= least && pickable(scene_.shapeOf(segment))) {
            least = d;
            best = segment;
        }
    }
    return best;
}

// How often a closed outline goes round the point, and how often a ray from it meets the outline.
// Open paths are filled as if closed; the closing line is left out here, so they are rarely hit.
static bool contains(std::span<const clipping::Segment> outline, FillRule rule, const Point& p)
{
    int winding = 0, crossings = 0;
    for (const auto& s : outline) {
        if ((s.a.y <= p.y) == (s.b.y <= p.y))
            continue;
        const double x = s.a.x + (s.b.x - s.a.x) * ((p.y - s.a.y) / (s.b.y - s.a.y));
        if (x <= p.x)
            continue;
        ++crossings;
        winding += s.b.y > s.a.y ? 1 : -1;
    }
    return rule == FillRule::EvenOdd ? crossings % 2 == 1 : winding != 0;
}

std::optional<std::size_t> Picking::areaAt(const Point& point) const
{
    const Objects& objects = document_.now().objects();
    for (std::size_t shape = objects.size(); shape-- > 0;) {
        const auto first = scene_.firstSegmentOf(shape), end = scene_.firstSegmentOf(shape + 1);
        const app::Style& style = objects[shape].style();
        if (style.fill && pickable(shape)
            && contains(scene_.segments().subspan(first, end - first), style.fillRule, point))
            return shape;
    }
    return std::nullopt;
}

ObjectRanges Picking::shapesIn(const clipping::Window& rectangle, Box box) const
{
    static const auto clip = clipping::algorithms().front().corrected.clip;
    ObjectRanges found;
    for (std::size_t shape = 0; shape < document_.now().objects().size(); ++shape) {
        const auto first = scene_.firstSegmentOf(shape), end = scene_.firstSegmentOf(shape + 1);
        const auto lines = scene_.segments().subspan(first, end - first);
        const auto contained = [&](const clipping::Segment& s) {
            const Point min = glm::min(s.a, s.b), max = glm::max(s.a, s.b);
            return min.x >= rectangle.min.x && min.y >= rectangle.min.y && max.x <= rectangle.max.x
                   && max.y <= rectangle.max.y;
        };
        const auto touched = [&](const clipping::Segment& s) {
            return clip(s, rectangle).has_value();
        };
        const bool in = !lines.empty() && pickable(shape)
                        && (box == Box::Contains ? std::ranges::all_of(lines, contained)
                                                 : std::ranges::any_of(lines, touched));
        if (in)
            found.insert(shape);
    }
    return found;
}

Picking::Cells Picking::cellsOf(const Point& min, const Point& max) const
{
    const auto index = [](double v, std::size_t count) {
        return std::size_t(std::clamp(v, 0.0, double(count - 1)));
    };
    const Point from = (min - origin_) / cell_, to = (max - origin_) / cell_;
    return {index(from.x, columns_), index(from.y, rows_), index(to.x, columns_),
            index(to.y, rows_)};
}

// The cells of a segment, row by row: in each, those that its part in the row's height spans.
template <class Visit>
void Picking::visit(const clipping::Segment& s, Visit cell) const
{
    const Cells all = cellsOf(glm::min(s.a, s.b), glm::max(s.a, s.b));
    const Point along = s.b - s.a;
    for (std::size_t y = all.y0; y <= all.y1; ++y) {
        Cells row = all;
        if (all.y0 != all.y1 && all.x0 != all.x1) {
            const double top = origin_.y + double(y) * cell_.y;
            const double t0 = std::clamp((top - s.a.y) / along.y, 0.0, 1.0);
            const double t1 = std::clamp((top + cell_.y - s.a.y) / along.y, 0.0, 1.0);
            const double x0 = s.a.x + along.x * t0, x1 = s.a.x + along.x * t1;
            const Point slack = cell_ * 1e-6;
            row = cellsOf({std::min(x0, x1) - slack.x, top}, {std::max(x0, x1) + slack.x, top});
        }
        for (std::size_t x = row.x0; x <= row.x1; ++x)
            cell(y * columns_ + x);
    }
}

void Picking::build() const
{
    if (!outdated_)
        return;
    outdated_ = false;
    const auto segments = scene_.segments();
    Point min(0), max(0);
    if (!segments.empty())
        min = max = segments[0].a;
    for (const auto& s : segments) {
        min = glm::min(min, glm::min(s.a, s.b));
        max = glm::max(max, glm::max(s.a, s.b));
    }
    Point share(0); // of the whole's width and height that all segments together take
    for (const auto& s : segments)
        share += glm::abs(s.b - s.a) / glm::max(max - min, Point(1e-12));
    const auto count = double(segments.size());
    const double crossed = mostCellsCrossed * count / std::max(share.x + share.y, 1.0);
    const double side = std::clamp(std::min(std::sqrt(count) / 2, crossed), 1.0, mostCellsPerSide);
    origin_ = min;
    columns_ = rows_ = std::size_t(side);
    cell_ = glm::max((max - min) / double(columns_), Point(1e-12));

    start_.assign(columns_ * rows_ + 1, 0);
    for (const auto& s : segments)
        visit(s, [&](std::size_t cell) { ++start_[cell + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i)
        start_[i] += start_[i - 1];
    segments_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t i = 0; i < segments.size(); ++i)
        visit(segments[i], [&](std::size_t cell) { segments_[next[cell]++] = i; });
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/drawn_box.h"

#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

class Box {
public:
    void add(const Point& p, double margin)
    {
        const clipping::Window next{p - margin, p + margin};
        box_ = box_ ? clipping::Window{glm::min(box_->min, next.min), glm::max(box_->max, next.max)}
                    : next;
    }
    const std::optional<clipping::Window>& box() const { return box_; }

private:
    std::optional<clipping::Window> box_;
};

/// The tip of a mitred join between two chords, if there is one.
std::optional<Point> tipOf(const clipping::Segment& in, const clipping::Segment& out,
                           const Style& style)
{
    const Point u = in.b - in.a, v = out.b - out.a;
    const double lengths = glm::length(u) * glm::length(v);
    if (!(lengths > 0))
        return std::nullopt;
    // Half of the angle between the two sides of the corner.
    const double sine = std::sqrt(std::max(0.0, (1 + glm::dot(u, v) / lengths) / 2));
    const Point outward = u / glm::length(u) - v / glm::length(v);
    if (!(sine > 0) || 1 / sine > style.miterLimit || !(glm::length(outward) > 0))
        return std::nullopt;
    return in.b + outward / glm::length(outward) * (style.width / 2 / sine);
}

/// Both sides of a line with this width.
void addSides(Box& box, const clipping::Segment& line, double half)
{
    const double length = glm::length(line.b - line.a);
    const Point along = length > 0 ? (line.b - line.a) / length : Point(0);
    const Point across = Point(-along.y, along.x) * half;
    for (const Point& end : {line.a, line.b})
        for (const Point& side : {end - across, end + across})
            box.add(side, 0);
}

/// What the cap adds at the end of a line, in its direction.
void addCap(Box& box, const clipping::Segment& line, const Style& style)
{
    const double half = style.width / 2, length = glm::length(line.b - line.a);
    if (style.cap == Cap::Round || (style.cap == Cap::Square && !(length > 0)))
        box.add(line.b, half);
    else if (style.cap == Cap::Square)
        addSides(box, {line.b, line.b + (line.b - line.a) / length * half}, half);
}

void addStroke(Box& box, const std::vector<Chord>& chords, bool closed, const Style& style)
{
    for (const Chord& chord : chords)
        addSides(box, chord.segment, style.width / 2);
    for (std::size_t i = closed ? 0 : 1; i < chords.size(); ++i) {
        const clipping::Segment& before = chords[i == 0 ? chords.size() - 1 : i - 1].segment;
        if (style.join == Join::Round)
            box.add(before.b, style.width / 2);
        else if (const auto tip = tipOf(before, chords[i].segment, style);
                 tip && style.join == Join::Miter)
            box.add(*tip, 0);
    }
    if (closed)
        return;
    const clipping::Segment& first = chords.front().segment;
    addCap(box, {first.b, first.a}, style);
    addCap(box, chords.back().segment, style);
}

void addSubpath(Box& box, const Subpath& path, const Style& style, double tolerance)
{
    std::vector<Chord> chords;
    flatten(path, tolerance, chords);
    if (chords.empty())
        return;
    if (style.stroke)
        addStroke(box, chords, path.closed, style);
    else
        for (const Chord& chord : chords)
            for (const Point& end : {chord.segment.a, chord.segment.b})
                box.add(end, 0);
}

} // namespace

std::optional<clipping::Window> drawnBox(const Document& document)
{
    Box box;
    for (const SeenUnderlay& image : seenUnderlays(document))
        for (const Point& corner : outlineOf(*image.underlay))
            box.add(corner, 0);
    const double tolerance = usualTolerance(document.page());
    const ObjectRanges hidden = hiddenObjects(document);
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
        const Style& style = object.style();
        if (hidden.contains(i) || (!style.stroke && !style.fill))
            return;
        for (const Subpath& path : object.path().subpaths())
            addSubpath(box, path, style, tolerance);
    });
    return box.box();
}

} // namespace app

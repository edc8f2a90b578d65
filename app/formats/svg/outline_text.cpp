// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/outline_text.h"

#include "app/formats/number.h"

#include <algorithm>
#include <limits>

namespace app::svg {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

} // namespace

void OutlineText::append(std::string& text, const std::vector<Path>& paths) const
{
    const Path& path = paths.front();
    const bool straight = std::ranges::none_of(path.stretches, &Stretch::curved);
    if (paths.size() > 1 || !straight || (path.closed && path.stretches.empty())) {
        text += "<path d=\"";
        for (const Path& one : paths)
            appendPathData(text, one);
        text += '"';
    } else if (path.stretches.size() <= 1 && !path.closed) {
        appendLine(text, path.start,
                   path.stretches.empty() ? path.start : path.stretches.front().to);
    } else {
        text += path.closed ? "<polygon points=\"" : "<polyline points=\"";
        appendPoint(text, path.start);
        for (const Stretch& stretch : path.stretches) {
            text += ' ';
            appendPoint(text, stretch.to);
        }
        text += '"';
    }
}

void OutlineText::appendLine(std::string& text, const Point& from, const Point& to) const
{
    text += "<line x1=\"";
    appendCoordinate(text, from.x, 0);
    text += "\" y1=\"";
    appendCoordinate(text, from.y, 1);
    text += "\" x2=\"";
    appendCoordinate(text, to.x, 0);
    text += "\" y2=\"";
    appendCoordinate(text, to.y, 1);
    text += '"';
}

void OutlineText::appendPathData(std::string& text, const Path& path) const
{
    text += 'M';
    appendPoint(text, path.start);
    for (const Stretch& stretch : path.stretches) {
        text += stretch.curved ? 'C' : 'L';
        if (stretch.curved) {
            appendControl(text, stretch.control1);
            text += ' ';
            appendControl(text, stretch.control2);
            text += ' ';
        }
        appendPoint(text, stretch.to);
    }
    if (path.stretches.empty() && !path.closed) {
        text += 'L'; // a point is a line without length
        appendPoint(text, path.start);
    }
    if (path.closed)
        text += 'Z';
}

void OutlineText::appendPoint(std::string& text, const Point& p) const
{
    appendCoordinate(text, p.x, 0);
    text += ' ';
    appendCoordinate(text, p.y, 1);
}

// Control points may lie outside of bounds in which the curve lies.
void OutlineText::appendControl(std::string& text, const Point& p) const
{
    if (options_.precision < 0) {
        appendPoint(text, p);
        return;
    }
    appendNumber(text, p.x, options_.precision, -unbounded, unbounded);
    text += ' ';
    appendNumber(text, p.y, options_.precision, -unbounded, unbounded);
}

void OutlineText::appendCoordinate(std::string& text, double value, int axis) const
{
    if (options_.precision < 0)
        appendNumber(text, value);
    else if (const auto& bounds = options_.bounds)
        appendNumber(text, value, options_.precision, bounds->min[axis], bounds->max[axis]);
    else
        appendNumber(text, value, options_.precision, -unbounded, unbounded);
}

} // namespace app::svg

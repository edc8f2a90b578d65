// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/outline_text.h"

#include "app/formats/coordinates.h"

#include <algorithm>

namespace app::svg {

std::string_view OutlineText::append(std::string& text, const std::vector<Subpath>& paths) const
{
    const Subpath& path = paths.front();
    const bool straight = std::ranges::none_of(path.segments, &PathSegment::curved);
    if (paths.size() > 1 || !straight || (path.closed && path.segments.empty())) {
        text += "<path d=\"";
        for (const Subpath& one : paths)
            appendPathData(text, one);
        text += '"';
        return "path";
    }
    if (path.segments.size() <= 1 && !path.closed)
        return appendLine(text, path.start,
                          path.segments.empty() ? path.start : path.segments.front().to);
    const std::string_view name = path.closed ? "polygon" : "polyline";
    ((text += '<') += name) += " points=\"";
    appendPoint(text, path.start, ' ', options_);
    for (const PathSegment& segment : path.segments) {
        text += ' ';
        appendPoint(text, segment.to, ' ', options_);
    }
    text += '"';
    return name;
}

std::string_view OutlineText::appendLine(std::string& text, const Point& from,
                                         const Point& to) const
{
    text += "<line x1=\"";
    appendCoordinate(text, from.x, 0, options_);
    text += "\" y1=\"";
    appendCoordinate(text, from.y, 1, options_);
    text += "\" x2=\"";
    appendCoordinate(text, to.x, 0, options_);
    text += "\" y2=\"";
    appendCoordinate(text, to.y, 1, options_);
    text += '"';
    return "line";
}

void OutlineText::appendPathData(std::string& text, const Subpath& path) const
{
    text += 'M';
    appendPoint(text, path.start, ' ', options_);
    for (const PathSegment& segment : path.segments) {
        text += segment.curved ? 'C' : 'L';
        if (segment.curved) {
            appendControl(text, segment.control1, ' ', options_);
            text += ' ';
            appendControl(text, segment.control2, ' ', options_);
            text += ' ';
        }
        appendPoint(text, segment.to, ' ', options_);
    }
    if (path.segments.empty() && !path.closed) {
        text += 'L'; // a point is a line without length
        appendPoint(text, path.start, ' ', options_);
    }
    if (path.closed)
        text += 'Z';
}

} // namespace app::svg

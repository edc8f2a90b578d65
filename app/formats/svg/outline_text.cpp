// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/outline_text.h"

#include "app/formats/coordinates.h"

#include <algorithm>

namespace app::svg {
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
        appendPoint(text, path.start, ' ', options_);
        for (const Stretch& stretch : path.stretches) {
            text += ' ';
            appendPoint(text, stretch.to, ' ', options_);
        }
        text += '"';
    }
}

void OutlineText::appendLine(std::string& text, const Point& from, const Point& to) const
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
}

void OutlineText::appendPathData(std::string& text, const Path& path) const
{
    text += 'M';
    appendPoint(text, path.start, ' ', options_);
    for (const Stretch& stretch : path.stretches) {
        text += stretch.curved ? 'C' : 'L';
        if (stretch.curved) {
            appendControl(text, stretch.control1, ' ', options_);
            text += ' ';
            appendControl(text, stretch.control2, ' ', options_);
            text += ' ';
        }
        appendPoint(text, stretch.to, ' ', options_);
    }
    if (path.stretches.empty() && !path.closed) {
        text += 'L'; // a point is a line without length
        appendPoint(text, path.start, ' ', options_);
    }
    if (path.closed)
        text += 'Z';
}

} // namespace app::svg

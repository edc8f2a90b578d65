// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/glyph_outlines.h"

#include <QPainterPath>
#include <QRawFont>

#include <algorithm>
#include <span>

namespace app {
namespace {

Point pointOf(const QPainterPath::Element& e) { return {e.x, e.y}; }

/// The subpaths of a glyph. Qt ends each with a line to its start where it does not lie there.
std::vector<Subpath> subpathsOf(const QPainterPath& glyph)
{
    std::vector<Subpath> paths;
    for (int i = 0; i < glyph.elementCount(); ++i) {
        const QPainterPath::Element e = glyph.elementAt(i);
        if (e.isMoveTo()) {
            paths.push_back({pointOf(e), {}, true});
        } else if (e.isLineTo()) {
            paths.back().segments.push_back({pointOf(e)});
        } else {
            const Point second = pointOf(glyph.elementAt(i + 1)),
                        to = pointOf(glyph.elementAt(i + 2));
            paths.back().segments.push_back({to, pointOf(e), second, true});
            i += 2;
        }
    }
    for (Subpath& path : paths)
        if (!path.segments.empty() && !path.segments.back().curved
            && path.segments.back().to == path.start)
            path.segments.pop_back(); // a closed subpath has this line
    std::erase_if(paths, [](const Subpath& path) { return path.segments.empty(); });
    return paths;
}

std::vector<Subpath> frame(double width, double height)
{
    const auto ring = [](const Point& min, const Point& max) {
        return std::vector<Point>{min, {max.x, min.y}, max, {min.x, max.y}};
    };
    const double margin = width / 8, pen = width / 12;
    auto outer = ring({margin, -height}, {width - margin, 0});
    auto inner = ring({margin + pen, pen - height}, {width - margin - pen, -pen});
    std::ranges::reverse(inner); // a hole by the rule `nonzero`
    std::vector<Subpath> paths;
    for (const auto& corners : {outer, inner}) {
        Subpath path{corners.front(), {}, true};
        for (const Point& corner : std::span(corners).subspan(1))
            path.segments.push_back({corner});
        paths.push_back(std::move(path));
    }
    return paths;
}

} // namespace

double capitalOf(const QRawFont& font)
{
    const double capital = font.capHeight();
    return capital > 0 ? capital : usualCapital * font.pixelSize();
}

const std::vector<Subpath>& GlyphOutlines::glyph(const QRawFont& font, unsigned index)
{
    const auto [known, isNew] = known_.try_emplace(index);
    if (!isNew)
        return known->second;
    known->second = subpathsOf(font.pathForGlyph(index));
    if (index == 0 && known->second.empty()) // the font draws nothing for what it lacks
        known->second = frame(font.advancesForGlyphIndexes({0}).first().x(), capitalOf(font));
    return known->second;
}

} // namespace app

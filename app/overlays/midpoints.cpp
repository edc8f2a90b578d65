// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/midpoints.h"

#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/overlays/parts.h"
#include "clipping/outcode.h"

namespace app {

namespace {

constexpr std::size_t shownHalvings = 6; // later midpoints are usually less than a pixel apart

void search(bool forB, const clipping::Segment& line, const clipping::Window& window,
            std::size_t most, std::vector<Halving>& all)
{
    const Point d = line.b - line.a;
    // As in the library: the distances from a are compared with the distances to the edges.
    const clipping::Window gaps{window.min - line.a, window.max - line.a};
    const auto codeAt = [&](double t) { return clipping::outcodeOf(t * d, gaps); };
    double near = forB ? 0 : 1, far = forB ? 1 : 0;
    unsigned nearCode = clipping::outcodeOf(forB ? line.a : line.b, window);
    unsigned farCode = clipping::outcodeOf(forB ? line.b : line.a, window);
    for (std::size_t i = 0; i < most && farCode != 0 && (nearCode & farCode) == 0; ++i) {
        const double middle = (near + far) / 2;
        const unsigned code = codeAt(middle);
        const bool drop = (code & farCode) != 0;
        (drop ? far : near) = middle;
        (drop ? farCode : nearCode) = code;
        all.push_back({forB, middle, nearCode, farCode});
    }
}

QString midpointsCaption(const OverlayContext& context)
{
    if (!context.line)
        return Text::tr("Outcodes tell which half cannot contain the end that is sought. %1")
            .arg(pointAtALine());
    const auto [a, b] = codesOf(context);
    if ((a & b) != 0 || (a | b) == 0)
        return codeWords(context);
    return context.trace.outcome == clipping::Outcome::Visible
               ? Text::tr(
                   "The first midpoints are numbered: each halves the part that may contain the "
                   "end.")
               : Text::tr("Halving finds two points beyond one edge: nothing is visible.");
}

} // namespace

std::vector<Halving> halvings(const clipping::Segment& line, const clipping::Window& window,
                              std::size_t most)
{
    std::vector<Halving> all;
    if (clipping::outcodeOf(line.a, window) & clipping::outcodeOf(line.b, window))
        return all;
    search(true, line, window, most, all);
    if (all.empty() || (all.back().nearCode & all.back().farCode) == 0)
        search(false, line, window, most, all);
    return all;
}

Overlay midpointOverlay(const OverlayContext& context)
{
    Overlay overlay{.areas = outcodeRegions(context),
                    .lines = regionBorders(context),
                    .caption = midpointsCaption(context)};
    if (!context.line)
        return overlay;
    const auto& [a, b] = *context.line;
    int number = 0;
    bool forB = true;
    for (const Halving& halving : halvings(*context.line, context.window, shownHalvings)) {
        number = halving.forB == forB ? number + 1 : 1;
        forB = halving.forB;
        overlay.marks.push_back(
            {.at = a + halving.t * (b - a),
             .symbol = forB ? OverlayMark::Symbol::Filled : OverlayMark::Symbol::Hollow,
             .label = QString::number(number),
             .emphasis = Emphasis::Highlighted});
    }
    const auto [codeA, codeB] = codesOf(context);
    for (OverlayMark& mark : endMarks(*context.line, outcodeText(codeA), outcodeText(codeB)))
        overlay.marks.push_back(std::move(mark));
    overlay.table = codeTable(context);
    return overlay;
}

} // namespace app

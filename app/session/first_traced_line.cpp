// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/first_traced_line.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/window_in_hand.h"

#include <glm/geometric.hpp>

#include <tuple>

namespace app {

namespace {

/// A line that crosses the infinite line of ymin, enters the window at xmin and leaves it at ymax.
clipping::Segment across(const clipping::Window& window)
{
    const Point size = window.max - window.min;
    return {window.min - 0.3 * size, window.max + Point(-0.15, 0.4) * size};
}

/// How interesting a line is; compared from the first member on.
struct Ranked {
    bool unlocked = false; ///< locked layers usually hold grids
    int cutEnds = 0;
    double length = 0;    ///< of a line with one end cut
    std::size_t line = 0; ///< an index into the scene's lines

    bool operator>(const Ranked& other) const
    {
        return std::tie(unlocked, cutEnds, length)
               > std::tie(other.unlocked, other.cutEnds, other.length);
    }
};

/// The parts of some lines inside a window, each with the number of its line.
std::vector<clipping::Clipped> insideOf(const std::vector<clipping::Segment>& lines,
                                        const TracedWindow& window)
{
    const clipping::Algorithm& exact = clipping::exactAlgorithm();
    std::vector<clipping::Clipped> inside(lines.size());
    inside.resize(window.corners.empty() ? exact.corrected.clipAll(lines, window.frame.box, inside)
                                         : exact.polygon->clipAll(lines, {window.corners}, inside));
    return inside;
}

Ranked rankOf(const clipping::Segment& line, const clipping::Segment& inside)
{
    Ranked ranked;
    ranked.cutEnds = (inside.a != line.a) + (inside.b != line.b);
    if (ranked.cutEnds == 1)
        ranked.length = glm::distance(line.a, line.b);
    return ranked;
}

/// The most interesting line; there must be at least one line.
std::size_t mostToSee(const SceneLines& lines, const TracedWindow& window,
                      const ObjectRanges& locked)
{
    Ranked best;
    for (const SceneLines::Run& run : lines.runs()) {
        std::vector<clipping::Segment> there;
        for (const clipping::Segment& line : run.segments)
            there.push_back(window.into(line));
        const auto inside = insideOf(there, window);
        auto next = inside.begin();
        for (std::size_t i = 0; i < there.size(); ++i) {
            const bool visible = next != inside.end() && next->source == i;
            Ranked ranked = visible ? rankOf(there[i], next++->segment) : Ranked{};
            ranked.line = run.firstLine + i;
            ranked.unlocked = locked.empty() || !locked.contains(lines.objectOf(ranked.line));
            if (ranked > best)
                best = ranked;
            if (best.unlocked && best.cutEnds == 2)
                return best.line;
        }
    }
    return best.line;
}

} // namespace

TracedLine tracedLineOf(const Session& session, std::size_t segment)
{
    const SceneLines& lines = session.scene.lines();
    const TracedWindow window = tracedWindow(session);
    const QString line =
        Text::tr("Line %1 of %2").arg(countText(segment + 1), countText(lines.size()));
    const QString remark = window.remark();
    TracedLine traced{.variant = session.variant(),
                      .line = window.into(lines[segment]),
                      .y = YAxis::Down,
                      .origin = remark.isEmpty() ? line : Text::tr("%1, %2").arg(line, remark)};
    window.putInto(traced);
    return traced;
}

std::optional<std::size_t> firstLine(const Session& session)
{
    const SceneLines& lines = session.scene.lines();
    if (lines.size() == 0)
        return std::nullopt;
    if (const auto inspected = session.inspected(); inspected && *inspected < lines.size())
        return inspected;
    return mostToSee(lines, tracedWindow(session), session.now().containers().lockedRanges());
}

TracedLine firstTracedLine(const Session& session)
{
    if (const auto line = firstLine(session))
        return tracedLineOf(session, *line);
    const TracedWindow window = tracedWindow(session);
    TracedLine traced{.variant = session.variant(),
                      .line = across(window.frame.box),
                      .y = YAxis::Down,
                      .origin = Text::tr("Example line")};
    window.putInto(traced);
    return traced;
}

} // namespace app

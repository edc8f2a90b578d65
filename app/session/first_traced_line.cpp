// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/first_traced_line.h"

#include "app/base/clock.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/line_to_see.h"

#include <cmath>

namespace app {

namespace {

/// A line that crosses the infinite line of ymin, enters the window at xmin and leaves it at ymax.
clipping::Segment across(const clipping::Window& window)
{
    const Point size = window.max - window.min;
    return {window.min - 0.3 * size, window.max + Point(-0.15, 0.4) * size};
}

/// The unit in which a drawing's own numbers are: "mm"; empty: none of its size.
QString unitOfNumbers(const Page& page)
{
    for (const UnitInfo& row : units())
        if (row.millimetres > 0 && std::abs(page.realMillimetresPerUnit() / row.millimetres - 1) < 1e-9)
            return QString::fromUtf8(row.suffix.data(), qsizetype(row.suffix.size()));
    return {};
}

/// Says after some time that the interface must not wait longer. A million lines take 2 ms if some
/// are cut; if the search is not over by then, the best of the first lines will do. Processor time,
/// so that a busy machine does not choose another line.
std::function<bool()> afterAFrame()
{
    constexpr std::uint64_t most = 6'000'000; // nanoseconds
    return [start = threadNanoseconds()] { return threadNanoseconds() - start > most; };
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
                      .origin = remark.isEmpty() ? line : Text::tr("%1, %2").arg(line, remark),
                      .unit = unitOfNumbers(session.now().page())};
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
    return lineToSee(lines, tracedWindow(session), session.now().containers().lockedRanges(),
                     afterAFrame());
}

TracedLine firstTracedLine(const Session& session)
{
    if (const auto line = firstLine(session))
        return tracedLineOf(session, *line);
    const TracedWindow window = tracedWindow(session);
    TracedLine traced{.variant = session.variant(),
                      .line = across(window.frame.box),
                      .y = YAxis::Down,
                      .origin = Text::tr("Example line"),
                      .unit = unitOfNumbers(session.now().page())};
    window.putInto(traced);
    return traced;
}

} // namespace app

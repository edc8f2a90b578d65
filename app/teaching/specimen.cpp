// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/specimen.h"

#include "app/view/numbers.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <tuple>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Microscope", text); }

/// A line that crosses a window from below to above, through two of its edges' lines on either
/// side.
clipping::Segment across(const clipping::Window& window)
{
    const Point size = window.max - window.min;
    return {window.min - 0.3 * size, window.max + Point(-0.15, 0.4) * size};
}

/// How much there is to see of a line; compared from the first member on.
struct Ranked {
    bool unlocked = false; ///< locked layers hold grids and the like
    int cutEnds = 0;
    double length = 0;    ///< of a line with one end cut
    std::size_t line = 0; ///< index into the scene's segments

    bool operator>(const Ranked& other) const
    {
        return std::tie(unlocked, cutEnds, length)
               > std::tie(other.unlocked, other.cutEnds, other.length);
    }
};

Ranked rankOf(const Session& session, std::size_t segment)
{
    const clipping::Segment& line = session.scene.segments()[segment];
    const Sheet& sheet = session.sheet();
    const auto layer = sheet.shapes[session.scene.shapeOf(segment)].layer;
    Ranked ranked{.unlocked = !sheet.layers[layer].locked, .line = segment};
    if (const auto piece = clipping::exactAlgorithm().corrected.clip(line, session.window()))
        ranked.cutEnds = (piece->a != line.a) + (piece->b != line.b);
    if (ranked.cutEnds == 1)
        ranked.length = glm::distance(line.a, line.b);
    return ranked;
}

} // namespace

Specimen specimenOf(const Session& session, std::size_t segment)
{
    const auto lines = session.scene.segments();
    return {.variant = {session.display().algorithm, session.display().usedForm()},
            .line = lines[segment],
            .window = session.window(),
            .y = YAxis::Down,
            .origin = tr("Line %1 of %2").arg(countText(segment + 1), countText(lines.size()))};
}

std::optional<std::size_t> firstLine(const Session& session)
{
    const auto lines = session.scene.segments();
    if (lines.empty() || (session.inspected() && *session.inspected() < lines.size()))
        return lines.empty() ? std::nullopt : session.inspected();
    Ranked best{.line = 0};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Ranked ranked = rankOf(session, i);
        if (ranked > best)
            best = ranked;
        if (best.unlocked && best.cutEnds == 2)
            break;
    }
    return best.line;
}

Specimen firstSpecimen(const Session& session)
{
    if (const auto line = firstLine(session))
        return specimenOf(session, *line);
    const clipping::Window& window = session.window();
    return {.variant = {session.display().algorithm, session.display().usedForm()},
            .line = across(window),
            .window = window,
            .y = YAxis::Down,
            .origin = tr("A line of its own")};
}

} // namespace app

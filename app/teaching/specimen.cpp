// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/specimen.h"

#include "app/view/numbers.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

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

} // namespace

Specimen specimenOf(const Session& session, std::size_t segment)
{
    const auto lines = session.scene.segments();
    return {.clipper = {session.display().algorithm, session.display().usedForm()},
            .line = lines[segment],
            .window = session.sheet().window,
            .y = YAxis::Down,
            .origin = tr("Line %1 of %2").arg(countText(segment + 1), countText(lines.size()))};
}

std::optional<std::size_t> firstLine(const Session& session)
{
    const auto lines = session.scene.segments();
    if (session.inspected() && *session.inspected() < lines.size())
        return session.inspected();
    const clipping::Window& window = session.sheet().window;
    std::size_t best = 0;
    double longest = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto piece = clipping::exactAlgorithm().corrected.clip(lines[i], window);
        if (!piece || *piece == lines[i])
            continue;
        if (piece->a != lines[i].a && piece->b != lines[i].b)
            return i;
        if (const double length = glm::distance(lines[i].a, lines[i].b); length > longest)
            longest = length, best = i;
    }
    return lines.empty() ? std::nullopt : std::optional(best);
}

Specimen firstSpecimen(const Session& session)
{
    if (const auto line = firstLine(session))
        return specimenOf(session, *line);
    const clipping::Window& window = session.sheet().window;
    return {.clipper = {session.display().algorithm, session.display().usedForm()},
            .line = across(window),
            .window = window,
            .y = YAxis::Down,
            .origin = tr("A line of its own")};
}

} // namespace app

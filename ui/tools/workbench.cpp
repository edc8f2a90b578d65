// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "ui/tools/tool.h"

namespace ui {

QString fontOfNext(const Workbench& bench)
{
    return app::hasFont(bench.keptFont) ? bench.keptFont : app::strokeFonts().front().name;
}

std::optional<app::GridPoints> Workbench::grid() const
{
    const app::Grid& grid = session.display().grid;
    return grid.shown ? std::optional(app::gridPoints(grid, session.now().page(), view.zoom))
                      : std::nullopt;
}

const app::Guides* Workbench::guides() const
{
    return session.display().guides ? &session.now().page().guides : nullptr;
}

app::MovedSnap Workbench::moved(const app::OwnPoints& own, const app::Point& by,
                                Qt::KeyboardModifiers modifiers, const app::ObjectRanges& without,
                                app::SnapTo allowed, std::optional<std::size_t> withoutWindow) const
{
    const app::SnapTo to = snapTo & allowed;
    if (to == app::SnapTo::Nothing || modifiers & Qt::ControlModifier)
        return {by};
    return snapper.moved(own, by,
                         {.pointer = {},
                          .radius = inDrawing(snapReach),
                          .to = to,
                          .without = without,
                          .withoutWindow = withoutWindow,
                          .seen = view.visible(),
                          .grid = grid(),
                          .guides = guides()});
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_frame.h"

namespace app {

Recipe onlyRecipe(const Session& session)
{
    const ObjectRanges& selection = session.selection();
    return selection.size() == 1 ? session.now().objects()[selection.first()].particulars().recipe
                                 : Recipe{};
}

std::optional<WindowFrame> selectionFrame(const Session& session)
{
    const Recipe recipe = onlyRecipe(session);
    if (const auto* r = std::get_if<RectangleRecipe>(&recipe); r && r->turn != 0)
        return WindowFrame{{r->corner, r->corner + r->size}, r->turn};
    if (const auto* e = std::get_if<EllipseRecipe>(&recipe); e && e->turn != 0)
        return WindowFrame{{e->centre - e->radii, e->centre + e->radii}, e->turn};
    const auto& box = session.selectionBounds();
    return box ? std::optional(WindowFrame{*box}) : std::nullopt;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/layer_colour.h"

#include "app/base/text.h"
#include "app/commands/set_containers.h"
#include "app/formats/svg/declarations.h"

namespace app {
namespace {

std::optional<Style> styleOf(const Container& layer)
{
    return layer.newStyle.isEmpty() ? std::nullopt : svg::styleOf(layer.newStyle);
}

} // namespace

std::optional<Colour> layerColour(const Document& document, ContainerId layer)
{
    const auto style = styleOf(document.containers()[layer]);
    return style ? style->stroke : std::nullopt;
}

void setLayerColour(Session& session, ContainerId layer, const std::optional<Colour>& colour)
{
    const Container& before = session.now().containers()[layer];
    Container after = before;
    after.newStyle.clear();
    if (colour) {
        Style style = styleOf(before).value_or(session.pen.style);
        style.stroke = colour;
        after.newStyle = svg::declarations(style);
    }
    if (after != before)
        session.history.push(new SetContainers(
            session.document, session.now().containers().with(after), Text::tr("Layer colour")));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/layer_colour.h"

#include "app/base/text.h"
#include "app/commands/set_containers.h"
#include "app/formats/svg/style_text.h"

#include <algorithm>

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

namespace {

constexpr std::size_t mostStyles = 8192; // examined: takes about 30 µs

// Only one style if all objects of the block share it.
std::span<const StyleIndex> stylesIn(const ObjectBlock& block, std::size_t first, std::size_t end)
{
    const std::span<const StyleIndex> styles(block.styles);
    return styles.size() == 1 ? styles : styles.subspan(first, end - first);
}

} // namespace

std::optional<Colour> strokeColourOf(const Document& document, ContainerId container)
{
    const Objects& objects = document.objects();
    const ObjectRange range = document.containers().rangeOf(container);
    std::size_t looked = 0;
    for (std::size_t i = range.first; i < range.end && looked < mostStyles;) {
        const std::size_t at = objects.blockOf(i), first = objects.firstOf(at);
        const ObjectBlock& block = *objects.blocks()[at];
        const std::size_t end = std::min(range.end - first, block.size());
        for (const StyleIndex index : stylesIn(block, i - first, end)) {
            const Style& style = document.styles()[index];
            if (style.stroke || style.fill)
                return style.stroke ? style.stroke : style.fill;
            ++looked;
        }
        i = first + end;
    }
    return std::nullopt;
}

} // namespace app

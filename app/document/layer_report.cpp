// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/layer_report.h"

namespace app {

std::size_t linesOf(const Session& session, ContainerId container)
{
    const ObjectRange range = session.now().containers().rangeOf(container);
    const SceneLines& lines = session.scene.lines();
    return range.empty() ? 0 : lines.firstLineOf(range.end) - lines.firstLineOf(range.first);
}

std::optional<Colour> inkOf(const Document& document, ContainerId container)
{
    const ObjectRange range = document.containers().rangeOf(container);
    for (std::size_t i = range.first; i < range.end; ++i) {
        const Style& style = document.objects()[i].style();
        if (style.stroke || style.fill)
            return style.stroke ? style.stroke : style.fill;
    }
    return std::nullopt;
}

} // namespace app

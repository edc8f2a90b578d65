// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/edge_words.h"

#include "app/base/text.h"

#include <array>

namespace app {

QString edgeWords(clipping::Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> up{
        "", QT_TRANSLATE_NOOP("Text", "the left edge"), QT_TRANSLATE_NOOP("Text", "the right edge"),
        QT_TRANSLATE_NOOP("Text", "the bottom edge"), QT_TRANSLATE_NOOP("Text", "the top edge")};
    if (edge == clipping::Edge::NoEdge || edge > clipping::Edge::Top)
        return {};
    return Text::tr(up[seenEdge(edge, y)]);
}

} // namespace app

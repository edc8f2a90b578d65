// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

namespace app {

namespace {

constexpr clipping::Segment edges[]{
    {{-1, -1}, {-1, 1}}, {{-1, -0.6}, {1, -0.6}}, {{-1, 0.6}, {0.2, 0.6}}};
constexpr clipping::Segment edgesAndPoint[]{{{-1, -1}, {-1, 1}},
                                            {{-1, -0.6}, {1, -0.6}},
                                            {{0.2, 0.2}, {0.8, 0.8}},
                                            {{0.2, 0.8}, {0.8, 0.2}}};

} // namespace

SnapKind alignmentKind()
{
    return {.key = "alignment",
            .name = Text::tr("Alignment when moving"),
            .word = Text::tr("aligned"),
            .rank = SnapRank::Along,
            .glyph = edges};
}

SnapKind drawnAlignment()
{
    return {.key = "drawn-alignment",
            .name = Text::tr("Alignment when drawing"),
            .word = Text::tr("in line"),
            .rank = SnapRank::Along,
            .usual = false,
            .glyph = edgesAndPoint};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
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
            .name = snapText("Alignment when moving"),
            .word = snapText("aligned"),
            .rank = SnapRank::Along,
            .glyph = edges};
}

SnapKind drawnAlignment()
{
    return {.key = "drawn-alignment",
            .name = snapText("Alignment when drawing"),
            .word = snapText("in line"),
            .rank = SnapRank::Along,
            .usual = false,
            .glyph = edgesAndPoint};
}

} // namespace app

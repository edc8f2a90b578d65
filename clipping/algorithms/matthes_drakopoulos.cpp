// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos (2019), the method this project grew from.
//
//   D. Matthes, V. Drakopoulos: Another Simple but Faster Method for 2D Line Clipping.
//   International Journal of Computer Graphics & Animation 9(1/2/3), 2019, 1-15.

#include "clipping/describe.h"

namespace clipping {

struct MatthesDrakopoulos {
    static constexpr About about{
        .key = "matthes-drakopoulos",
        .abbreviation = "MD",
        .name = "Matthes-Drakopoulos",
        .year = 2019,
        .idea = "Push both ends to the edges they are beyond; what is still outside was never inside.",
        .ulps = 64,
    };

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    clip(const BasicSegment<T>& s, const BasicWindow<T>& w, Watch&& watch)
    {
        const auto& [a, b] = s;
        if ((a.x < w.min.x && b.x < w.min.x) || (a.x > w.max.x && b.x > w.max.x)
            || (a.y < w.min.y && b.y < w.min.y) || (a.y > w.max.y && b.y > w.max.y)) {
            watch("reject", 1, s, Edge::None);
            return std::nullopt;
        }
        BasicSegment<T> visible = s;
        for (auto* p : {&visible.a, &visible.b}) {
            if (p->x < w.min.x) {
                *p = {w.min.x, (b.y - a.y) / (b.x - a.x) * (w.min.x - a.x) + a.y};
                watch("cut", 4, visible, Edge::Left);
            } else if (p->x > w.max.x) {
                *p = {w.max.x, (b.y - a.y) / (b.x - a.x) * (w.max.x - a.x) + a.y};
                watch("cut", 7, visible, Edge::Right);
            }
            if (p->y < w.min.y) {
                *p = {(b.x - a.x) / (b.y - a.y) * (w.min.y - a.y) + a.x, w.min.y};
                watch("cut", 10, visible, Edge::Bottom);
            } else if (p->y > w.max.y) {
                *p = {(b.x - a.x) / (b.y - a.y) * (w.max.y - a.y) + a.x, w.max.y};
                watch("cut", 13, visible, Edge::Top);
            }
        }
        if ((visible.a.x < w.min.x && visible.b.x < w.min.x)
            || (visible.a.x > w.max.x && visible.b.x > w.max.x)) {
            watch("reject", 16, visible, Edge::None);
            return std::nullopt;
        }
        watch("accept", 17, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<MatthesDrakopoulos>();

} // namespace clipping

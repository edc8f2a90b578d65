// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"

#include <algorithm>

/// Lines as a scene has them, so many in a block; behind each block is one of a hidden object.
inline app::SceneLines sceneLinesOf(std::span<const clipping::Segment> lines,
                                    std::size_t inBlock = 17'000)
{
    std::vector<app::Shared<app::SceneBlock>> blocks;
    while (!lines.empty()) {
        const auto some = lines.first(std::min(inBlock, lines.size()));
        blocks.emplace_back(app::SceneBlock{.segments = {some.begin(), some.end()}});
        blocks.emplace_back(app::SceneBlock{.firstOfObject = {0, 0}});
        lines = lines.subspan(some.size());
    }
    return app::SceneLines(std::move(blocks));
}

/// All of them in one array.
inline std::vector<clipping::Segment> allOf(const app::SceneLines& lines)
{
    std::vector<clipping::Segment> all;
    for (const app::SceneLines::Run& run : lines.runs())
        all.insert(all.end(), run.segments.begin(), run.segments.end());
    return all;
}

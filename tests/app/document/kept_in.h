// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"

#include <cstring>

/// All that a frame keeps, in the order of the lines; `source` counts in the scene.
inline std::vector<clipping::Clipped> keptIn(const app::SceneFrame& frame)
{
    std::vector<clipping::Clipped> all;
    for (const app::SceneFrame::Block& here : frame.blocks) {
        const app::SceneBlock& block = *here.block;
        auto piece = here.pieces.begin();
        for (std::size_t chunk = 0; chunk < here.remains.size(); ++chunk) {
            const std::size_t end = block.endOfChunk(chunk);
            if (here.remains[chunk] == app::Remains::Whole)
                for (std::size_t i = block.chunks[chunk].first; i < end; ++i)
                    all.push_back({block.segments[i], std::uint32_t(here.firstLine + i), 0});
            for (; piece != here.pieces.end() && piece->source < end; ++piece)
                all.push_back(
                    {piece->segment, std::uint32_t(here.firstLine + piece->source), piece->cut});
        }
    }
    return all;
}

/// Whether they are the same, bit for bit.
inline bool same(std::span<const clipping::Clipped> one, std::span<const clipping::Clipped> other)
{
    return one.size() == other.size()
           && (one.empty() || std::memcmp(one.data(), other.data(), one.size_bytes()) == 0);
}

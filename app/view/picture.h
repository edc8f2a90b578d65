// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"
#include "app/scene/scene_lines.h"
#include "app/view/draw_list.h"
#include "app/view/picture_options.h"

#include <algorithm>
#include <array>

namespace app {

/// One frame as draw lists, painted in this order: bands below the selected objects, which keep
/// their colours (`selected`); the ghost, as a whole with the ghost's opacity (so that overlapping
/// ghosts do not add up); the kept part; the differing pieces; borders of clip windows.
struct Picture {
    DrawList selected, ghost, kept, differing, borders;
    bool isEmpty() const
    {
        return std::ranges::all_of(std::array{&selected, &ghost, &kept, &differing, &borders},
                                   [](const DrawList* list) { return list->commands.empty(); });
    }
};

/// Whether selected objects are shown one by one: up to 500 of them, or 20,000 lines.
bool outlines(const SceneLines& lines, std::span<const ObjectRange> selection);

/// A frame as the canvases paint it. `lines` are the frame's lines, `styles` the styles of their
/// document. Everything is clipped to the view, so that painters get no huge numbers at deep zoom.
/// Dashed strokes are divided into dashes. Areas are cut at the clip windows.
/// Strokes move by less than a quarter of a pixel where many points fall into one pixel.
Picture picture(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                const PictureOptions& options);

/// All lines and areas of a frame, whatever its windows remove.
DrawList wholeDrawing(const StyleTable& styles, const SceneLines& lines, const SceneFrame& frame,
                      const PictureOptions& options);
/// The parts of a frame below and above the drawing: bands of the selection, marks of differences,
/// borders.
Picture pictureAround(const StyleTable& styles, const SceneLines& lines,
                      const PictureOptions& options);

} // namespace app

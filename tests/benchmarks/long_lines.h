// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/experiment/paper_scene.h"

/// The paper's scene as a drawing: lines with both ends anywhere on the page, with its window.
inline app::Document longLines(std::size_t count)
{
    app::PaperScene scene(1);
    std::vector<clipping::Segment> lines(count);
    scene.fill(lines);
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    const app::StyleEntry style = builder.style({.stroke = app::Colour{}, .width = 1});
    for (const clipping::Segment& line : lines)
        builder.addLine(line, style);
    builder.close();
    return builder.take({{-960, -720}, {1920, 1440}, {1920, app::Unit::Px}, {1440, app::Unit::Px}},
                        {}, {{{.shape = app::RectangleShape{app::paperWindow}}}});
}

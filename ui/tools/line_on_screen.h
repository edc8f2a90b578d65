// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

#include <QLineF>

namespace ui {

/// The part of a line on the canvas and somewhat around it, in logical pixels: painters fail with
/// huge numbers. Empty: it is not visible.
inline std::optional<QLineF> lineOnScreen(const clipping::Segment& line, const Workbench& bench)
{
    static const auto clip = clipping::algorithms().front().corrected.clip;
    constexpr double around = 64; // pixels
    const double room = bench.inDrawing(around);
    const clipping::Window window = bench.view.visible();
    const auto part = clip(line, {window.min - room, window.max + room});
    if (!part)
        return std::nullopt;
    return QLineF(bench.onScreen(part->a), bench.onScreen(part->b));
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/document/underlay.h"

#include <QPointF>
#include <QTransform>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// A polyline on screen, in logical pixels from the top left corner of the canvas.
struct Polyline {
    std::uint32_t first, count; ///< in DrawList::points; at least two
    bool closed;                ///< the last point equals the first: a join there, no caps
    bool capAtStart, capAtEnd;  ///< true for the stroke's own ends; ends made by a cut are butt
};

/// A stroke style; the width is in logical pixels.
struct StrokeStyle {
    Colour colour;
    double width = 1;
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    double miterLimit = 4;
    friend bool operator==(const StrokeStyle&, const StrokeStyle&) = default;
};

/// An image below a layer.
struct DrawnImage {
    SharedUnderlay underlay;
    QTransform toScreen; ///< from the drawing to logical pixels
    double opacity = 1;  ///< in addition to its own
};

/// A draw command: consecutive polylines that are stroked with one style, or filled together as one
/// area; or an image.
struct DrawCommand {
    std::optional<StrokeStyle> stroke;
    Colour fill{};
    FillRule rule = FillRule::NonZero;
    std::uint32_t firstPolyline = 0, polylines = 0;
    std::optional<std::uint32_t> image{}; ///< in DrawList::images
};

/// A draw list: draw commands from bottom to top.
struct DrawList {
    std::vector<DrawCommand> commands;
    std::vector<Polyline> polylines;
    std::vector<QPointF> points;
    std::vector<DrawnImage> images;

    std::span<const Polyline> polylinesOf(const DrawCommand& command) const
    {
        return std::span(polylines).subspan(command.firstPolyline, command.polylines);
    }
    std::span<const QPointF> pointsOf(const Polyline& polyline) const
    {
        return std::span(points).subspan(polyline.first, polyline.count);
    }
    /// Draws these above the others.
    void append(const DrawList& above)
    {
        const auto before = std::uint32_t(polylines.size());
        const auto pointsBefore = std::uint32_t(points.size());
        for (DrawCommand command : above.commands) {
            command.firstPolyline += before;
            if (command.image)
                *command.image += std::uint32_t(images.size());
            commands.push_back(command);
        }
        for (Polyline polyline : above.polylines) {
            polyline.first += pointsBefore;
            polylines.push_back(polyline);
        }
        points.insert(points.end(), above.points.begin(), above.points.end());
        images.insert(images.end(), above.images.begin(), above.images.end());
    }
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"

// The kinds of overlays, one file each. An algorithm's row (app/teaching/teaching.h) names its own
// overlay, or has the default. Each has an area or a line and a caption, and with a line also a
// mark at each of its ends, and another caption.

namespace app {

/// The input of an overlay: all numbers are finite, and the window has min <= max.
struct OverlayContext : OverlaySubject {
    clipping::Trace trace{}; ///< of the line, if any

    /// The trace of this variant for another line.
    clipping::Trace traceOf(const clipping::Segment& other) const
    {
        if (!corners.empty())
            return polygonUsesOf(variant)->trace(other, {corners});
        return clipping::functionsOf(*variant.algorithm, variant.form)->trace(other, window);
    }
};

Overlay outcodeOverlay(const OverlayContext& context);   ///< Cohen-Sutherland
Overlay scriptOverlay(const OverlayContext& context);    ///< Sobkow-Pospisil-Yang
Overlay midpointOverlay(const OverlayContext& context);  ///< Midpoint subdivision
Overlay signOverlay(const OverlayContext& context);      ///< Skala
Overlay sectorOverlay(const OverlayContext& context);    ///< Nicholl-Lee-Nicholl
Overlay parameterOverlay(const OverlayContext& context); ///< Liang-Barsky, Cyrus-Beck
Overlay pushOverlay(const OverlayContext& context);      ///< Kodituwakku…, Matthes-Drakopoulos
Overlay cellOverlay(const OverlayContext& context);      ///< Slater-Barsky
Overlay turnOverlay(const OverlayContext& context);      ///< Exact

/// The default overlay of any algorithm: the edges, and the points where its steps cut the line.
Overlay traceOverlay(const OverlayContext& context);

/// The overlay of any algorithm at a convex polygon.
Overlay polygonOverlay(const OverlayContext& context);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/overlays/overlay.h"

// The kinds of overlays, one file each. An algorithm's row (app/teaching/teaching.h) names its own
// overlay, or has the default. Each has an area or a line and a caption, and with a line also a
// mark at each of its ends, and another caption.

namespace app {

/// The input of an overlay: all numbers are finite, and the window has min <= max.
struct Seeing : OverlaySubject {
    clipping::Trace trace{}; ///< of the line, if any

    /// The trace of this variant for another line.
    clipping::Trace traceOf(const clipping::Segment& other) const
    {
        return clipping::usesOf(*variant.algorithm, variant.form)->trace(other, window);
    }
};

Overlay outcodeOverlay(const Seeing& seeing);   ///< Cohen-Sutherland
Overlay scriptOverlay(const Seeing& seeing);    ///< Sobkow-Pospisil-Yang
Overlay midpointOverlay(const Seeing& seeing);  ///< Midpoint subdivision
Overlay signOverlay(const Seeing& seeing);      ///< Skala
Overlay sectorOverlay(const Seeing& seeing);    ///< Nicholl-Lee-Nicholl
Overlay parameterOverlay(const Seeing& seeing); ///< Liang-Barsky, Cyrus-Beck
Overlay pushOverlay(const Seeing& seeing);      ///< Kodituwakku…, Matthes-Drakopoulos
Overlay cellOverlay(const Seeing& seeing);      ///< Slater-Barsky
Overlay turnOverlay(const Seeing& seeing);      ///< Exact

/// The default overlay of any algorithm: the edges, and the points where its steps cut the line.
Overlay traceOverlay(const Seeing& seeing);

} // namespace app

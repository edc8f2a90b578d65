// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "app/document/subpath.h"

#include <QStringList>

#include <optional>
#include <vector>

// An algorithm's view of the plane around the clip window: plain data, computed by the library,
// painted by the user interface. All points are in drawing coordinates.

namespace app {

/// Lit: relevant to the line under the pointer.
enum class Emphasis : std::uint8_t { Quiet, Highlighted };

/// A convex piece of the plane, clipped to the visible part.
struct OverlayArea {
    std::vector<Point> corners{}; ///< in order; empty if nothing is visible
    QString label{};              ///< "1001", "LT"; empty: lines that end there are not visible
    std::uint32_t strong = 0;     ///< emphasized characters of the label; bit 0: the first
    Emphasis emphasis = Emphasis::Quiet;
    bool pointed = false; ///< the pointer is in this area, by the library's own computation
    enum class Ground : std::uint8_t { Clear, Hatched };
    Ground ground = Ground::Clear;
};

/// A straight line, clipped to the visible part.
struct OverlayLine {
    clipping::Segment segment{};
    enum class Kind : std::uint8_t {
        Border, ///< of a half-plane or of areas
        Ray,    ///< from an end through a corner
        Move    ///< the path of a moved end, from a to b
    };
    Kind kind = Kind::Border;
    QString label{};
    Point outwards{}; ///< direction of the discarded side; {0, 0}: there is no such side
    Emphasis emphasis = Emphasis::Quiet;
};

/// A point with a word.
struct OverlayMark {
    Point at{};
    enum class Symbol : std::uint8_t { End, Filled, Hollow, Plus, Minus, Diamond };
    Symbol symbol = Symbol::End; ///< End: an end of the line itself
    QString label{};
    Emphasis emphasis = Emphasis::Quiet;
};

/// The line as an axis from its first end, t = 0, to its second, t = 1.
struct OverlayAxis {
    struct Tick {
        double t;     ///< any number
        bool enters;  ///< otherwise the line leaves there
        QString edge; ///< "left": as seen on screen
        Emphasis emphasis;
    };
    std::vector<Tick> ticks{}; ///< empty if the line lies on an edge's line
    double from = 0, to = 1;   ///< the visible part is between them; empty if from > to
};

/// Digits of a parameter: between 0 and 1, four are finer than the pixels of a screen.
constexpr int parameterDigits = 4;

struct OverlayTable {
    QStringList heading{};
    std::vector<QStringList> rows{}; ///< as many cells as the heading
    std::optional<std::size_t> highlightedRow{};
};

/// The content of an overlay, painted in this order.
struct Overlay {
    std::vector<OverlayArea> areas{};
    std::vector<OverlayLine> lines{};
    std::vector<OverlayMark> marks{};
    std::optional<OverlayAxis> axis{};
    std::optional<OverlayTable> table{};
    QString caption{}; ///< one or two sentences: what is shown, or how to see more
};

/// The subject of an overlay.
struct OverlaySubject {
    Variant variant{};
    clipping::Window window{};
    std::optional<clipping::Segment> line{}; ///< empty: only the pointer is shown
    std::optional<Point> pointer{};
    clipping::Window seen{}; ///< the part of the drawing that is on the screen
    YAxis y = YAxis::Down;
    /// Of the window about its centre (radians, from x towards y). The edges then have the names
    /// that they have in the window's own directions.
    double angle = 0;
    /// The corners of a window that is a convex polygon, as in clipping::ConvexPolygon; `window` is
    /// its bounding box then. Empty: a rectangle.
    std::vector<Point> corners{};
};

} // namespace app

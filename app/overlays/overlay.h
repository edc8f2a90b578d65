// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "app/document/subpath.h"

#include <QStringList>

#include <optional>
#include <vector>

// What an algorithm sees of the plane around the clip window: plain data, made of what the library
// computes, painted by whoever has a screen. All points are the drawing's.

namespace app {

/// Lit: the line that is looked at has to do with it.
enum class Emphasis : std::uint8_t { Quiet, Lit };

/// A convex piece of the plane, cut to what is seen of it.
struct OverlayArea {
    std::vector<Point> corners{}; ///< in order; none: nothing of it is seen
    QString label{};              ///< "1001", "LT"; empty: what ends there is not visible
    std::uint32_t strong = 0;     ///< the characters of the label that stand out; bit 0: the first
    Emphasis emphasis = Emphasis::Quiet;
    bool pointed = false; ///< the pointer is there, by what the library computes of its place
    enum class Ground : std::uint8_t { Clear, Hatched };
    Ground ground = Ground::Clear;
};

/// A straight line, cut to what is seen of it.
struct OverlayLine {
    clipping::Segment segment{};
    enum class Kind : std::uint8_t {
        Border, ///< of a half-plane or of areas
        Ray,    ///< from an end through a corner
        Move    ///< the way an end is moved, from a to b
    };
    Kind kind = Kind::Border;
    QString label{};
    Point outwards{}; ///< the side that is not kept, as a direction; {0, 0}: it has no such side
    Emphasis emphasis = Emphasis::Quiet;
};

/// A point, with a word.
struct OverlayMark {
    Point at{};
    enum class Symbol : std::uint8_t { End, Filled, Hollow, Plus, Minus, Diamond };
    Symbol symbol = Symbol::End; ///< End: of the line itself
    QString label{};
    Emphasis emphasis = Emphasis::Quiet;
};

/// The line from its first end, t = 0, to its second, t = 1.
struct OverlayAxis {
    struct Tick {
        double t;     ///< any number
        bool enters;  ///< else it leaves
        QString edge; ///< "left": as it is seen
        Emphasis emphasis;
    };
    std::vector<Tick> ticks{}; ///< none where the line runs along an edge's line
    double from = 0, to = 1;   ///< what is visible is between them; nothing if from > to
};

/// A parameter in four digits: between 0 and 1 that is more than a screen has pixels.
QString parameterText(double t);

struct OverlayTable {
    QStringList heading{};
    std::vector<QStringList> rows{}; ///< as many cells as the heading has
    std::optional<std::size_t> lit{};
};

/// All that is shown; in this order, one over the other.
struct Overlay {
    std::vector<OverlayArea> areas{};
    std::vector<OverlayLine> lines{};
    std::vector<OverlayMark> marks{};
    std::optional<OverlayAxis> axis{};
    std::optional<OverlayTable> table{};
    QString caption{}; ///< one or two sentences: what is shown, or what to do to see more
};

/// What is looked at.
struct OverlaySubject {
    Variant variant{};
    clipping::Window window{};
    std::optional<clipping::Segment> line{}; ///< nothing: only the pointer is looked at
    std::optional<Point> pointer{};
    clipping::Window seen{}; ///< the part of the drawing that the screen shows
    YAxis y = YAxis::Down;
};

} // namespace app

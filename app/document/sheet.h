// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/length.h"
#include "app/document/style.h"
#include "clipping/geometry.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

// The drawing as plain data. All coordinates are the drawing's user units, y down (the SVG's),
// transforms already applied. Everything compares with ==, which is how round trips are tested.

namespace app {

using Point = glm::dvec2;

/// One segment of a path, from where the last one ended: a line, or a cubic Bézier curve.
struct PathSegment {
    Point to;
    Point control1{}, control2{}; ///< zero for a line
    bool curved = false;
    friend bool operator==(const PathSegment&, const PathSegment&) = default;
};

/// A connected run of segments. A closed one returns to `start` by a line if it is not there yet.
/// No segments at all: a single point.
struct Subpath {
    Point start;
    std::vector<PathSegment> segments;
    bool closed = false;
    friend bool operator==(const Subpath&, const Subpath&) = default;
};

/// What is selected, styled, moved and deleted as one: an SVG element.
struct Shape {
    std::vector<Subpath> paths;
    Style style;
    QString id;              ///< the SVG's, kept through cut and export; may be empty
    std::uint32_t layer = 0; ///< index into Sheet::layers
    bool hidden = false;     ///< stays hidden and is not exported
    friend bool operator==(const Shape&, const Shape&) = default;
};

struct Layer {
    QString name;
    bool visible = true;
    bool locked = false;
    QString id{}; ///< the SVG's; may be empty
    friend bool operator==(const Layer&, const Layer&) = default;
};

/// The page: its rectangle in user units (the whole sheet of paper; an SVG's viewBox) and its size
/// on paper. Lengths with a unit count from its `min`, the paper's top left corner.
struct Page {
    Point min{0, 0};
    Point size{297, 210};
    Length width{297, Unit::Mm}, height{210, Unit::Mm};
    friend bool operator==(const Page&, const Page&) = default;

    /// The physical size of a user unit; 1 px (25.4 / 96 mm) where the file does not say.
    double millimetresPerUnit() const;
    /// The unit in which its drawing is read: that of its width, pixels where it has none.
    Unit usualUnit() const;
    clipping::Window rectangle() const { return {min, min + size}; }
};

/// What a file says about itself: title, author, licence … It is kept as the file has it: XML in
/// which every prefix is declared; "" where the file says nothing.
struct About {
    QString id;          ///< plain text: the root's
    QString comments;    ///< <!-- … --> before and after the root, where licences often stand
    QString title;       ///< the root's <title> elements
    QString description; ///< its <desc> elements
    QString metadata;    ///< its <metadata> elements, apart from Clearcut's own
    friend bool operator==(const About&, const About&) = default;
};

/// A whole drawing.
struct Sheet {
    Page page;
    std::vector<Layer> layers{{QStringLiteral("Drawing")}}; ///< bottom to top, never empty
    std::vector<Shape> shapes; ///< bottom to top; `layer` never decreases
    clipping::Window window = page.rectangle(); ///< the clip window
    About about{};
    friend bool operator==(const Sheet&, const Sheet&) = default;

    bool shown(const Shape& shape) const { return !shape.hidden && layers[shape.layer].visible; }
};

} // namespace app

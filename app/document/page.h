// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/document/subpath.h"

namespace app {

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

} // namespace app

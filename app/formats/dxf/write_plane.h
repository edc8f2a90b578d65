// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app::dxf::writing {

/// The plane of a DXF file, in which y points up.
class Plane {
public:
    /// In the page's unit, at the drawing's real size; pixels become millimetres. Without a page
    /// (CSV) pixels have no size, and the numbers stay. y_up.h says where the origin is.
    Plane(const Page& page, const WriteOptions& options);

    Point operator()(const Point& p) const { return {p.x * scale_, height_ - p.y * scale_}; }
    clipping::Window operator()(const clipping::Window& window) const;
    Subpath operator()(Subpath path) const;

    double length(double userUnits) const { return userUnits * scale_; }
    int unit() const { return unit_; }                  ///< the value of $INSUNITS
    double millimetres() const { return millimetres_; } ///< of that unit; 1 without one

private:
    double scale_ = 1, height_ = 0, millimetres_ = 1;
    int unit_ = 0;
};

} // namespace app::dxf::writing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_plane.h"

#include "app/formats/y_up.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::dxf::writing {
namespace {

struct UnitCode {
    Unit unit;
    int code; ///< for $INSUNITS
};
constexpr std::array unitCodes{
    UnitCode{Unit::Mm, 4},   UnitCode{Unit::Cm, 5},   UnitCode{Unit::Metre, 6},
    UnitCode{Unit::Inch, 1}, UnitCode{Unit::Foot, 2},
};

/// Null: lengths of the drawing are in pixels.
const UnitCode* codeOf(const Page& page)
{
    const auto found = std::ranges::find(unitCodes, page.usualUnit(), &UnitCode::unit);
    return found == unitCodes.end() ? nullptr : &*found;
}

} // namespace

Plane::Plane(const Page& page, const WriteOptions& options)
{
    const UnitCode* const found = codeOf(page);
    if (!found && !options.paged)
        return;
    const auto& [unit, code] = found ? *found : unitCodes.front();
    unit_ = code;
    millimetres_ = infoOf(unit).millimetres;
    scale_ = page.realMillimetresPerUnit() / millimetres_;
    if (std::abs(scale_ - 1) < 1e-12) // but for rounding
        scale_ = 1;
    height_ = heightOfPlane(page, options) * scale_;
}

clipping::Window Plane::operator()(const clipping::Window& window) const
{
    const Point a = (*this)(window.min), b = (*this)(window.max);
    return {{a.x, b.y}, {b.x, a.y}};
}

Subpath Plane::operator()(Subpath path) const
{
    forEachPoint(path, [this](Point& p) { p = (*this)(p); });
    return path;
}

} // namespace app::dxf::writing

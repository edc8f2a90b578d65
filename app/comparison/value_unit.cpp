// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/value_unit.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

struct Name {
    std::string_view name;
    ValueUnit unit;
};

using enum ValueUnit;

/// The units of names, as most forms use them.
constexpr auto common = std::to_array<Name>({
    {"t", Bare},
    {"tE", Bare},
    {"tL", Bare},
    {"u0", Bare},
    {"u1", Bare},
    {"r", Bare},
    {"m", Bare},
    {"n", Bare},
    {"f", Bare},
    {"last", Bare},
    {"nx", Bare},
    {"ny", Bare},
    {"dx", Length},
    {"dy", Length},
    {"px", Length},
    {"py", Length},
    {"p", Length},
    {"q", Length},
    {"D", Length},
    {"N", Length},
    {"rise", Length},
    {"run", Length},
    {"way[1]", Length},
    {"way[2]", Length},
    {"toLeft", Length},
    {"toRight", Length},
    {"toBottom", Length},
    {"toTop", Length},
    {"e", Area},
    {"F", Area},
    {"f[0]", Area},
    {"f[1]", Area},
    {"f[2]", Area},
    {"f[3]", Area},
    {"pxmin", Area},
    {"pxmax", Area},
    {"pymin", Area},
    {"pymax", Area},
    {"x", X},
    {"y", Y},
    {"xi", X},
    {"yi", Y},
    {"xo", X},
    {"yo", Y},
    {"xv", X},
    {"yv", Y},
    {"xw", X},
    {"yw", Y},
    {"xn", X},
    {"yn", Y},
    {"xf", X},
    {"yf", Y},
    {"xm", X},
    {"ym", Y},
    {"xnear", X},
    {"ynear", Y},
    {"xfar", X},
    {"yfar", Y},
    {"X", X},
    {"Y", Y},
    {"X[k]", X},
    {"Y[k]", Y},
    {"yIn", Y},
    {"yOut", Y},
    {"c", FixedLength}, // of y = mx + c
    // The line and the window are known; who tells them again has turned the plane.
    {"xmin", Turned},
    {"ymin", Turned},
    {"xmax", Turned},
    {"ymax", Turned},
    {"x1", Turned},
    {"y1", Turned},
    {"x2", Turned},
    {"y2", Turned},
});

/// The units of names that one published form uses for other quantities.
struct Own {
    std::string_view key;
    Name name;
};
constexpr auto published = std::to_array<Own>({
    {"cyrus-beck", {"nx", Length}}, // its normals are as long as the edges
    {"cyrus-beck", {"ny", Length}},
    {"cyrus-beck", {"D", Area}},
    {"cyrus-beck", {"N", Area}},
    {"skala", {"ex[n]", Bare}}, // lines and points are vectors of three: x, y and w
    {"skala", {"ey[n]", Bare}},
    {"skala", {"ew[n]", FixedLength}},
    {"skala", {"pw", FixedArea}},
    {"skala", {"x", FixedArea}},
    {"skala", {"y", FixedArea}},
    {"skala", {"w", Length}},
});

} // namespace

std::optional<ValueUnit> unitOfValue(const Clipper& clipper, std::string_view name)
{
    if (clipper.form == clipping::Form::Published)
        for (const Own& own : published)
            if (own.key == clipper.algorithm->key && own.name.name == name)
                return own.name.unit;
    const auto* const found = std::ranges::find(common, name, &Name::name);
    return found == common.end() ? std::nullopt : std::optional(found->unit);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/path.h"

#include <QString>

#include <variant>

namespace app {

// The shape that a path was made from, kept while the path still matches it, so that the shape can
// be edited. Lengths are in user units, angles in radians from the x axis towards the y axis
// (clockwise on screen).

struct RectangleRecipe {
    Point corner; ///< the smallest x and y, before the turn
    Point size;
    double radius = 0; ///< of the rounded corners
    double turn = 0;   ///< about the centre; never a multiple of a right angle other than 0
    friend bool operator==(const RectangleRecipe&, const RectangleRecipe&) = default;
};
struct EllipseRecipe {
    Point centre, radii;
    double turn = 0; ///< of the radii; 0 for a circle, and as for a rectangle
    friend bool operator==(const EllipseRecipe&, const EllipseRecipe&) = default;
};
struct StarRecipe {
    Point centre;
    double outer = 0, inner = 0; ///< radii of the outer and inner corners; inner 0: a polygon
    double turn = 0;             ///< the angle of the first outer corner
    int points = 5;              ///< number of outer corners
    friend bool operator==(const StarRecipe&, const StarRecipe&) = default;
};
/// Which letters of a family: its bold and italic ones, where it has them.
struct FontFace {
    bool bold = false, italic = false;
    friend bool operator==(const FontFace&, const FontFace&) = default;
};
struct TextRecipe {
    QString text, font;
    double size = 0;
    Point at;              ///< the start of the baseline
    double turn = 0;       ///< the direction of the baseline
    bool mirrored = false; ///< the letters stand on the other side of the baseline, head down
    FontFace face{};       ///< only of an installed font
    friend bool operator==(const TextRecipe&, const TextRecipe&) = default;
};
constexpr double roundingOfRecipes = 1e-9; ///< in reading and mapping them, relative to the size

using Recipe = std::variant<std::monostate, RectangleRecipe, EllipseRecipe, StarRecipe, TextRecipe>;

/// The recipe of the transformed path; empty if no recipe of its kind makes that path.
Recipe placed(const Recipe& recipe, const Placement& where);
/// The same for any map.
Recipe mapped(const Recipe& recipe, const AffineMap& map);

Path mapped(const Path& path, const AffineMap& map);

/// The vector of the drawing that a vector of the turned shape's own directions is.
Point turnedBy(const Point& vector, double turn);

/// Transforms a path and its recipe together. A path with a recipe stays the recipe's outline: a
/// rotated or mirrored one would begin at another corner.
void transform(Path& path, Recipe& recipe, const AffineMap& map);

} // namespace app

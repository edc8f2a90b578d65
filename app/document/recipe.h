// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/placement.h"

#include <QString>

#include <variant>

namespace app {

// What made a path, while that is still true, so that it can be edited as such. All lengths are in
// user units, angles in radians from the x axis towards the y axis (clockwise on screen).

struct RectangleRecipe {
    Point corner; ///< the least x and y
    Point size;
    double radius = 0; ///< of the rounded corners
    friend bool operator==(const RectangleRecipe&, const RectangleRecipe&) = default;
};
struct EllipseRecipe {
    Point centre, radii;
    friend bool operator==(const EllipseRecipe&, const EllipseRecipe&) = default;
};
struct StarRecipe {
    Point centre;
    double outer = 0, inner = 0; ///< radii of its points and of the corners between them
    double turn = 0;             ///< the angle of its first point
    int points = 5;
    friend bool operator==(const StarRecipe&, const StarRecipe&) = default;
};
struct TextRecipe {
    QString text, font;
    double size = 0;
    Point at; ///< where its baseline begins
    friend bool operator==(const TextRecipe&, const TextRecipe&) = default;
};
using Recipe = std::variant<std::monostate, RectangleRecipe, EllipseRecipe, StarRecipe, TextRecipe>;

/// The recipe of the placed path; nothing where none of its kind makes that path any more.
Recipe placed(const Recipe& recipe, const Placement& where);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/recipe_text.h"

#include "app/base/number.h"
#include "app/formats/svg/scanner.h"

#include <array>

namespace app::svg {
namespace {

constexpr std::string_view rectangle = "rectangle", ellipse = "ellipse";

std::string text(std::string_view kind, const Point& a, const Point& b)
{
    std::string all(kind);
    for (const double number : {a.x, a.y, b.x, b.y})
        appendNumber(all += ' ', number);
    return all;
}

} // namespace

std::string textOf(const Recipe& recipe)
{
    const auto* r = std::get_if<RectangleRecipe>(&recipe);
    const auto* e = std::get_if<EllipseRecipe>(&recipe);
    if (r && r->radius == 0)
        return text(rectangle, r->corner, r->size);
    return e ? text(ellipse, e->centre, e->radii) : std::string();
}

Recipe readRecipe(std::string_view text)
{
    const bool isRectangle = text.starts_with(rectangle), isEllipse = text.starts_with(ellipse);
    if (!isRectangle && !isEllipse)
        return {};
    Scanner scanner(text.substr((isRectangle ? rectangle : ellipse).size()));
    std::array<double, 4> v{};
    for (double& number : v) {
        scanner.skipBlanks();
        const auto next = scanner.number();
        if (!next)
            return {};
        number = *next;
    }
    if (isRectangle)
        return RectangleRecipe{{v[0], v[1]}, {v[2], v[3]}};
    return EllipseRecipe{{v[0], v[1]}, {v[2], v[3]}};
}

} // namespace app::svg

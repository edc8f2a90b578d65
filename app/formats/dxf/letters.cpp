// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/letters.h"

#include "app/formats/dxf/losses.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace app::dxf {
namespace {

TextRecipe recipeOf(const TextLine& line)
{
    return {.text = line.text, .font = strokeFonts().front().name, .size = line.size, .at = {0, 0}};
}

// The text in its place, if it is neither stretched nor slanted there.
std::optional<TextRecipe> recipeIn(const Space& space, const TextLine& line)
{
    constexpr double rounding = 1e-9;
    const Point along = onPage(space.direction({1, 0, 0})), up = onPage(space.direction({0, 1, 0}));
    const double scale = glm::length(along);
    if (!(scale > 0) || std::abs(glm::length(up) - scale) > rounding * scale
        || std::abs(glm::dot(along, up)) > rounding * scale * scale)
        return std::nullopt;
    TextRecipe recipe = recipeOf(line);
    recipe.size *= scale;
    recipe.at = onPage(space({line.shift, 0}));
    recipe.turn = std::atan2(along.y, along.x);
    recipe.mirrored = cross(along, up) > 0;
    return recipe;
}

std::vector<Subpath> distorted(std::vector<Subpath> paths, const Space& space, const TextLine& line)
{
    for (Subpath& path : paths)
        forEachPoint(path, [&](Point& p) {
            p = onPage(space({line.shift.x + p.x, line.shift.y - p.y, 0}));
        });
    return paths;
}

} // namespace

double widthOf(const TextLine& line)
{
    double width = 0;
    for (const Subpath& path : lettered(recipeOf(line)).paths)
        forEachPoint(path, [&](const Point& p) { width = std::max(width, p.x); });
    return width;
}

QStringList wrapped(const QStringList& paragraphs, double size, double width)
{
    constexpr double blank = 0.8; // as wide as this many heights of capitals
    if (!(width > 0))
        return paragraphs;
    QStringList lines;
    for (const QString& paragraph : paragraphs) {
        double used = 0;
        const QStringList words = paragraph.split(u' ');
        for (qsizetype i = 0; i < words.size(); ++i) {
            const double word = widthOf({words[i], size});
            if (i > 0 && used + size * blank + word <= width) {
                lines.back() += u' ' + words[i];
                used += size * blank + word;
            } else {
                lines << words[i];
                used = word;
            }
        }
    }
    return lines;
}

Space slanted(double degrees)
{
    Space space;
    if (std::abs(degrees) < 85)
        space.axes[1].x = std::tan(glm::radians(degrees));
    return space;
}

bool refusesText(const Entity& entity, qsizetype letters)
{
    entity.drawer.count(std::size_t(letters));
    if (letters > longestText)
        entity.drawer.report().add(losses::longText);
    return letters > longestText;
}

void addLetters(const Entity& entity, const std::vector<TextLine>& lines, const Space& space)
{
    Report& report = entity.drawer.report();
    Shape shape{.paint = Paint::Letters};
    QStringList missing;
    for (const TextLine& line : lines) {
        const auto recipe = lines.size() == 1 ? recipeIn(space, line) : std::nullopt;
        Lettering letters = lettered(recipe ? *recipe : recipeOf(line));
        if (!recipe)
            letters.paths = distorted(std::move(letters.paths), space, line);
        else if (!letters.paths.empty())
            shape.recipe = *recipe;
        missing << letters.missing;
        shape.paths.insert(shape.paths.end(), std::move_iterator(letters.paths.begin()),
                           std::move_iterator(letters.paths.end()));
    }
    if (!missing.isEmpty())
        report.add(losses::missingLetters, missing.join(QString()).toStdString());
    if (shape.paths.empty())
        return; // only blanks
    report.add(losses::text);
    entity.drawer.add(entity, std::move(shape));
}

} // namespace app::dxf

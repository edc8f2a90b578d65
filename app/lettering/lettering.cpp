// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/lettering.h"

#include "app/base/text.h"
#include "app/document/direction.h"
#include "app/document/path.h"
#include "app/document/recipe_outline.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/outline_letters.h"
#include "app/lettering/stroke_letters.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double largest = 1e300;

Letters lettersOf(const TextRecipe& text)
{
    if (const StrokeFont* const font = findStrokeFont(text.font))
        return strokeLetters(text.text, *font);
    return hasFont(text.font) ? outlineLetters(text.text, text.font, text.face) : Letters{};
}

} // namespace

Point downOf(const TextRecipe& text)
{
    const Point along = alongOf(text), down(-along.y, along.x);
    return text.mirrored ? -down : down;
}

Point alongOf(const TextRecipe& text) { return directionOf(-glm::degrees(text.turn)); }

Lettering lettered(const TextRecipe& text)
{
    const auto small = [](double number) { return std::abs(number) < largest; }; // not for NaN
    const bool drawable = text.size > 0 && small(text.size * double(longestText))
                          && small(text.at.x) && small(text.at.y) && small(text.turn);
    if (!drawable || text.text.size() > longestText)
        return {};
    Letters letters = lettersOf(text);
    const Point along = alongOf(text), down = downOf(text);
    const double unit = text.size / letters.capital;
    for (Subpath& path : letters.paths)
        forEachPoint(path, [&](Point& p) {
            const Point step = p * unit;
            p = text.at + (along * step.x + down * step.y);
        });
    return {std::move(letters.paths), std::move(letters.missing)};
}

QString missingText(const Lettering& lettering)
{
    if (lettering.missing.isEmpty())
        return {};
    constexpr qsizetype named = 10;
    QStringList first = lettering.missing.first(std::min(named, lettering.missing.size()));
    if (lettering.missing.size() > named)
        first << QStringLiteral("…");
    return Text::tr("The font has no %1: a box stands in its place.", nullptr)
        .arg(first.join(QStringLiteral(", ")));
}

QString missingFontText(const QString& font)
{
    return Text::tr("The font %1 is not installed: a changed text is written in %2.")
        .arg(font, fontInsteadOf(font));
}

bool makes(const TextRecipe& text, std::span<const Subpath> subpaths)
{
    const Lettering letters = lettered(text);
    return !letters.paths.empty() && alike(letters.paths, subpaths);
}

} // namespace app

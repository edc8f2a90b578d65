// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/texts_as_strokes.h"

#include "app/document/document.h"
#include "app/document/path.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

namespace app {
namespace {

constexpr double penOfCapital = 0.1; // the width of a stroke, in heights of capital letters

/// From where to where something reaches along a line through the origin.
struct Reach {
    double from = std::numeric_limits<double>::infinity(), to = -from;
    void include(const Point& p, const Point& along)
    {
        const double at = p.x * along.x + p.y * along.y;
        from = std::min(from, at);
        to = std::max(to, at);
    }
    double length() const { return to - from; }
    double middle() const { return (from + to) / 2; }
};

Reach reachOf(std::span<const Subpath> paths, const Point& along)
{
    Reach reach;
    for (const Subpath& path : paths)
        forEachPoint(path, [&](const Point& p) { reach.include(p, along); });
    return reach;
}

std::optional<Object> withStrokes(const Object& object)
{
    const auto* before = std::get_if<TextRecipe>(&object.particulars.recipe);
    if (!before || findStrokeFont(before->font))
        return std::nullopt;
    TextRecipe text = *before;
    text.font = strokeFonts().front().name;
    text.face = {};
    const Point along = alongOf(text);
    const Reach place = reachOf(object.path.subpaths(), along);
    const Reach first = reachOf(lettered(text).paths, along);
    if (!(first.length() >= 0)) // no letters
        return std::nullopt;
    if (first.length() > place.length() && place.length() > 0)
        text.size *= place.length() / first.length();
    text.at += along * (place.middle() - reachOf(lettered(text).paths, along).middle());
    Object made = object;
    made.path = Path(lettered(text).paths);
    Style style;
    style.stroke = object.style.fill ? object.style.fill : object.style.stroke;
    style.width = text.size * penOfCapital;
    style.cap = Cap::Round;
    style.join = Join::Round;
    made.style = style;
    made.particulars.recipe = std::move(text);
    return made;
}

} // namespace

Edit textsAsStrokes(const Document& document)
{
    Edit edit;
    edit.objects = document.objects().slice(0, 0);
    for (std::size_t i = 0; i < document.objects().size(); ++i) {
        const ObjectView object = document.objects()[i];
        if (!std::holds_alternative<TextRecipe>(Recipe(object.particulars().recipe)))
            continue;
        if (const auto made = withStrokes(object.copy())) {
            edit.splices.push_back({std::uint32_t(i), 1, 1});
            edit.objects.append(*made);
        }
    }
    return edit;
}

} // namespace app

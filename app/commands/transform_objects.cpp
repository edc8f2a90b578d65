// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/transform_objects.h"

#include "app/commands/set_style.h"
#include "app/document/path_points.h"
#include "app/document/recipe_outline.h"

namespace app {
namespace {

Path mapped(const Path& path, const AffineMap& map)
{
    if (const auto line = path.singleLine())
        return Path(clipping::Segment{map(line->a), map(line->b)});
    std::vector<Subpath> subpaths = path.subpaths();
    for (Subpath& subpath : subpaths)
        forEachPoint(subpath, [&](Point& p) { p = map(p); });
    return Path(subpaths);
}

void scaleStroke(Style& style, double scale)
{
    style.width *= scale;
    style.dashOffset *= scale;
    for (double& dash : style.dashes)
        dash *= scale;
}

Edit transformed(const Document& document, const ObjectRanges& objects, const AffineMap& map,
                 StrokeScaling strokes)
{
    const double scale = strokes == StrokeScaling::Scale ? map.scale() : 1;
    StyleChanges restyled([&](Style& style) { scaleStroke(style, scale); });
    return changed(document, objects, [&](ObjectRow& object, StyleTable& styles) {
        transform(object, map);
        if (scale != 1)
            restyled(object, styles);
    });
}

} // namespace

void transform(ObjectRow& object, const AffineMap& map)
{
    const Recipe& old = object.particulars->recipe;
    if (old.index() == 0) {
        object.path = mapped(object.path, map);
        return;
    }
    Recipe recipe = mapped(old, map);
    // A rotated outline would begin at another corner.
    const auto outline = map.placement() ? std::nullopt : outlineOf(recipe);
    object.path = outline ? Path(std::span(&*outline, 1)) : mapped(object.path, map);
    object.particulars.own().recipe = std::move(recipe);
}

TransformObjects::TransformObjects(EditedDocument& document, const ObjectRanges& objects,
                                   const AffineMap& map, StrokeScaling strokes, const QString& text,
                                   Merging merging)
    : EditCommand(row, document, transformed(document.now(), objects, map, strokes), text, merging)
{
}

} // namespace app

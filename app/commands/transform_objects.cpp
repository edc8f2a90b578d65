// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/transform_objects.h"

#include "app/commands/set_style.h"
#include "app/document/copies.h"
#include "app/document/recipe.h"

#include <map>

namespace app {
namespace {

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

Edit transformed(const Document& document, const ObjectRanges& objects,
                 std::span<const AffineMap> maps, StrokeScaling strokes)
{
    std::map<double, StyleChanges> restyled; // by the factor of the widths
    return changed(document, objects,
                   [&, map = maps.begin()](ObjectRow& object, StyleTable& styles) mutable {
                       const double scale = map->scale();
                       transform(object, *map++);
                       if (strokes == StrokeScaling::Keep || scale == 1)
                           return;
                       const auto scaled = [scale](Style& style) { scaleStroke(style, scale); };
                       restyled.try_emplace(scale, scaled).first->second(object, styles);
                   });
}

Derivation derivedBy(const AffineMap& map, StrokeScaling strokes)
{
    return strokes == StrokeScaling::Keep ? Derivation{Derivation::How::Mapped, {}, map}
                                          : Derivation{};
}

} // namespace

/// Shares the particulars of objects without a recipe.
void transform(ObjectRow& object, const AffineMap& map)
{
    Recipe none;
    const bool hasRecipe = object.particulars->recipe.index() != 0;
    transform(object.path, hasRecipe ? object.particulars.own().recipe : none, map);
}

TransformObjects::TransformObjects(EditedDocument& document, const ObjectRanges& objects,
                                   std::span<const AffineMap> maps, StrokeScaling strokes,
                                   const QString& text)
    : EditCommand(row, document, transformed(document.now(), objects, maps, strokes), text)
{
}

CopyObjects::CopyObjects(EditedDocument& document, Edit copying, const QString& text)
    : EditCommand(row, document, std::move(copying), text)
{
}

Edit copying(const Document& document, const ObjectRanges& objects, std::span<const AffineMap> maps,
             ContainerId entered)
{
    std::vector<RowChange> changes;
    for (const AffineMap& map : maps)
        changes.emplace_back([&map](ObjectRow& object) { transform(object, map); });
    if (auto grouped = withCopies(document, objects, entered, changes))
        return std::move(grouped->edit);
    std::vector<PendingObject> copies;
    copies.reserve(objects.size() * maps.size());
    for (const AffineMap& map : maps)
        for (const std::size_t i : objects) {
            Object copy = document.objects()[i].copy();
            copy.particulars.id.clear(); // ids are unique
            transform(copy.path, copy.particulars.recipe, map);
            copies.push_back({std::move(copy), document.containers().containerOf(i)});
        }
    return adding(document, copies);
}

TransformObjects::TransformObjects(EditedDocument& document, const ObjectRanges& objects,
                                   const AffineMap& map, StrokeScaling strokes, const QString& text,
                                   Merging merging)
    : EditCommand(row, document, transformed(document.now(), objects, map, strokes), text, merging,
                  derivedBy(map, strokes))
{
}

} // namespace app

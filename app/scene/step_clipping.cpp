// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/step_clipping.h"

#include "app/scene/window_needs.h"
#include "clipping/region/catalogue.h"

namespace app {

namespace {

using clipping::Clipped;
using clipping::Form;
using clipping::Segment;

constexpr std::size_t manyCorners = 16; // from here on, searching is faster

// The forms that a variant has, of which those at polygons are corrected ones.
RowForms formsOf(const Variant& variant)
{
    RowForms forms{.exact = variant == Variant{&clipping::exactAlgorithm()},
                   .atWindow = clipping::functionsOf(*variant.algorithm, variant.form)->clipAll};
    if (variant.form == Form::Published)
        return forms;
    forms.atPolygon = variant.algorithm->polygon;
    forms.atLongPolygon = variant.algorithm->polygonBySearch;
    if (const auto* region = clipping::findRegionAlgorithm(variant.algorithm->key))
        forms.atRegion = region->clipAll;
    return forms;
}

// Whether the row has a form for this window alone, faster than its form for regions.
bool hasOwnForm(const RowForms& forms, const ClipRegion::Step& step)
{
    return step.rings.empty() || (forms.atPolygon && !step.polygon.corners.empty());
}

void markBorders(std::span<Clipped> pieces)
{
    const auto marked = [](bool cut) { return cut ? borderEdge : clipping::Edge::NoEdge; };
    for (Clipped& piece : pieces)
        piece.cut = clipping::cutAt(marked(clipping::polygonEdgeOfA(piece.cut) != 0),
                                    marked(clipping::polygonEdgeOfB(piece.cut) != 0));
}

void markTurnedBorders(std::span<Clipped> pieces)
{
    const auto marked = [](clipping::Edge edge) {
        return edge == clipping::Edge::NoEdge ? edge : borderEdge;
    };
    for (Clipped& piece : pieces)
        piece.cut = clipping::cutAt(marked(clipping::cutEdgeOfA(piece.cut)),
                                    marked(clipping::cutEdgeOfB(piece.cut)));
}

} // namespace

std::optional<Variant> variantOf(ClipAll clipAll)
{
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        for (const Form form : {Form::Corrected, Form::Published})
            if (const auto* uses = clipping::functionsOf(algorithm, form);
                uses && uses->clipAll == clipAll)
                return Variant{&algorithm, form};
    return std::nullopt;
}

RowForms formsAt(const ClipRegion& region, ClipAll clipAll)
{
    const std::optional<Variant> variant = variantOf(clipAll);
    RowForms forms{.atWindow = clipAll};
    if (variant)
        forms = formsOf(usedAt(region, *variant));
    else if (needsOf(region) > WindowNeeds::RotatedRectangle)
        forms = formsOf({&clipping::exactAlgorithm()});
    if (region.steps.size() == 1 && hasOwnForm(forms, region.steps.front()))
        forms.atRegion = nullptr;
    return forms;
}

std::size_t clipAtStep(const RowForms& forms, const ClipRegion::Step& step,
                       std::span<const Segment> lines, std::span<Clipped> out)
{
    if (step.rings.empty())
        return forms.atWindow(lines, step.box, out);
    std::size_t count = 0;
    if (forms.atPolygon && !step.polygon.corners.empty()) {
        const bool searched = forms.atLongPolygon && step.polygon.corners.size() >= manyCorners;
        const auto* form = searched ? forms.atLongPolygon : forms.atPolygon;
        count = form->clipAll(lines, step.polygon, out);
        markBorders(out.first(count));
    } else {
        count = clipping::clipAllTurned(forms.atWindow, lines, *step.turned, out);
        markTurnedBorders(out.first(count));
    }
    return count;
}

} // namespace app

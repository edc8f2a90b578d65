// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/resize_objects.h"

#include "app/base/text.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_style.h"
#include "app/document/path.h"

#include <cmath>

namespace app {

Placement fitting(const clipping::Window& from, const clipping::Window& to)
{
    const Point old = from.max - from.min, size = to.max - to.min;
    const Point scale(old.x > 0 ? size.x / old.x : 1, old.y > 0 ? size.y / old.y : 1);
    return {scale, to.min - from.min * scale};
}

namespace {

// Maps each point separately, so that `from.min` maps to `to.min` without rounding, whatever the
// numbers.
Path fitted(const Path& path, const clipping::Window& from, const clipping::Window& to)
{
    const Point scale = fitting(from, to).scale;
    std::vector<Subpath> subpaths = path.subpaths();
    for (Subpath& subpath : subpaths)
        forEachPoint(subpath, [&](Point& p) { p = to.min + (p - from.min) * scale; });
    return Path(subpaths);
}

// Otherwise rounding moves the corner.
bool keepsCorner(const clipping::Window& from, const clipping::Window& to)
{
    return fitting(from, to)(from.min) == to.min;
}

Derivation derivationOf(const clipping::Window& from, const clipping::Window& to,
                        StrokeScaling strokes)
{
    return strokes == StrokeScaling::Keep && keepsCorner(from, to)
               ? Derivation{Derivation::How::Placed, fitting(from, to)}
               : Derivation{};
}

Edit resized(const Document& document, const ObjectRanges& objects, const clipping::Window& from,
             const clipping::Window& to, StrokeScaling strokes)
{
    const Placement where = fitting(from, to);
    const bool placed = keepsCorner(from, to);
    const double area = std::abs(where.scale.x * where.scale.y);
    const double scale = strokes == StrokeScaling::Scale ? std::sqrt(area) : 1;
    StyleChanges restyled([&](Style& style) { scaleStroke(style, scale); });
    return changed(document, objects, [&](ObjectRow& object, StyleTable& styles) {
        Path path = placed ? Path() : fitted(object.path, from, to);
        place(object, where);
        if (!placed)
            object.path = std::move(path);
        if (scale != 1)
            restyled(object, styles);
    });
}

} // namespace

ResizeObjects::ResizeObjects(EditedDocument& document, const ObjectRanges& objects,
                             const clipping::Window& from, const clipping::Window& to,
                             StrokeScaling strokes)
    : EditCommand(row, document, resized(document.now(), objects, from, to, strokes),
                  Text::tr("Resize selection"), Merging::Never, derivationOf(from, to, strokes))
{
}

} // namespace app

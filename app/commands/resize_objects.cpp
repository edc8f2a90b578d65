// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/resize_objects.h"

#include "app/base/text.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_style.h"
#include "app/document/copies.h"
#include "app/document/path.h"

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

Derivation derivationOf(const WindowFrame& from, const WindowFrame& to, StrokeScaling strokes)
{
    if (strokes != StrokeScaling::Keep)
        return {};
    if (from.angle != 0)
        return {Derivation::How::Mapped, {}, fitting(from, to)};
    return keepsCorner(from.box, to.box)
               ? Derivation{Derivation::How::Placed, fitting(from.box, to.box)}
               : Derivation{};
}

RowChange resizing(const WindowFrame& from, const WindowFrame& to)
{
    if (from.angle != 0)
        return [map = fitting(from, to)](ObjectRow& object) { transform(object, map); };
    return
        [from = from.box, to = to.box, placed = keepsCorner(from.box, to.box)](ObjectRow& object) {
            Path path = placed ? Path() : fitted(object.path, from, to);
            place(object, fitting(from, to));
            if (!placed)
                object.path = std::move(path);
        };
}

Edit resized(const Document& document, const ObjectRanges& objects, const WindowFrame& from,
             const WindowFrame& to, StrokeScaling strokes)
{
    const double scale = strokes == StrokeScaling::Scale ? fitting(from, to).scale() : 1;
    StyleChanges restyled([&](Style& style) { scaleStroke(style, scale); });
    return changed(document, objects,
                   [&, resize = resizing(from, to)](ObjectRow& object, StyleTable& styles) {
                       resize(object);
                       if (scale != 1)
                           restyled(object, styles);
                   });
}

} // namespace

ResizeObjects::ResizeObjects(EditedDocument& document, const ObjectRanges& objects,
                             const WindowFrame& from, const WindowFrame& to, StrokeScaling strokes)
    : EditCommand(row, document, resized(document.now(), objects, from, to, strokes),
                  Text::tr("Resize selection"), Merging::Never, derivationOf(from, to, strokes))
{
}

} // namespace app

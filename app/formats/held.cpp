// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/held.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/flattened.h"
#include "app/document/hidden_objects.h"
#include "app/formats/dxf/write_look.h"
#include "app/formats/dxf/write_shape.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

/// One kind of loss: how much of it there is, and how it is said.
struct LossOfKind {
    std::size_t count;
    QString one, many; ///< `many` has a place for the number
};

/// How many objects have something that only some formats hold.
struct KindsOfObjects {
    std::size_t curved = 0, free = 0; ///< with curves; with others than arcs of circles
    std::size_t filled = 0, texts = 0, transparent = 0, dashed = 0;
    std::size_t wide = 0; ///< wider than the widest stroke of DXF
};

bool isTransparent(const Style& style)
{
    const auto is = [](const std::optional<Colour>& c) { return c && c->alpha < 255; };
    return is(style.stroke) || is(style.fill);
}

KindsOfObjects kindsIn(const Document& document, const ObjectRanges& among)
{
    KindsOfObjects kinds;
    const double widest = 1.05 * dxf::writing::widestLine / document.page().millimetresPerUnit();
    const auto count = [&](std::size_t, const ObjectView& object) {
        kinds.texts += std::holds_alternative<TextRecipe>(object.particulars().recipe);
        kinds.transparent += isTransparent(object.style());
        kinds.wide += object.style().stroke && object.style().width > widest;
        kinds.dashed += object.style().stroke && !object.style().dashes.empty();
        if (object.singleLine())
            return;
        kinds.filled += object.style().fill.has_value();
        if (object.path().straight())
            return;
        ++kinds.curved;
        kinds.free += !std::ranges::all_of(object.path().subpaths(), dxf::writing::hasOnlyArcs);
    };
    for (const ObjectRange& range : among.ranges())
        document.objects().forEach(range.first, range.size(), count);
    return kinds;
}

Document withoutFillsBehindStrokes(Document document)
{
    const Objects& all = document.objects();
    Edit edit;
    edit.objects = all.slice(0, 0);
    StyleTable& styles = edit.objects.styles();
    all.forEach(0, all.size(), [&](std::size_t i, const ObjectView& object) {
        Style style = object.style();
        if (!style.stroke || !style.fill || object.singleLine())
            return;
        style.fill.reset();
        ObjectRow row = object.row();
        row.style = styles.entryOf(style);
        edit.splices.push_back({std::uint32_t(i), 1, 1});
        edit.objects.append(row);
    });
    document.apply(edit);
    return document;
}

} // namespace

Document asHeld(Document document, const Format& format, double tolerance)
{
    if (format.holds == Holds::SeparateLines || format.holds == Holds::Polygons)
        return flattened(std::move(document), tolerance);
    if (format.holds == Holds::Outlines)
        return withoutFillsBehindStrokes(std::move(document));
    return document;
}

QStringList lossesOf(const Document& document, const ObjectRanges& objects, const Format& format,
                     const WriteOptions& options)
{
    const bool lines = format.holds == Holds::SeparateLines || format.holds == Holds::Polygons;
    const bool fills = format.holds == Holds::Paths || format.holds == Holds::Polygons;
    const bool isOld = format.takes.dxf && options.dxf == DxfVersion::R12;
    const bool keepsTexts = format.takes.dpi || (format.read && format.holds == Holds::Paths);
    const KindsOfObjects kinds = kindsIn(document, objects);
    const std::array rows{
        LossOfKind{isOld ? common(hiddenObjects(document), objects).size() : 0,
                   Text::tr("1 hidden object is left out"),
                   Text::tr("%1 hidden objects are left out")},
        LossOfKind{lines   ? kinds.curved
                   : isOld ? kinds.free
                           : 0,
                   Text::tr("1 curved path becomes lines"),
                   Text::tr("%1 curved paths become lines")},
        LossOfKind{format.holds == Holds::SeparateLines ? kinds.dashed : 0,
                   Text::tr("1 dashed path becomes a line for each dash"),
                   Text::tr("%1 dashed paths become a line for each dash")},
        LossOfKind{format.holds == Holds::Polygons ? kinds.dashed : 0,
                   Text::tr("1 dashed path becomes solid"),
                   Text::tr("%1 dashed paths become solid")},
        LossOfKind{fills ? 0 : kinds.filled, Text::tr("1 area loses its fill"),
                   Text::tr("%1 areas lose their fill")},
        LossOfKind{format.takes.dxf ? kinds.transparent : 0,
                   Text::tr("1 transparent colour becomes opaque"),
                   Text::tr("%1 transparent colours become opaque")},
        LossOfKind{format.takes.dxf && !isOld ? kinds.wide : 0,
                   Text::tr("1 stroke becomes 2.11 mm wide, the most in DXF"),
                   Text::tr("%1 strokes become 2.11 mm wide, the most in DXF")},
        LossOfKind{format.holds == Holds::Paths ? 0 : seenUnderlays(document).size(),
                   Text::tr("1 image is left out"), Text::tr("%1 images are left out")},
        LossOfKind{keepsTexts ? 0 : kinds.texts, Text::tr("1 text becomes outlines"),
                   Text::tr("%1 texts become outlines")},
    };
    QStringList sentences;
    for (const LossOfKind& row : rows)
        if (row.count > 0)
            sentences << (row.count == 1 ? row.one : row.many.arg(countText(row.count)));
    return sentences;
}

} // namespace app

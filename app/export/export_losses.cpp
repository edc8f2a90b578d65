// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_losses.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/formats/rounded.h"

#include <array>

namespace app {
namespace {

/// One kind of loss: how much of it there is, and how it is said.
struct LossRow {
    std::size_t count;
    QString one, many; ///< `many` has a place for the number
};

struct Kinds {
    std::size_t curved = 0, filled = 0, texts = 0;
};

Kinds kindsIn(const Document& document, const ObjectRanges& among)
{
    Kinds kinds;
    for (const ObjectRange& range : among.ranges())
        document.objects().forEach(
            range.first, range.size(), [&](std::size_t, const ObjectView& object) {
                kinds.texts += std::holds_alternative<TextRecipe>(object.particulars().recipe);
                if (object.singleLine())
                    return;
                kinds.curved += !object.path().straight();
                kinds.filled += object.style().fill.has_value();
            });
    return kinds;
}

/// The objects of the original that the export is made of.
ObjectRanges chosenObjects(const ExportJob& job)
{
    const auto objects = objectsOf(job.source, job.choice.area);
    return objects ? *objects
                   : without(ObjectRanges(ObjectRange{0, job.source.document.objects().size()}),
                             hiddenObjects(job.source.document));
}

std::size_t hiddenIn(const ExportJob& job)
{
    if (objectsOf(job.source, job.choice.area))
        return 0; // they were not chosen
    return hiddenObjects(job.source.document).size();
}

} // namespace

QStringList exportLosses(const ExportJob& job, const ExportDrawing& made)
{
    const Format& format = formatOf(job.choice);
    const bool lines = format.holds == Holds::SeparateLines;
    const bool keepsTexts = format.takes.dpi || (format.read && !lines);
    const Kinds kinds = kindsIn(job.source.document, chosenObjects(job));
    const std::array rows{
        LossRow{format.hides == StoresHidden::No ? hiddenIn(job) : 0,
                Text::tr("1 hidden object is left out"),
                Text::tr("%1 hidden objects are left out")},
        LossRow{lines ? kinds.curved : 0, Text::tr("1 curved path becomes lines"),
                Text::tr("%1 curved paths become lines")},
        LossRow{lines ? kinds.filled : 0, Text::tr("1 area loses its fill"),
                Text::tr("%1 areas lose their fill")},
        LossRow{keepsTexts ? 0 : kinds.texts, Text::tr("1 text becomes outlines"),
                Text::tr("%1 texts become outlines")},
        LossRow{rounded(made.document, made.options).points,
                Text::tr("1 line becomes a point at this precision and is left out"),
                Text::tr("%1 lines become points at this precision and are left out")},
    };
    QStringList sentences;
    for (const LossRow& row : rows)
        if (row.count > 0)
            sentences << (row.count == 1 ? row.one : row.many.arg(countText(row.count)));
    return sentences;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_drawing.h"

#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/export/drawn_box.h"
#include "app/export/export_losses.h"
#include "app/export/part_of_drawing.h"
#include "app/formats/held.h"
#include "app/formats/painted.h"

namespace app {
namespace {

/// The layer that is exported; 0: none.
ContainerId layerOf(const ExportArea& area)
{
    return area.part == ExportPart::Layer ? area.layer : 0;
}

/// What is exported, before it is held by the format and cut.
Document chosenContent(const ExportJob& job)
{
    Document content = withOwnStyles(job.source.document); // a cut adds many styles
    const Format& format = formatOf(job.choice);
    if (const auto objects = objectsOf(job.source, job.choice.area))
        content = onlyObjects(onlyImagesIn(std::move(content), layerOf(job.choice.area)), *objects);
    else if (format.hides == StoresHidden::No)
        content = withoutHidden(std::move(content));
    return content;
}

Document heldContent(Document content, const Format& format)
{
    if (format.holds != Holds::Paths)
        content = onlyImagesIn(std::move(content), 0);
    const double tolerance = usualTolerance(content.page());
    return asHeld(std::move(content), format, tolerance);
}

CutOptions cutOptionsOf(const ExportJob& job)
{
    const ExportSource& source = job.source;
    const Page& page = source.document.page();
    CutOptions options = exportOptions(source.cutting, page);
    options.clipAll = source.clipAll;
    options.keepContacts = formatOf(job.choice).holds == Holds::SeparateLines;
    cutAt(options, windowsOf(source, job.choice.area), page);
    return options;
}

/// Without what is not drawn.
Page bare(Page page)
{
    page.guides = {};
    page.sheets.reset();
    return page;
}

bool onWholePage(const ExportChoice& choice)
{
    return choice.paper == ExportPaper::Page && formatOf(choice).takes.paper;
}

/// The rectangle of the paper; empty: nothing is seen.
std::optional<clipping::Window> paperOf(const ExportJob& job, const Document& content)
{
    if (onWholePage(job.choice))
        return content.page().rectangle();
    const auto rectangle = rectangleOf(job.source, job.choice.area);
    return rectangle ? rectangle : drawnBox(content);
}

WriteOptions writeOptionsOf(const ExportChoice& choice, const ClipRegion& region, const Page& page)
{
    const Format& format = formatOf(choice);
    WriteOptions options;
    if (format.takes.dpi)
        options.dpi = choice.dpi;
    if (format.takes.background)
        options.background = choice.background;
    if (format.takes.precision)
        options.precision = choice.precision;
    if (format.takes.dxf)
        options.dxf = choice.dxf;
    if (format.takes.projection)
        options.projection = choice.projection;
    options.plain = format.takes.plain && choice.plain;
    options.wholePage = page.rectangle();
    if (region.keep == Keep::Inside)
        options.bounds = region.single();
    return options;
}

} // namespace

Result<ExportDrawing> exportDrawing(const ExportJob& job, const Follower& follower)
{
    using Made = Result<ExportDrawing>;
    if (const QString fault = faultOf(job.source, job.choice.area); !fault.isEmpty())
        return Made::failure(Text::tr("Nothing can be exported: %1.").arg(fault));
    if (const auto fault = faultOf(job.source.document.page()))
        return Made::failure(*fault);
    const CutOptions options = cutOptionsOf(job);
    const Document chosen = chosenContent(job);
    ObjectRanges left(ObjectRange{0, chosen.objects().size()});
    ExportDrawing made{.document = heldContent(chosen, formatOf(job.choice)),
                       .options =
                           writeOptionsOf(job.choice, options.region, job.source.document.page())};
    if (!options.region.everything()) {
        const Cut result = cut(made.document, options, follower);
        made.cut = true;
        made.counts = result.counts;
        if (follower.stop.stop_requested())
            return Made::failure({});
        left = leftBy(result, chosen.objects().size());
        made.document.apply(result.edit);
    }
    const auto paper = paperOf(job, made.document);
    if (!paper)
        return Made::failure(Text::tr("Nothing is seen of what was chosen."));
    Page page = bare(made.document.page());
    if (!onWholePage(job.choice))
        page = paperAround(std::move(page), *paper);
    made.document.apply({.windows = ClipWindows(), .page = std::move(page)}); // it is cut already
    made.losses = exportLosses(job, chosen, left, made);
    return Made::of(std::move(made));
}

} // namespace app

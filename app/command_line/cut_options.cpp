// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/cut_options.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/cut/occlude.h"
#include "app/cut/stroke_area.h"

#include <cmath>

namespace app {
namespace {

QString key(const char* option) { return QString::fromLatin1(option); }

} // namespace

std::vector<Option> cuttingOptions()
{
    return {
        {{"close"},
         {},
         Text::tr("Let the stroke of a filled shape follow the cut. Otherwise the shape becomes "
                  "a group of its area and its lines, without a stroke along the cut.")},
        {{"min-length"}, "LENGTH", Text::tr("Leave out pieces of cut lines that are shorter (0).")},
        {{"leave-hidden"}, {}, Text::tr("Leave hidden shapes and layers whole.")},
        {{"occlude"},
         {},
         Text::tr("First remove the lines below filled shapes, then all fills, as plotters need "
                  "it. White fills cover lines, too; transparent ones do not.")},
        {{"coincident"},
         "LENGTH",
         Text::tr("How far apart curves may be that count as the same (0.001mm). A curve so near "
                  "to a window's curve is kept or removed as a whole.")},
        {{"strokes-as-areas"},
         {},
         Text::tr("First turn strokes into filled areas, with their caps, joins and dashes. Wide "
                  "ones then end along the window's edge, not at right angles to their lines.")},
    };
}

void takeCuttingOptions(const ParsedArguments& arguments, const Page& page, CutOptions& options)
{
    options.closeAreas = arguments.has(key("close"));
    options.leaveHidden = arguments.has(key("leave-hidden"));
    if (options.leaveHidden && arguments.has(key("drop-hidden")))
        throw WrongUsage{Text::tr("Give either --leave-hidden or --drop-hidden, not both.")};
    if (const auto length = arguments.length(key("min-length")))
        options.leastLength = toUserUnits(*length, page.millimetresPerUnit());
    if (const auto length = arguments.length(key("coincident"))) {
        options.coincident = toUserUnits(*length, page.millimetresPerUnit());
        if (!(options.coincident > 0 && std::isfinite(options.coincident)))
            throw WrongUsage{Text::tr("--coincident must be greater than 0.")};
    }
    if (!(options.leastLength >= 0 && std::isfinite(options.leastLength)))
        throw WrongUsage{Text::tr("--min-length %1: give a length of 0 or more.")
                             .arg(*arguments.text(key("min-length")))};
}

std::optional<CutCounts> occludeIfWanted(const ParsedArguments& arguments,
                                         const CutOptions& options, Document& document)
{
    if (!arguments.has(key("occlude")))
        return std::nullopt;
    ProgressLine line;
    const Cut made = occlude(document, options, line.follower());
    document.apply(made.edit);
    return made.counts;
}

void makeAreasIfWanted(const ParsedArguments& arguments, Document& document)
{
    if (!arguments.has(key("strokes-as-areas")))
        return;
    if (arguments.has(key("occlude")))
        throw WrongUsage{Text::tr("Give either --strokes-as-areas or --occlude, which leaves no "
                                  "areas, not both.")};
    ProgressLine line;
    const ObjectRanges all(ObjectRange{0, document.objects().size()});
    document.apply(strokesAsAreas(document, all, line.follower()).edit);
}

QString occlusionText(const CutCounts& counts)
{
    return Text::tr("Shapes with covered lines: %1 cut, %2 removed; fills removed: %3.")
        .arg(counts.cut)
        .arg(counts.gone)
        .arg(counts.fillsRemoved);
}

QString shapesText(const CutCounts& counts, bool keepsContacts)
{
    const QString text = Text::tr("Shapes: %1 kept whole, %2 cut, %3 removed")
                             .arg(counts.whole)
                             .arg(counts.cut)
                             .arg(counts.gone);
    if (counts.touching == 0)
        return text;
    return text
           + (keepsContacts ? Text::tr("; only touching the window, and kept as points: %1")
                            : Text::tr("; only touching the window, and left out: %1"))
                 .arg(counts.touching);
}

QString nothingLeftText(Keep keep, const QString& place, const CutCounts& counts)
{
    if (counts.touching > 0)
        return Text::tr("Nothing is left: no line of the drawing is in the window, but some "
                        "touch it. The drawing is in %1.")
            .arg(place);
    return (keep == Keep::Inside
                ? Text::tr("Nothing is left: all of the drawing is outside the window. The "
                           "drawing is in %1.")
                : Text::tr("Nothing is left: all of the drawing is inside the window. The "
                           "drawing is in %1."))
        .arg(place);
}

QString furtherCountsText(const CutCounts& counts)
{
    QStringList sentences;
    if (counts.dropped > 0)
        sentences << Text::tr("Pieces shorter than --min-length left out: %1.").arg(counts.dropped);
    if (counts.imagesCut + counts.imagesGone > 0)
        sentences
            << Text::tr("Images: %1 cut, %2 removed.").arg(counts.imagesCut).arg(counts.imagesGone);
    if (counts.imagesUncut > 0)
        sentences << Text::tr("Images not cut along the windows, only at the rectangle around "
                              "them: %1.")
                         .arg(counts.imagesUncut);
    if (counts.imagesWhole > 0)
        sentences << Text::tr("Images kept whole, because only their outside can be cut off: %1.")
                         .arg(counts.imagesWhole);
    if (counts.cutLocked > 0)
        sentences
            << Text::tr("Locked layers are cut like the others; shapes cut or removed on them: %1.")
                   .arg(counts.cutLocked);
    if (counts.slanted > 0)
        sentences << Text::tr("Shapes with strokes wider than 1 mm that do not end along a slanted "
                              "edge: %1. With --strokes-as-areas they do.")
                         .arg(counts.slanted);
    return sentences.join(u'\n');
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/base/variant.h"
#include "app/command_line/command.h"
#include "app/command_line/cut_options.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/part_options.h"
#include "app/command_line/table_clip.h"
#include "app/command_line/table_input.h"
#include "app/command_line/terminal.h"
#include "app/command_line/tile_options.h"
#include "app/command_line/window_options.h"
#include "app/cut/cut.h"
#include "app/document/contents.h"
#include "app/document/hidden_objects.h"
#include "app/formats/held.h"
#include "app/formats/rounded.h"

#include <algorithm>
#include <chrono>

namespace app {
namespace {

const clipping::Functions<clipping::Segment, clipping::Window>&
usesOf(const ParsedArguments& arguments)
{
    const auto named = arguments.algorithms(QStringLiteral("algorithm"));
    if (named.size() > 1)
        throw WrongUsage{Text::tr("A drawing is cut with one algorithm. Name it with -a.")};
    const auto& algorithm = named.empty() ? usualAlgorithm() : *named.front();
    const bool published =
        arguments.choice(QStringLiteral("form"), {"corrected", "published"}) == 1;
    const auto* uses = clipping::functionsOf(algorithm, published ? clipping::Form::Published
                                                                  : clipping::Form::Corrected);
    if (!uses)
        throw WrongUsage{Text::tr("“%1” has no published form. Name another algorithm with -a.")
                             .arg(QLatin1StringView(algorithm.name))};
    return *uses;
}

/// The windows with the side that is kept.
ClipWindows keptWindows(const ParsedArguments& arguments, const Imported& imported)
{
    ClipWindows windows = windowsOf(arguments, imported);
    if (arguments.has(QStringLiteral("keep")))
        windows.keep = arguments.choice(QStringLiteral("keep"), {"inside", "outside"}) == 0
                           ? Keep::Inside
                           : Keep::Outside;
    return windows;
}

CutOptions cutOptionsOf(const ParsedArguments& arguments, const Imported& imported,
                        const Output& output)
{
    CutOptions options{.clipAll = usesOf(arguments).clipAll};
    cutAt(options, keptWindows(arguments, imported), imported.document.page());
    options.tolerance = toleranceOf(arguments, imported.document.page());
    takeCuttingOptions(arguments, imported.document.page(), options);
    options.keepContacts = output.format->holds == Holds::SeparateLines;
    return options;
}

// A cut that leaves nothing, or nothing visible, is rarely intended: reports the reason.
void sayNothingIsLeft(const Imported& imported, const Document& before, const Document& after,
                      Keep keep, const CutCounts& counts)
{
    const bool allGone = after.objects().empty();
    const auto bounds = contentsOf(allGone ? before : withoutHidden(before)).bounds;
    if (!bounds)
        return say(allGone ? Text::tr("The drawing is empty: there is nothing to cut.")
                           : Text::tr("Nothing visible is left: every shape is hidden."));
    const QString place = placeText(*bounds, imported);
    if (allGone)
        return say(nothingLeftText(keep, place, counts));
    say((keep == Keep::Inside
             ? Text::tr("Nothing visible is left: every visible shape is outside the window. "
                        "These shapes are in %1.")
             : Text::tr("Nothing visible is left: every visible shape is inside the window. "
                        "These shapes are in %1."))
            .arg(place));
}

void reportCut(const Imported& imported, const Document& before, const CutCounts& counts,
               bool keepsContacts)
{
    const std::size_t hidden = hiddenObjects(before).size(); // the cut applied to all of them
    sayLosses(imported.report);
    QString text = shapesText(counts, keepsContacts);
    if (counts.opened > 0)
        text += Text::tr("; closed paths opened: %1").arg(counts.opened);
    say(text + u'.');
    if (counts.leftHidden > 0)
        say(Text::tr("Hidden shapes are left whole: %1.").arg(counts.leftHidden));
    else if (hidden > 0)
        say(Text::tr("Hidden shapes are cut like the others: %1 left and still hidden, %2 "
                     "removed. --drop-hidden leaves out all of them.")
                .arg(counts.hidden)
                .arg(hidden - counts.hidden));
}

/// Removes hidden objects if requested, or if the file cannot hide them; returns their number.
std::size_t dropHidden(const ParsedArguments& arguments, const Output& output, Document& document)
{
    if (output.format->hides == StoresHidden::Yes && !arguments.has(QStringLiteral("drop-hidden")))
        return 0;
    const std::size_t hidden = hiddenObjects(document).size();
    document = withoutHidden(std::move(document));
    return hidden;
}

void sayDropped(const ParsedArguments& arguments, const Output& output, std::size_t dropped)
{
    if (!arguments.has(QStringLiteral("drop-hidden")))
        sayHiddenLeftOut(dropped, *output.format);
    else if (dropped > 0)
        say(Text::tr("Hidden shapes: %1 left out.").arg(dropped));
}

/// Reports the duration of each part of the work, if requested.
class Laps {
public:
    void lap(const QString& what)
    {
        const auto now = std::chrono::steady_clock::now();
        laps_ << Text::tr("%1 %2 ms")
                     .arg(what)
                     .arg(std::chrono::duration<double, std::milli>(now - last_).count(), 0, 'f',
                          1);
        last_ = now;
    }
    QString text() const { return laps_.join(QStringLiteral(", ")); }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    QStringList laps_;
};

std::vector<std::uint32_t> sourceRows(const std::vector<std::uint32_t>& imported,
                                      const Document& before, const Cut& cut)
{
    std::vector<std::uint32_t> rows;
    if (!imported.empty()) {
        rows = sourcesOf(cut, before.objects().size());
        std::ranges::transform(rows, rows.begin(), [&](auto object) { return imported[object]; });
    }
    return rows;
}

void clip(const ParsedArguments& arguments)
{
    const QString input = arguments.operands().first();
    Output output = outputOf(arguments, input);
    if (clipsTable(arguments, input, output))
        return clipTable(arguments, input, output,
                         cutOptionsOf(arguments, tableWithoutLines(), output));
    Laps laps;
    Imported imported = readDrawing(arguments, input);
    joinAsAsked(arguments, imported);
    refuseLossInPlace(arguments, imported, input, output);
    laps.lap(Text::tr("read"));

    const CutOptions options = cutOptionsOf(arguments, imported, output);
    const auto plan = tilePlanOf(arguments, imported.document.page());
    const DrawingPart part = chosenPart(arguments, imported);
    Document before = part.drawing;
    const std::size_t dropped = dropHidden(arguments, output, before);
    makeAreasIfWanted(arguments, before);
    const auto covered = occludeIfWanted(arguments, options, before); // rows of CSV have no areas
    const Document shown = before;
    before = asHeld(std::move(before), *output.format, options.tolerance);
    Cut result = cut(before, options, ProgressLine().follower());
    result.edit.windows = ClipWindows(); // it is cut already
    Document after = before;
    after.apply(result.edit);
    fitPaper(arguments, keptWindows(arguments, imported), after);
    laps.lap(Text::tr("cut"));

    takePage(output, imported);
    output.options.tolerance = options.tolerance;
    output.options.sources = sourceRows(part.rows, before, result);
    if (options.region.keep == Keep::Inside)
        output.options.bounds = options.region.single();
    if (plan)
        writeTiles(arguments, *plan, after, options, output);
    else
        writeDrawing(after, output);
    laps.lap(Text::tr("write"));

    if (!arguments.has(QStringLiteral("quiet"))) {
        if (covered)
            say(occlusionText(*covered));
        reportCut(imported, before, result.counts, options.keepContacts);
        sayNotHeld(shown, leftBy(result, shown.objects().size()), output);
        sayOutsideMap(after, output);
        sayPoints(rounded(after, output.options).points);
        sayDropped(arguments, output, dropped);
        if (const QString more = furtherCountsText(result.counts); !more.isEmpty())
            say(more);
        say(windowText(arguments, imported, options.region));
        if (hiddenObjects(after).size() == after.objects().size())
            sayNothingIsLeft(imported, before, after, options.region.keep, result.counts);
    }
    if (arguments.has(QStringLiteral("stats")))
        say(Text::tr("Lines: %1 before, %2 after; %3.")
                .arg(result.counts.segmentsBefore)
                .arg(result.counts.segmentsAfter)
                .arg(laps.text()));
}

} // namespace

Command clipCommand()
{
    std::vector<Option> options = shapedWindowOptions();
    const std::vector<Option> further{
        {{"k", "keep"},
         "inside|outside",
         Text::tr("Which part to keep (inside, or as the drawing says).")},
        {{"a", "algorithm"},
         "ALGORITHM",
         Text::tr("Key or abbreviation of the algorithm (%1).")
             .arg(QLatin1StringView(usualAlgorithm().key))},
        {{"form"},
         "corrected|published",
         Text::tr("The corrected form, or the published one (corrected).")},
        toleranceOption(),
        {{"drop-hidden"},
         {},
         Text::tr("Leave out hidden shapes and layers. Otherwise they are cut like the others, "
                  "and stay hidden if the type of the output can hide them (svg). Locked "
                  "layers are always cut.")},
    };
    for (const auto& more : {further, cuttingOptions(), tileOptions(), tableClipOptions(),
                             partOptions(), writingOptions(), readingOptions()})
        options.insert(options.end(), more.begin(), more.end());
    options.push_back(joinOption());
    options.push_back({{"q", "quiet"}, {}, Text::tr("Do not report windows, counts and losses.")});
    options.push_back({{"stats"}, {}, Text::tr("Report the number of lines and the times.")});
    return {"clip",
            "INPUT -o OUTPUT [OPTIONS]",
            Text::tr("Cuts a drawing at a window, or at all its clip windows: lines and curves "
                     "really end there."),
            std::move(options),
            {"clearcut clip plan.svg --page --margin 10mm -o plan-cut.svg",
             "clearcut clip map.svg -w 0,0,210mm,297mm --keep outside -a nln -o hole.pdf",
             "clearcut clip map.svg -w circle:50mm,50mm,40mm --cut-out shape:lake -o round.svg",
             "clearcut clip plan.svg --page --occlude --min-length 1mm -o plotter.svg",
             "clearcut clip logo.svg --layer Logo --fit-paper --background none -o logo.png",
             "clearcut clip poster.svg --page --tiles a4 --overlap 5mm --marks -o poster.pdf",
             "clearcut clip - --from csv -w -100,-75,100,75 --to csv -o - < lines.csv"},
            1,
            clip,
            Paints::Letters,
            readingAndWritingLimits() << tableLimit()};
}

} // namespace app

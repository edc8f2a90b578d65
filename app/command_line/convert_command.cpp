// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/part_options.h"
#include "app/command_line/terminal.h"
#include "app/document/hidden_objects.h"
#include "app/formats/rounded.h"

namespace app {
namespace {

void convert(const ParsedArguments& arguments)
{
    const QString input = arguments.operands().first();
    Output output = outputOf(arguments, input);
    Imported imported = readDrawing(arguments, input);
    joinAsAsked(arguments, imported);
    refuseLossInPlace(arguments, imported, input, output);
    output.options.tolerance = toleranceOf(arguments, imported.document.page());
    auto [drawing, rows] = chosenPart(arguments, imported);
    fitPaper(arguments, {}, drawing);
    output.options.sources = std::move(rows);
    takePage(output, imported);
    writeDrawing(drawing, output);
    if (arguments.has(QStringLiteral("quiet")))
        return;
    sayLosses(imported.report);
    sayNotHeld(drawing, ObjectRanges(ObjectRange{0, drawing.objects().size()}), output);
    sayOutsideMap(drawing, output);
    sayPoints(rounded(drawing, output.options).points);
    if (output.format->hides == StoresHidden::No)
        sayHiddenLeftOut(hiddenObjects(drawing).size(), *output.format);
}

} // namespace

Command convertCommand()
{
    std::vector<Option> options = partOptions();
    for (const auto& more : {writingOptions(), readingOptions()})
        options.insert(options.end(), more.begin(), more.end());
    options.push_back(clipPathsOption());
    options.push_back(joinOption());
    options.push_back(toleranceOption());
    options.push_back({{"q", "quiet"}, {}, Text::tr("Do not report losses.")});
    return {"convert",
            "INPUT -o OUTPUT [OPTIONS]",
            Text::tr("Writes a drawing as another type of file, without cutting it."),
            std::move(options),
            {"clearcut convert drawing.svg -o drawing.pdf",
             "clearcut convert drawing.svg --layer Walls --fit-paper -o walls.pdf"},
            1,
            convert,
            Paints::Letters,
            readingAndWritingLimits()};
}

} // namespace app

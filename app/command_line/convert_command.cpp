// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/drawing_files.h"
#include "app/command_line/terminal.h"
#include "app/document/hidden_objects.h"
#include "app/formats/rounded.h"

namespace app {
namespace {

void convert(const ParsedArguments& arguments)
{
    const QString input = arguments.operands().first();
    Output output = outputOf(arguments, input);
    const Imported imported = readDrawing(arguments, input);
    refuseLossInPlace(arguments, imported, input, output);
    output.options.sources = imported.rows;
    output.options.tolerance = toleranceOf(arguments, imported.document.page());
    writeDrawing(imported.document, output);
    if (arguments.has(QStringLiteral("quiet")))
        return;
    sayLosses(imported.report);
    sayPoints(rounded(imported.document, output.options).points);
    if (output.format->hides == StoresHidden::No)
        sayHiddenLeftOut(hiddenObjects(imported.document).size(), *output.format);
}

} // namespace

Command convertCommand()
{
    std::vector<Option> options = writingOptions();
    for (Option& more : readingOptions())
        options.push_back(std::move(more));
    options.push_back(toleranceOption());
    options.push_back({{"q", "quiet"}, {}, Text::tr("Do not report losses.")});
    return {"convert",
            "INPUT -o OUTPUT [OPTIONS]",
            Text::tr("Writes a drawing as another type of file, without cutting it."),
            std::move(options),
            {"clearcut convert drawing.svg -o drawing.pdf"},
            1,
            convert,
            false,
            readingAndWritingLimits()};
}

} // namespace app

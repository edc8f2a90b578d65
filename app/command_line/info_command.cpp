// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/drawing_files.h"
#include "app/command_line/refusal.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/document/compared_window.h"
#include "app/document/contents.h"
#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"
#include "app/formats/number.h"
#include "app/formats/rectangle_text.h"

#include <algorithm>
#include <limits>

namespace app {
namespace {

QString text(double value)
{
    std::string number;
    appendNumber(number, value);
    return QString::fromStdString(number);
}

// A sum, which may be beyond all numbers.
QString rounded(double value)
{
    constexpr double most = std::numeric_limits<double>::max();
    constexpr int decimals = 3;
    std::string number;
    appendNumber(number, std::min(value, most), decimals, 0, most);
    return QString::fromStdString(number);
}

QString text(const Length& length)
{
    return text(length.value) + QLatin1StringView(infoOf(length.unit).suffix);
}

using Rows = std::vector<std::pair<QString, QString>>;

QString stateOf(const Container& container)
{
    return (container.visible ? QString() : Commands::tr(", hidden"))
           + (container.locked ? Commands::tr(", locked") : QString());
}

// Each with what is in it, also in those in it.
Rows layerRows(const Document& document, double tolerance)
{
    Rows rows;
    for (const ContainerId id : document.containers().childrenOf(0)) {
        const ObjectRange range = document.containers().rangeOf(id);
        Contents contents;
        document.objects().forEach(
            range.first, range.size(),
            [&](std::size_t, const ObjectView& object) { add(contents, object, tolerance); });
        const Container& layer = document.containers()[id];
        rows.emplace_back(Commands::tr("layer"), Commands::tr("“%1”: shapes %2, lines %3%4")
                                                     .arg(layer.name)
                                                     .arg(contents.objects)
                                                     .arg(contents.lines)
                                                     .arg(stateOf(layer)));
    }
    return rows;
}

Rows rowsOf(const Imported& imported)
{
    const Document& document = imported.document;
    const Page& page = document.page();
    const Contents all = contentsOf(document);
    const double unit = page.millimetresPerUnit();
    Rows rows{
        {Commands::tr("lines"), QString::number(all.lines)},
        {Commands::tr("length"),
         Commands::tr("%1, on paper %2mm").arg(rounded(all.length), rounded(all.length * unit))},
        {Commands::tr("shapes"),
         Commands::tr("%1, hidden %2").arg(all.objects).arg(hiddenObjects(document).size())},
        {Commands::tr("paths"), Commands::tr("%1, closed %2, curves %3")
                                    .arg(all.subpaths)
                                    .arg(all.closedSubpaths)
                                    .arg(all.curves)},
        {Commands::tr("bounds"), all.bounds ? rectangleText(*all.bounds) : Commands::tr("none")},
        {Commands::tr("in mm"),
         all.bounds ? millimetreText(*all.bounds, imported) : Commands::tr("none")},
        {Commands::tr("window"), rectangleText(windowOf(imported))},
        {Commands::tr("page"),
         Commands::tr("%1, on paper %2 × %3")
             .arg(rectangleText(page.rectangle()), text(page.width), text(page.height))},
        {Commands::tr("unit"), text(page.millimetresPerUnit()) + QStringLiteral("mm")},
    };
    for (auto& row : layerRows(document, usualTolerance(page)))
        rows.push_back(std::move(row));
    const QStringList lost = losses(imported);
    for (const QString& line : lost)
        rows.emplace_back(Commands::tr("import"), line);
    return rows;
}

void inform(const Given& given)
{
    print(inColumns(rowsOf(readDrawing(given, given.operands().first()))));
}

} // namespace

Command infoCommand()
{
    return {
        "info",
        "INPUT [OPTIONS]",
        Commands::tr("Says what a drawing holds: lines and their length, shapes, paths and curves, "
                     "bounds (in millimetres, too), clip window, page, unit, layers, and what of "
                     "the file is not kept."),
        readingOptions(),
        {"clearcut info drawing.svg"},
        1,
        inform,
        false,
        readingLimits()};
}

} // namespace app

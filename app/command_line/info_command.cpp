// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/drawing_files.h"
#include "app/command_line/refusal.h"
#include "app/command_line/terminal.h"
#include "app/command_line/window_options.h"
#include "app/document/contents.h"
#include "app/document/flatten.h"
#include "app/document/legacy.h"
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

std::vector<std::pair<QString, QString>> layerRows(const Sheet& sheet,
                                                   const std::vector<Contents>& layers)
{
    std::vector<std::pair<QString, QString>> rows;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Layer& layer = sheet.layers[i];
        QString state = layer.visible ? QString() : Commands::tr(", hidden");
        state += layer.locked ? Commands::tr(", locked") : QString();
        rows.emplace_back(Commands::tr("layer"), Commands::tr("“%1”: shapes %2, lines %3%4")
                                                     .arg(layer.name)
                                                     .arg(layers[i].shapes)
                                                     .arg(layers[i].lines)
                                                     .arg(state));
    }
    return rows;
}

std::vector<std::pair<QString, QString>> rowsOf(const Imported& imported)
{
    const Sheet sheet = sheetOf(imported.document);
    Contents all;
    std::vector<Contents> layers(sheet.layers.size());
    const double tolerance = usualTolerance(sheet.page);
    const double unit = sheet.page.millimetresPerUnit();
    for (const Shape& shape : sheet.shapes) {
        add(all, shape, tolerance);
        add(layers[shape.layer], shape, tolerance);
    }
    std::vector<std::pair<QString, QString>> rows{
        {Commands::tr("lines"), QString::number(all.lines)},
        {Commands::tr("length"),
         Commands::tr("%1, on paper %2mm").arg(rounded(all.length), rounded(all.length * unit))},
        {Commands::tr("shapes"),
         Commands::tr("%1, hidden %2").arg(all.shapes).arg(hiddenIn(sheet))},
        {Commands::tr("paths"), Commands::tr("%1, closed %2, curves %3")
                                    .arg(all.paths)
                                    .arg(all.closedPaths)
                                    .arg(all.curves)},
        {Commands::tr("bounds"), all.bounds ? rectangleText(*all.bounds) : Commands::tr("none")},
        {Commands::tr("in mm"),
         all.bounds ? millimetreText(*all.bounds, imported) : Commands::tr("none")},
        {Commands::tr("window"), rectangleText(windowOf(imported))},
        {Commands::tr("page"), Commands::tr("%1, on paper %2 × %3")
                                   .arg(rectangleText(sheet.page.rectangle()),
                                        text(sheet.page.width), text(sheet.page.height))},
        {Commands::tr("unit"), text(sheet.page.millimetresPerUnit()) + QStringLiteral("mm")},
    };
    for (auto& row : layerRows(sheet, layers))
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/drawing_files.h"
#include "app/command_line/refusal.h"
#include "app/command_line/terminal.h"
#include "app/document/flatten.h"
#include "app/formats/number.h"

#include <glm/common.hpp>

#include <optional>

namespace app {
namespace {

QString text(double value)
{
    std::string number;
    appendNumber(number, value);
    return QString::fromStdString(number);
}

QString text(const Length& length)
{
    return text(length.value) + QLatin1StringView(infoOf(length.unit).suffix);
}

QString text(const clipping::Window& w)
{
    return QStringLiteral("%1,%2,%3,%4")
        .arg(text(w.min.x), text(w.min.y), text(w.max.x), text(w.max.y));
}

/// What there is in a layer, or in the whole drawing; curves as the lines they are clipped as.
struct Content {
    std::size_t shapes = 0, lines = 0;
    std::optional<clipping::Window> bounds;

    void add(const std::vector<Chord>& chords)
    {
        ++shapes;
        lines += chords.size();
        for (const Chord& chord : chords)
            for (const Point& p : {chord.segment.a, chord.segment.b})
                bounds = bounds
                             ? clipping::Window{glm::min(bounds->min, p), glm::max(bounds->max, p)}
                             : clipping::Window{p, p};
    }
};

std::vector<std::pair<QString, QString>> layerRows(const Sheet& sheet,
                                                   const std::vector<Content>& layers)
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
    const Sheet& sheet = imported.sheet;
    Content all;
    std::vector<Content> layers(sheet.layers.size());
    const double tolerance = usualTolerance(sheet.page);
    std::size_t hidden = 0;
    std::vector<Chord> chords;
    for (const Shape& shape : sheet.shapes) {
        chords.clear();
        for (const Path& path : shape.paths)
            flatten(path, tolerance, chords);
        all.add(chords);
        layers[shape.layer].add(chords);
        hidden += !sheet.shown(shape);
    }
    std::vector<std::pair<QString, QString>> rows{
        {Commands::tr("lines"), QString::number(all.lines)},
        {Commands::tr("shapes"), Commands::tr("%1, hidden %2").arg(all.shapes).arg(hidden)},
        {Commands::tr("bounds"), all.bounds ? text(*all.bounds) : Commands::tr("none")},
        {Commands::tr("window"), text(sheet.window)},
        {Commands::tr("page"),
         Commands::tr("%1, on paper %2 × %3")
             .arg(text(sheet.page.rectangle()), text(sheet.page.width), text(sheet.page.height))},
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
    print(aligned(rowsOf(readDrawing(given, given.operands().first()))));
}

} // namespace

Command infoCommand()
{
    return {
        "info",
        "INPUT [OPTIONS]",
        Commands::tr("Says what a drawing holds: lines, layers, bounds, page, units, clip window, "
                     "and what of the file is not kept."),
        readingOptions(),
        {"clearcut info drawing.svg"},
        1,
        inform};
}

} // namespace app

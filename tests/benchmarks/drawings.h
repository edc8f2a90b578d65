// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/experiment/paper_scene.h"
#include "app/formats/format.h"

#include "tests/benchmarks/map_lines.h"
#include "tests/benchmarks/short_lines.h"

// What the benchmarks of the canvas draw, each with a clip window.

/// A style for the line of this number; all of one, or each in a colour of its own.
inline app::Style strokeOf(std::size_t line, bool ownColours, double width)
{
    const auto mixed = std::uint32_t(line) * 2654435761u;
    const auto part = [&](int shift) { return std::uint8_t((mixed >> shift) & 255); };
    return {.stroke = ownColours ? app::Colour{part(24), part(16), part(8)} : app::Colour{},
            .width = width};
}

/// The paper's scene: lines with both ends anywhere on the page.
inline app::Document longLines(std::size_t count, bool ownColours = false)
{
    app::PaperScene scene(1);
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    app::StyleEntry style = builder.style(strokeOf(0, false, 1));
    for (std::size_t i = 0; i < count; ++i) {
        clipping::Segment line;
        scene.fill({&line, 1});
        if (ownColours)
            style = builder.style(strokeOf(i, true, 1));
        builder.addLine(line, style);
    }
    builder.close();
    return builder.take({{-960, -720}, {1920, 1440}, {1920, app::Unit::Px}, {1440, app::Unit::Px}},
                        {}, {{{.shape = app::RectangleShape{app::paperWindow}}}});
}

/// The map as many times as needed, with the window on its middle ninth: its outlines, as in a
/// drawing, or each line by itself, as in a table.
inline app::Document mapDrawing(std::size_t count, bool separate)
{
    const Scene<double> map = mapLines(count);
    app::DocumentBuilder builder;
    builder.open({.name = "Map"});
    const app::StyleEntry style = builder.style(strokeOf(0, false, 0.5));
    app::Subpath path;
    const auto close = [&] {
        if (!path.segments.empty())
            builder.add(app::ObjectRow{.path = app::Path({&path, 1}), .style = style});
        path = {};
    };
    for (auto [a, b] : map.segments) {
        if (separate) {
            builder.addLine({a, b}, style);
            continue;
        }
        if (path.segments.empty() || path.segments.back().to != a) {
            close();
            path.start = a;
        }
        path.segments.push_back({b});
    }
    close();
    builder.close();
    return builder.take({{-300, -300}, {600, 600}, {600, app::Unit::Px}, {600, app::Unit::Px}}, {},
                        {{{.shape = app::RectangleShape{map.window}}}});
}

/// A drawing by its name: LINES (short ones), longLINES, coloursLINES (long, each in its own
/// colour), mapLINES, tableLINES (the map, each line by itself), or a file. Ends the program if
/// the file cannot be read.
inline app::Imported drawingOf(const QString& name)
{
    const auto count = [&](QLatin1String kind) {
        return name.startsWith(kind) ? name.mid(kind.size()).toULongLong() : 0;
    };
    if (const auto lines = count(QLatin1String()))
        return {shortLines(int(lines)), {}};
    if (const auto lines = count(QLatin1String("long")))
        return {longLines(lines), {}};
    if (const auto lines = count(QLatin1String("colours")))
        return {longLines(lines, true), {}};
    for (const auto kind : {QLatin1String("map"), QLatin1String("table")})
        if (const auto lines = count(kind))
            return {mapDrawing(lines, kind == QLatin1String("table")), {}};
    auto read = app::readFile(name);
    if (!read)
        qFatal("%s", qPrintable(read.error));
    return std::move(*read.value);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/flatten.h"

#include <cmath>

#include "tests/app/formats/svg/text.h"

/// The length of all lines of a drawing of these elements, rounded to hundredths.
inline double lengthOf(const QByteArray& elements)
{
    const auto read = readText(drawing(elements));
    if (!read)
        return -1;
    double length = 0;
    std::vector<app::Chord> chords;
    for (const app::Shape& shape : app::sheetOf(read.value->document).shapes)
        for (const app::Subpath& path : shape.paths)
            if (shape.style.stroke)
                app::flatten(path, 1e-5, chords);
    for (const app::Chord& chord : chords)
        length += std::hypot(chord.segment.b.x - chord.segment.a.x,
                             chord.segment.b.y - chord.segment.a.y);
    return std::round(length * 100) / 100;
}

/// The area of all fills of a drawing of these elements, rounded to hundredths.
inline double areaOf(const QByteArray& elements)
{
    const auto read = readText(drawing(elements));
    if (!read)
        return -1;
    double area = 0;
    for (const app::Shape& shape : app::sheetOf(read.value->document).shapes) {
        if (!shape.style.fill)
            continue;
        double own = 0;
        std::vector<app::Chord> chords;
        for (const app::Subpath& path : shape.paths)
            app::flatten(path, 1e-5, chords);
        for (const app::Chord& chord : chords)
            own += app::cross(chord.segment.a, chord.segment.b) / 2;
        area += std::abs(own);
    }
    return std::round(area * 100) / 100;
}

/// Nine horizontal lines across the drawing.
inline QByteArray hatch()
{
    QByteArray lines;
    for (int y = 10; y < 100; y += 10)
        lines += "M0 " + QByteArray::number(y) + "H100";
    return "<path fill='none' stroke='#000' d='" + lines + "'/>";
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/formats/format.h"

#include <QBuffer>

#include <algorithm>
#include <cmath>

#include "tests/app/document/sheet.h"

// DXF texts in short: "0|LINE|10|5" stands for the lines 0, LINE, 10 and 5.

namespace tests::dxf {

inline QByteArray section(const char* name, const QByteArray& content)
{
    return QByteArray("0|SECTION|2|") + name + '|' + content + (content.isEmpty() ? "" : "|")
           + "0|ENDSEC|";
}

/// A file in millimetres with these entities, after other sections.
inline QByteArray file(const QByteArray& entities, const QByteArray& before = {})
{
    return section("HEADER", "9|$ACADVER|1|AC1015|9|$INSUNITS|70|4") + before
           + section("ENTITIES", entities) + "0|EOF|";
}

inline app::Result<app::Imported> read(QByteArray text)
{
    if (!text.startsWith("AutoCAD"))
        text.replace('|', '\n');
    QBuffer buffer(&text);
    buffer.open(QIODevice::ReadOnly);
    return app::findFormat(u"dxf")->read(buffer);
}

/// The drawing of a file that must be readable; empty otherwise.
inline app::Sheet sheet(const QByteArray& text)
{
    const auto imported = read(text);
    return imported ? app::sheetOf(imported.value->document) : app::Sheet{};
}

/// "2 entities of the type “RAY”" for each entry of the report.
inline QStringList report(const QByteArray& text)
{
    const auto imported = read(text);
    if (!imported)
        return {imported.error};
    QStringList lines;
    for (const app::Loss& loss : imported.value->report)
        lines << QStringLiteral("%1 %2").arg(loss.count).arg(loss.what);
    return lines;
}

/// The bounds of points on the curves of a shape, many for each.
inline clipping::Window boundsOf(const app::Shape& shape)
{
    clipping::Window box{app::Point(INFINITY), app::Point(-INFINITY)};
    for (const app::Subpath& path : shape.paths) {
        app::Point last = path.start;
        for (const app::PathSegment& s : path.segments) {
            const app::Bezier curve = s.curved ? app::Bezier{last, s.control1, s.control2, s.to}
                                               : app::Bezier{last, last, s.to, s.to};
            for (int i = 0; i <= 100; ++i) {
                const app::Point p = curve.at(i / 100.0);
                box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
                box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
            }
            last = s.to;
        }
    }
    return box;
}

inline bool near(const app::Point& a, const app::Point& b, double tolerance = 1e-9)
{
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

inline bool near(const clipping::Window& a, const clipping::Window& b, double tolerance = 1e-9)
{
    return near(a.min, b.min, tolerance) && near(a.max, b.max, tolerance);
}

} // namespace tests::dxf

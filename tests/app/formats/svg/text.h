// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QBuffer>

#include "tests/app/document/sheet.h"
#include "tests/content_of.h"

// Between SVG texts and drawings, through the catalogue's row.

inline app::Result<app::Imported> readText(const QByteArray& text)
{
    QBuffer buffer;
    buffer.setData(text);
    buffer.open(QIODevice::ReadOnly);
    return app::findFormat(u"svg")->read(buffer);
}

inline QByteArray textOf(const app::Document& document, const app::WriteOptions& options = {})
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = app::findFormat(u"svg")->write(document, buffer, options);
    return error ? QByteArray() : buffer.data();
}

inline QByteArray textOf(const app::Sheet& sheet, const app::WriteOptions& options = {})
{
    return textOf(app::documentOf(sheet), options);
}

/// A drawing of 100 by 100 units around some elements.
inline QByteArray drawing(const QByteArray& elements)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
           "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' width='100' height='100' "
           "viewBox='0 0 100 100'>"
           + elements + "</svg>";
}

/// The only shape of a drawing that has just one element, or a shape without paths.
inline app::Shape shapeOf(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result && result.value->document.objects().size() == 1
               ? app::sheetOf(result.value->document).shapes.front()
               : app::Shape();
}

/// What an import of the elements lost, as "3 texts; 1 masks".
inline QString reportOf(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    QStringList parts;
    if (result)
        for (const app::Loss& loss : result.value->report)
            parts << QStringLiteral("%1 %2").arg(loss.count).arg(loss.what);
    return result ? parts.join("; ") : result.error;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/content_kind.h"

#include "app/base/text.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

struct Row {
    QByteArray begin; ///< of the content, without blanks before it
    const char* name;
    const char* ending = "";
};

// THE CATALOGUE.
const std::array rows{
    Row{"%PDF-", QT_TRANSLATE_NOOP("Text", "a PDF document")},
    Row{"%!PS", QT_TRANSLATE_NOOP("Text", "a PostScript document")},
    Row{"\x89PNG", QT_TRANSLATE_NOOP("Text", "a PNG picture")},
    Row{"\xff\xd8\xff", QT_TRANSLATE_NOOP("Text", "a JPEG picture")},
    Row{"GIF8", QT_TRANSLATE_NOOP("Text", "a GIF picture")},
    Row{"PK\x03\x04", QT_TRANSLATE_NOOP("Text", "a ZIP archive")},
    Row{"AC10", QT_TRANSLATE_NOOP("Text", "a DWG drawing"), "dwg"},
    Row{"AutoCAD Binary DXF", QT_TRANSLATE_NOOP("Text", "a DXF drawing"), "dxf"},
    Row{"0\nSECTION", QT_TRANSLATE_NOOP("Text", "a DXF drawing"), "dxf"},
    Row{"999\n", QT_TRANSLATE_NOOP("Text", "a DXF drawing"), "dxf"},
    Row{"<svg", QT_TRANSLATE_NOOP("Text", "an SVG drawing"), "svg"},
    Row{"<?xml", QT_TRANSLATE_NOOP("Text", "an XML file, perhaps an SVG drawing"), "svg"},
    Row{"<!DOCTYPE svg", QT_TRANSLATE_NOOP("Text", "an SVG drawing"), "svg"},
    Row{"{\"type\":", QT_TRANSLATE_NOOP("Text", "a GeoJSON map"), "geojson"},
};

} // namespace

ContentKind contentKind(const QByteArray& head)
{
    QByteArray text = head.left(contentHead).trimmed();
    if (text.startsWith('{') || text.startsWith('0') || text.startsWith("999"))
        text = text.replace('\r', "").replace(' ', ""); // both are free to have blanks
    const auto found =
        std::ranges::find_if(rows, [&](const Row& row) { return text.startsWith(row.begin); });
    return found == rows.end()
               ? ContentKind()
               : ContentKind{Text::tr(found->name), QString::fromLatin1(found->ending)};
}

} // namespace app

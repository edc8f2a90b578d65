// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/look_columns.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"
#include "app/formats/csv/columns.h"

namespace app::csv {
namespace {

std::string colourText(const Colour& colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    const auto append = [&](std::uint8_t part) {
        text += digits[part >> 4];
        text += digits[part & 15];
    };
    append(colour.red);
    append(colour.green);
    append(colour.blue);
    if (colour.alpha != 255)
        append(colour.alpha);
    return text;
}

} // namespace

std::string headerText(bool withSource)
{
    std::string text;
    for (std::size_t i = 0; i < columnNames.size() - (withSource ? 0 : 1); ++i)
        (text += i > 0 ? "," : "") += columnNames[i];
    return text + '\n';
}

std::string lookColumns(const QString& layer, const Colour& strokeColour, double width)
{
    std::string text = ",";
    appendField(text, layer.toStdString());
    (text += ',') += colourText(strokeColour);
    text += ',';
    appendNumber(text, width);
    return text;
}

QString usualLayer() { return QStringLiteral("Drawing"); }

} // namespace app::csv

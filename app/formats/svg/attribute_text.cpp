// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/attribute_text.h"

#include "app/base/number.h"

namespace app::svg {

std::string escaped(const QString& text)
{
    std::string result;
    for (const char c : text.toStdString()) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\t':
            result += "&#9;";
            break;
        case '\n':
            result += "&#10;";
            break;
        case '\r':
            result += "&#13;";
            break;
        default:
            if (static_cast<unsigned char>(c) >= 0x20)
                result += c;
        }
    }
    return result;
}

std::string escapedContent(const QString& text)
{
    std::string result;
    for (const char c : text.toStdString()) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '\r')
            result += "&#13;";
        else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
            result += c;
    }
    return result;
}

void appendAttribute(std::string& text, std::string_view name, std::string_view value)
{
    (((text += ' ') += name) += "=\"") += value;
    text += '"';
}

void appendAttribute(std::string& text, std::string_view name, double value)
{
    appendAttribute(text, name, std::span(&value, 1));
}

void appendAttribute(std::string& text, std::string_view name, std::span<const double> values)
{
    ((text += ' ') += name) += "=\"";
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0)
            text += ' ';
        appendNumber(text, values[i]);
    }
    text += '"';
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/typed_colour.h"

#include "app/base/text.h"
#include "app/formats/svg/colour.h"

#include <algorithm>

namespace app {

QString hexText(const Colour& colour)
{
    QString text = QStringLiteral("#");
    for (const std::uint8_t part : {colour.red, colour.green, colour.blue, colour.alpha})
        text += QStringLiteral("%1").arg(part, 2, 16, QLatin1Char('0')).toUpper();
    return colour.alpha == 255 ? text.first(7) : text;
}

Result<Colour> typedColour(const QString& typed)
{
    const QString text = typed.trimmed();
    const bool digits = !text.isEmpty() && std::ranges::all_of(text, [](QChar c) {
        return c.isDigit() || (c.toLower() >= u'a' && c.toLower() <= u'f');
    });
    const auto colour = svg::parseColour((digits ? u'#' + text : text).toStdString());
    if (colour)
        return Result<Colour>::of(*colour);
    constexpr qsizetype most = 20; // characters
    const QString quoted = text.size() > most ? text.first(most) + u'…' : text;
    return Result<Colour>::failure(Text::tr("“%1” is not a colour. Type six hexadecimal digits "
                                            "such as 8A5A2B, or a name such as teal.")
                                       .arg(quoted));
}

} // namespace app

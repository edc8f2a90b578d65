// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_colours.h"

#include "app/base/text.h"
#include "app/formats/svg/colour.h"

#include <QStringList>

#include <algorithm>

namespace app {
namespace {

const QString recentColoursKey = QStringLiteral("recentColours");

} // namespace

std::vector<Colour> recentColours(const QSettings& settings)
{
    std::vector<Colour> colours;
    for (const QString& text : settings.value(recentColoursKey).toStringList()) {
        const auto colour = typedColour(text); // other programs may have written the settings file
        const bool isNew = colour && std::ranges::find(colours, *colour.value) == colours.end();
        if (isNew && colours.size() < mostRecentColours)
            colours.push_back(*colour.value);
    }
    return colours;
}

void rememberColour(QSettings& settings, const Colour& colour)
{
    QStringList texts{hexText(colour)};
    for (const Colour& other : recentColours(settings))
        if (other != colour && texts.size() < qsizetype(mostRecentColours))
            texts << hexText(other);
    settings.setValue(recentColoursKey, texts);
}

QString hexText(const Colour& colour)
{
    return QString::fromStdString(svg::hexOf(colour)).toUpper();
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

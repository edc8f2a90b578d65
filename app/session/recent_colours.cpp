// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recent_colours.h"

#include "app/session/typed_colour.h"

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

} // namespace app

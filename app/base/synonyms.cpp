// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/synonyms.h"

#include <QHash>
#include <QStringList>

#include <array>

namespace app {

namespace {

QString utf8(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

} // namespace

std::span<const Synonym> synonyms()
{
    static constexpr std::array all{
        Synonym{"accuracy", "exactness"},
        Synonym{"anchor", "node"},
        Synonym{"array", "repeat"},
        Synonym{"bezier", "pen"},
        Synonym{"bigger", "scale"},
        Synonym{"border", "stroke"},
        Synonym{"box", "rectangle"},
        Synonym{"brush", "pencil"},
        Synonym{"circle", "ellipse"},
        Synonym{"clone", "duplicate"},
        Synonym{"combine", "group"},
        Synonym{"connect", "join"},
        Synonym{"contour", "outline"},
        Synonym{"course", "lessons"},
        Synonym{"customize", "settings"},
        Synonym{"distribute", "spread"},
        Synonym{"divide", "split"},
        Synonym{"enlarge", "scale"},
        Synonym{"erase", "delete"},
        Synonym{"eraser", "delete"},
        Synonym{"eyedropper", "take"},
        Synonym{"font", "text"},
        Synonym{"frame", "window"},
        Synonym{"freehand", "pencil"},
        Synonym{"hexagon", "polygon"},
        Synonym{"hotkeys", "shortcuts"},
        Synonym{"justify", "align"},
        Synonym{"larger", "scale"},
        Synonym{"magnet", "snapping"},
        Synonym{"magnify", "zoom"},
        Synonym{"mask", "clip"},
        Synonym{"merge", "join"},
        Synonym{"mirror", "flip"},
        Synonym{"options", "settings"},
        Synonym{"oval", "ellipse"},
        Synonym{"paint", "fill"},
        Synonym{"pan", "hand"},
        Synonym{"paper", "page"},
        Synonym{"pipette", "take"},
        Synonym{"precision", "exactness"},
        Synonym{"preferences", "settings"},
        Synonym{"reflect", "flip"},
        Synonym{"remove", "delete"},
        Synonym{"resize", "scale"},
        Synonym{"revert", "undo"},
        Synonym{"scissors", "split"},
        Synonym{"scroll", "hand"},
        Synonym{"shear", "skew"},
        Synonym{"shrink", "scale"},
        Synonym{"size", "scale"},
        Synonym{"slant", "skew"},
        Synonym{"slice", "split"},
        Synonym{"smaller", "scale"},
        Synonym{"spin", "rotate"},
        Synonym{"square", "rectangle"},
        Synonym{"stretch", "scale"},
        Synonym{"thickness", "width"},
        Synonym{"tilt", "skew"},
        Synonym{"trash", "delete"},
        Synonym{"triangle", "polygon"},
        Synonym{"trim", "crop"},
        Synonym{"turn", "rotate"},
        Synonym{"tutorial", "lessons"},
        Synonym{"vertex", "node"},
        Synonym{"viewport", "window"},
        Synonym{"weight", "width"},
    };
    return all;
}

QString inProgramWords(const QString& text)
{
    static const QHash<QString, QString> known = [] {
        QHash<QString, QString> all;
        for (const Synonym& synonym : synonyms())
            all[utf8(synonym.typed)] = utf8(synonym.word);
        return all;
    }();
    QStringList words = text.split(u' ');
    for (QString& word : words)
        word = known.value(word.toLower(), word);
    return words.join(u' ');
}

} // namespace app

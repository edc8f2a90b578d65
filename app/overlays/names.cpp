// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"

namespace app {

using clipping::Edge;

QString edgeName(Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> names{
        QT_TRANSLATE_NOOP("Text", "none"), QT_TRANSLATE_NOOP("Text", "left"),
        QT_TRANSLATE_NOOP("Text", "right"), QT_TRANSLATE_NOOP("Text", "bottom"),
        QT_TRANSLATE_NOOP("Text", "top")};
    return Text::tr(names[seenEdge(edge, y)]);
}

QString edgeLetter(Edge edge, YAxis y)
{
    static constexpr std::array<const char*, 5> letters{"", "L", "R", "B", "T"};
    return QString::fromLatin1(letters[seenEdge(edge, y)]);
}

QString endName(bool ofB) { return ofB ? Text::tr("End 2") : Text::tr("End 1"); }

QString pointAtALine() { return Text::tr("Point at a line, select one or draw one."); }

} // namespace app

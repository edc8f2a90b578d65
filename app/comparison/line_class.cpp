// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/line_class.h"

#include "app/base/text.h"
#include "clipping/algorithm.h"
#include "clipping/outcode.h"

#include <array>

namespace app {

LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window, bool visible)
{
    const unsigned a = clipping::outcodeOf(line.a, window), b = clipping::outcodeOf(line.b, window);
    return (a | b) == 0   ? LineClass::Inside
           : (a & b) != 0 ? LineClass::Rejected
           : visible      ? LineClass::Cut
                          : LineClass::Missed;
}

LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window)
{
    static const auto* const exact = &clipping::exactAlgorithm();
    return lineClassOf(line, window, exact->corrected.clip(line, window).has_value());
}

QString classText(LineClass lineClass)
{
    switch (lineClass) {
    case LineClass::Inside:
        return Text::tr("wholly inside");
    case LineClass::Rejected:
        return Text::tr("rejected at once");
    case LineClass::Cut:
        return Text::tr("cut");
    case LineClass::Missed:
        return Text::tr("misses the window");
    }
    return {};
}

QString outcodeText(unsigned code)
{
    return QStringLiteral("%1%2%3%4")
        .arg(code >> 3 & 1U)
        .arg(code >> 2 & 1U)
        .arg(code >> 1 & 1U)
        .arg(code & 1U);
}

QString regionText(unsigned code, YAxis y)
{
    static constexpr std::array<std::array<const char*, 3>, 3> names{
        {{QT_TRANSLATE_NOOP("Text", "below left"), QT_TRANSLATE_NOOP("Text", "below"),
          QT_TRANSLATE_NOOP("Text", "below right")},
         {QT_TRANSLATE_NOOP("Text", "left"), QT_TRANSLATE_NOOP("Text", "inside"),
          QT_TRANSLATE_NOOP("Text", "right")},
         {QT_TRANSLATE_NOOP("Text", "above left"), QT_TRANSLATE_NOOP("Text", "above"),
          QT_TRANSLATE_NOOP("Text", "above right")}}};
    const unsigned high = y == YAxis::Up ? code >> 3 & 1U : code >> 2 & 1U;
    const unsigned low = y == YAxis::Up ? code >> 2 & 1U : code >> 3 & 1U;
    return Text::tr(names.at(1 + high - low).at(1 + (code >> 1 & 1U) - (code & 1U)));
}

QString outcodeBits() { return QStringLiteral("y > ymax, y < ymin, x > xmax, x < xmin"); }

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/line_class.h"

#include "app/base/text.h"
#include "clipping/algorithm.h"
#include "clipping/outcode.h"

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

} // namespace app

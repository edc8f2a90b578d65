// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/line_class.h"

#include "clipping/algorithm.h"
#include "clipping/outcode.h"

#include <QCoreApplication>

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

QString words(LineClass lineClass)
{
    struct Words {
        Q_DECLARE_TR_FUNCTIONS(inspection)
    };
    switch (lineClass) {
    case LineClass::Inside:
        return Words::tr("wholly inside");
    case LineClass::Rejected:
        return Words::tr("rejected at once");
    case LineClass::Cut:
        return Words::tr("cut");
    case LineClass::Missed:
        return Words::tr("misses the window");
    }
    return {};
}

} // namespace app

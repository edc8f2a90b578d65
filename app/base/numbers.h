// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"

#include <QString>

#include <glm/vec2.hpp>

// Numbers as people read them, in the words of the default QLocale: groups of three, a real minus,
// the unit after a space. Files and the command line never use these (app/base/number.h).

namespace app {

/// "1,234.50", "−3.00"; what rounds to zero has no sign.
QString numberText(double value, int decimals);
QString countText(std::size_t count);

/// A length of the drawing in another unit. `millimetresPerUnit` is the page's; in Unit::User the
/// number stays as it is.
double inUnit(double userUnits, Unit unit, double millimetresPerUnit);
/// The way back.
double fromUnit(double value, Unit unit, double millimetresPerUnit);

/// "210.00": with the unit's usual decimals, or `more` of them.
QString lengthNumber(double userUnits, Unit unit, double millimetresPerUnit, int more = 0);
/// "210.00 mm".
QString lengthText(double userUnits, Unit unit, double millimetresPerUnit);
/// "210.00 × 168.00 mm".
QString sizeText(const glm::dvec2& size, Unit unit, double millimetresPerUnit);

/// "0.42 ms": 2 decimals under 10, 1 under 100, none above; "< 0.01 ms".
QString millisecondsText(double milliseconds);
/// "71.7 %".
QString percentText(double share);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/base/progress.h"

#include <QString>

#include <glm/vec2.hpp>

// Numbers as people read them, in the words of the default QLocale: groups of three digits, a true
// minus sign, the unit after a space. Files and the command line use app/base/number.h instead.

namespace app {

/// "1,234.50", "−3.00"; a number that rounds to zero has no sign. A half is rounded away from zero,
/// and so is what is less than a half by rounding errors only (1e-7 of the last decimal).
QString numberText(double value, int decimals);
QString countText(std::size_t count);
/// "0.1875", "−1.5e−7": that many significant digits, without zeros at the end.
QString shortText(double value, int digits = 6);
/// The shortest text that reads back as the number: "−9.0625".
QString exactText(double value);
/// "1 line", "1,234 lines".
QString linesText(std::size_t count);

/// Converts a length of the drawing to `unit`. `millimetresPerUnit` is the size of a user unit.
/// Unit::User leaves the number unchanged.
double inUnit(double userUnits, Unit unit, double millimetresPerUnit);
/// The inverse of inUnit().
double fromUnit(double value, Unit unit, double millimetresPerUnit);

/// "12 mm"; the unit follows a space that is not broken.
QString withUnit(const QString& number, Unit unit);
/// "210.00": with the unit's usual number of decimals, plus `more`.
QString lengthNumber(double userUnits, Unit unit, double millimetresPerUnit, int more = 0);
/// "210.00 mm".
QString lengthText(double userUnits, Unit unit, double millimetresPerUnit);
/// "210.00 × 168.00 mm".
QString sizeText(const glm::dvec2& size, Unit unit, double millimetresPerUnit);

/// "0.42 ms": 2 decimals under 10, 1 under 100, none above; "< 0.01 ms" for less.
QString millisecondsText(double milliseconds);
QString lateText(double milliseconds); ///< "1.2 s late"
/// "71.7 %".
QString percentText(double share);

/// "12 s", "3 minutes", "2 hours": rounded up below two minutes, else to the nearest.
QString durationText(double seconds);

/// "42 %, 12 s left"; only the share while the remaining time is unknown.
QString progressText(const Progress& progress);

} // namespace app

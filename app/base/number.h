// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/expression.h"

#include <QLocale>
#include <QString>

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// Appends the shortest decimal text that reads back bit for bit, without an exponent; -0 is "0".
/// All numbers in files are written by these functions. `number` must be finite.
void appendNumber(std::string& text, double number);
/// That text alone.
QString shortestText(double number);

/// Appends with at most `precision` decimals (no trailing zeros): rounds to nearest, then moves by
/// whole units of the last decimal until low <= written value <= high, if any such decimal exists.
void appendNumber(std::string& text, double number, int precision, double low, double high);

/// Parses a finite number in the C locale, exponents allowed. Empty unless the whole text is such a
/// number.
std::optional<double> parseNumber(std::string_view text);

/// Numbers as people type them, in the C locale: minus and multiplication signs are ASCII, the
/// locale's decimal point is ".", its group separators are gone.
QString inCLocale(QString text, const QLocale& locale);

/// evaluated() for text as people type it.
Result<double> typedLength(const QString& text, const Scale& scale, const QLocale& locale = {});

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <optional>

namespace app {

/// A line as a person types it: "−160, −30 → 70, 130"; exact, so that it reads back bit for bit. If
/// the decimal mark is a comma, a semicolon separates x from y.
QString lineText(const clipping::Segment& line);

/// A point: "(−0.5, 3)"; "(−0,5; 3)" if the decimal mark is a comma.
QString pairText(const QString& x, const QString& y);

/// Four numbers, separated by any mixture of commas, semicolons and spaces, as in "-160,-30
/// 70,130"; between the ends an arrow ("->" or "→") or "to" is allowed. The decimal mark is a
/// point, or that of the locale. "nan" and "inf" are accepted as numbers. Empty if the text is not
/// a line.
std::optional<clipping::Segment> lineFrom(const QString& text);

} // namespace app

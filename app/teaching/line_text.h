// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <optional>

namespace app {

/// A line as it is typed: "−160, −30 → 70, 130"; exact, so that it reads back bit for bit. Where
/// the decimal mark is a comma, a semicolon parts x from y.
QString lineText(const clipping::Segment& line);

/// A point: "(−0.5, 3)"; "(−0,5; 3)" where the decimal mark is a comma.
QString pairText(const QString& x, const QString& y);

/// Four numbers, parted by commas, semicolons or spaces in any mixture, as in "-160,-30 70,130";
/// between the ends there may be an arrow ("->" or "→") or "to". The decimal mark is a point, or
/// that of the locale. "nan" and "inf" are numbers too. Nothing: it is no line.
std::optional<clipping::Segment> lineFrom(const QString& text);

} // namespace app

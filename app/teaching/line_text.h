// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"
#include "clipping/geometry.h"

#include <QString>
#include <QUrl>

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

/// The traced line of a link in a page, y up:
/// `clearcut:trace?a=KEY&line=X1,Y1,X2,Y2&w=XMIN,YMIN,XMAX,YMAX`, as on the command line; KEY is
/// that of an algorithm, with `:published` for the published form, or of a known misprint. Empty
/// for any other link.
std::optional<TracedLine> tracedLineOf(const QUrl& link);

/// Such a link, bit for bit. Empty if a number is not finite.
std::optional<QString> traceLink(const TracedLine& tracedLine);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QUrl>

namespace app {

/// The traced line of a link in a page, y up:
/// `clearcut:trace?a=KEY&line=X1,Y1,X2,Y2&w=XMIN,YMIN,XMAX,YMAX`, as on the command line; KEY is
/// that of an algorithm, with `:published` for the published form. Empty for any other link.
std::optional<TracedLine> tracedLineOf(const QUrl& link);

/// Such a link, bit for bit. Empty if a number is not finite, and for a known misprint, which has
/// no steps.
std::optional<QString> traceLink(const TracedLine& tracedLine);

} // namespace app

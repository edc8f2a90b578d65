// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

namespace app {

/// The page of an algorithm as people read it: its markdown without comments, followed by the hard
/// cases at which its published form fails, with links to the gallery (`clearcut:case/KEY`,
/// `clearcut:fails/VARIANT`).
QString readingOf(const clipping::Algorithm& algorithm);

/// The algorithm whose page a link names: "skala.md"; null for other links.
const clipping::Algorithm* algorithmOfPage(const QString& link);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app {

/// That positions of a map lie outside the square in which its projection draws the globe, so that
/// their degrees are no place that it draws. Empty: none does, or the format has no projection.
/// `document`: as it is written.
QStringList outsideMap(const Document& document, const Format& format, const WriteOptions& options);

} // namespace app

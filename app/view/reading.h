// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

#include <QString>

namespace app {

/// The unit in which a page's drawing is read: that of its width, pixels where it has none.
Unit unitOf(const Page& page);

/// How many of `unit` a user unit of the page is.
double unitsPerUserUnit(const Page& page, Unit unit);

/// A length in user units as people read it: the locale's digits and groups, a real minus, the
/// unit's usual number of decimals and `moreDecimals`; without the unit's name.
QString reading(double userUnits, const Page& page, Unit unit, int moreDecimals = 0);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// Removes what filled shapes cover, for plotters and other machines that draw lines alone: each
/// line is cut outside all areas above it, with exact decisions, and then the fills are removed. So
/// a filled shape without a stroke only hides what is below it, and is gone.
///
/// An area covers if its fill is opaque, whatever its colour; open paths are filled as if closed.
/// It does not cover its own lines. A line along the border of an area above it is covered. Stroke
/// widths do not count: centre lines are cut, as by windows. Hidden objects cover nothing and stay
/// as they are.
///
/// Of the options, `region`, `clipAll`, `keepContacts` and `closeAreas` do not count. Locked
/// objects always cover. In the counts, `whole` includes objects that lost only their fill.
///
/// Thousands of areas on one another take minutes. When a stop is requested, it returns within a
/// tenth of a second, and the result is of no use.
Cut occlude(const Document& document, const CutOptions& options, const Follower& follower = {});

} // namespace app

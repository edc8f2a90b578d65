// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/cost_map.h"

namespace app {

/// "NLN", or for a tie "NLN = SB".
QString namesOf(const CostPlan& plan, std::uint32_t cheapest);

/// "MD: operations by where End 2 lies", "Which is cheapest: operations by where End 2 lies".
QString titleOf(const CostPlan& plan);

/// The cost of the line to `end`: "32 operations here; cheapest: NLN 18", or "Cheapest here: NLN
/// 18".
QString costWords(const CostPlan& plan, const Point& end);

/// The positions of the fixed end and the clip window, in user units: a sentence.
QString placesOf(const CostPlan& plan);

/// What is counted, or how time is measured: sentences. Empty where the measure's name says it.
QString noteOf(const CostMeasure& measure);

} // namespace app

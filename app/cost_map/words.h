// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/cost_map.h"

#include <QCoreApplication>

namespace app {

/// The context of what cost maps say.
struct CostMaps {
    Q_DECLARE_TR_FUNCTIONS(CostMaps)
};

/// "NLN", or of a tie "NLN = SB".
QString namesOf(const CostPlan& plan, std::uint32_t cheapest);

/// "MD: operations for each place of End 2", "Fewest operations for each place of End 2".
QString titleOf(const CostPlan& plan);

/// Of a line that ends there: "32 operations here; cheapest: NLN 18", or "NLN 18 operations is the
/// cheapest here, MD 32 the dearest".
QString costWords(const CostPlan& plan, const Point& end);

/// Where the fixed end and the clip window are, in user units: a sentence.
QString placesOf(const CostPlan& plan);

/// What is counted, or how it is timed: sentences. Empty where the measure's name says it.
QString noteOf(const CostMeasure& measure);

} // namespace app

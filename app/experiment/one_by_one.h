// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/record.h"

namespace app {

// `exact` clips many lines at once, with the processor's vectors. The other algorithms clip one
// line after another. To compare like with like, experiments time `exact` in both ways.

/// The row `exact`, called line by line. It is of experiments alone, not of the catalogue.
const clipping::Algorithm& exactOneByOne();

/// The row that a table of an experiment names, by key or as the paper does; null if there is none.
const clipping::Algorithm* timedAlgorithm(const QString& name);

/// These, with exactOneByOne after `exact` where it takes part.
std::vector<Variant> withOneByOne(std::span<const Variant> variants);

/// These without exactOneByOne: for what does not depend on how lines are called.
std::vector<Variant> withoutOneByOne(std::span<const Variant> variants);

/// One sentence for a table or chart with these in it; empty where `exact` takes no part.
QString batchText(std::span<const Variant> variants);

/// The same for a record, with both times where it has them.
QString batchText(const Record& record);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

// `exact` clips many lines at once, with the processor's vectors. The other algorithms clip one
// line after another. To compare like with like, experiments time `exact` in both ways.

/// The algorithm `exact`, called line by line. It is only for experiments, not in the catalogue.
const clipping::Algorithm& exactOneByOne();

/// The algorithm that a table of an experiment names, by key or as in the paper; null if unknown.
const clipping::Algorithm* timedAlgorithm(const QString& name);

/// These variants, with exactOneByOne inserted after `exact` if `exact` is among them.
std::vector<Variant> withOneByOne(std::span<const Variant> variants);

/// These variants without exactOneByOne: for results that do not depend on batches.
std::vector<Variant> withoutOneByOne(std::span<const Variant> variants);

/// One sentence for a table or chart of these variants; empty without `exact`.
QString batchText(std::span<const Variant> variants);

} // namespace app

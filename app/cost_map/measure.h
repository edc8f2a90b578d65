// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/counted.h"

#include <QString>

#include <span>
#include <string_view>

namespace app {

/// One row of the catalogue of costs of a line.
struct CostMeasure {
    std::string_view key; ///< on the command line and in files: "divisions"
    QString name;         ///< translated: "Divisions"
    QString one, many;    ///< "1 division", "%1 divisions"
    std::uint64_t (*of)(const clipping::OperationCounts& counts); ///< null: time, in nanoseconds

    bool isTime() const { return of == nullptr; }
};

/// Every measure, in menu order; the first is all operations (`promisedOf`).
std::span<const CostMeasure> costMeasures();

/// "32 operations", "1 division", "23.9 ns".
QString costText(const CostMeasure& measure, double cost);

} // namespace app

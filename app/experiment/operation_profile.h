// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/promised_operations.h"
#include "app/experiment/class_lines.h"
#include "app/experiment/record.h"

namespace app {

/// The operation counts of one variant.
struct VariantOperations {
    Variant variant;
    std::array<clipping::OperationCounts, lineClasses.size()> byClass; ///< of all lines of a class
    clipping::OperationCounts scene() const;                           ///< of all lines
};

/// The operation counts that the paper's abstract announces and the paper does not give.
struct OperationProfile {
    ExperimentOptions options;                           ///< scene, field, lines and seed
    std::array<std::uint64_t, lineClasses.size()> mix{}; ///< lines of each class
    std::vector<VariantOperations> rows;
};

/// The counts are exact, so one run is enough; a million lines and 15 variants take some seconds.
/// Empty if it was stopped.
std::optional<OperationProfile> operationProfile(const ExperimentOptions& options,
                                                 std::span<const Variant> variants,
                                                 const Follower& follower = {});

/// A row for each variant and class, and one for the scene: operations per line.
Table operationTable(const OperationProfile& profile);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/promised_operations.h"
#include "app/experiment/class_lines.h"
#include "app/experiment/record.h"

namespace app {

/// The arithmetic of one variant.
struct VariantOperations {
    Variant variant;
    std::array<clipping::OperationCounts, lineClasses.size()> byClass; ///< of all lines of a class
    clipping::OperationCounts scene() const;                           ///< of all lines
};

/// What the paper's abstract promises and the paper never shows.
struct OperationProfile {
    ExperimentOptions options;                           ///< scene, field, lines and seed
    std::array<std::uint64_t, lineClasses.size()> mix{}; ///< lines of each class
    std::vector<VariantOperations> rows;
};

/// Counts exactly, so once is enough; a million lines and 15 variants take some seconds.
/// Nothing if it was stopped.
std::optional<OperationProfile> operationProfile(const ExperimentOptions& options,
                                                 std::span<const Variant> variants,
                                                 const Follower& follower = {});

/// One row a variant and class, and one for the scene: operations a line.
Table operationTable(const OperationProfile& profile);

} // namespace app

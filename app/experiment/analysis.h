// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/record.h"

namespace app {

/// One row of the catalogue of what can be told of variants and a scene beside their times.
struct Analysis {
    QString key;     ///< "operations"
    QString name;    ///< translated, as is what follows
    QString meaning; ///< one sentence
    /// Nothing if it was stopped.
    std::optional<Table> (*table)(const ExperimentOptions& options,
                                  std::span<const Variant> variants, const Follower& follower);
};
std::vector<Analysis> analyses();

} // namespace app

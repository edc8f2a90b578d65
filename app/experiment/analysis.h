// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/record.h"

namespace app {

/// One row of the catalogue of analyses of variants on a scene, other than their times.
struct Analysis {
    QString key;     ///< "operations"
    QString name;    ///< translated, like the next text
    QString meaning; ///< one sentence
    /// Empty if it was stopped.
    std::optional<Table> (*table)(const ExperimentOptions& options,
                                  std::span<const Variant> variants, const Follower& follower);
};
std::vector<Analysis> analyses();

} // namespace app

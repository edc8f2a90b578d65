// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <vector>

namespace app {

/// One form of one algorithm, which it has.
struct Contestant {
    const clipping::Algorithm* algorithm;
    clipping::Form form;
};

/// Every form that these algorithms have, the corrected ones first.
std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms);

struct ExperimentOptions {
    std::uint64_t lines = 1'000'000; ///< at least one
    std::size_t runs = 10;           ///< at least one
    std::uint64_t seed = 1;
};

/// What one contestant needed and found.
struct Timing {
    Contestant contestant;
    std::vector<double> nanoseconds; ///< a line, one number a run
    std::uint64_t visible = 0;       ///< lines

    double median() const;
    double spread() const; ///< between the quartiles
};

/// The paper's experiment: its random lines, all clipped at its window by every contestant in every
/// run. Only the clipping is timed. The lines come in blocks of a million, so that memory stays
/// under 100 MB; the contestants take turns block by block, and who begins changes from run to run,
/// after a first turn that does not count.
std::vector<Timing> experiment(const ExperimentOptions& options,
                               std::span<const Contestant> contestants);

} // namespace app

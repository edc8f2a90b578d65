// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/base/progress.h"
#include "app/base/statistics.h"
#include "app/experiment/block.h"
#include "app/experiment/easel.h"
#include "app/experiment/findings.h"
#include "app/experiment/order.h"

namespace app {

struct ExperimentOptions {
    TestScene scene = testScenes().front();
    Field field{};
    std::uint64_t lines = 1'000'000; ///< at least one
    std::size_t runs = 10;           ///< at least one
    std::size_t warmUps = 1;         ///< whole runs that do not count, at least one
    std::uint64_t seed = 1;
    Order order = Order::AsTheyCome;
    EaselMaker easel = nullptr;              ///< rasterEasel or another; null: nothing is drawn
    Precision precision = Precision::Double; ///< single: corrected forms only
    std::size_t threads = 1;                 ///< for each algorithm; at most mostThreads
    Clock clock = processorClock();          ///< of the wall if there are more threads than one
};

/// What drawing is timed with: the options' clock, unless others draw for the thread.
Clock drawClock(const ExperimentOptions& options, const Easel& easel);

/// What one variant needed and found. Times are nanoseconds a line, one number a run.
struct Timing {
    Variant variant;
    std::vector<double> generate; ///< the same for all variants: the lines are made once for all
    std::vector<double> clip;
    std::vector<double> draw; ///< zeros where nothing is drawn
    Findings found{};
    std::uint64_t pixels = 0; ///< checksum of all that was drawn; 0 where nothing is
};

/// One row of the catalogue of what can be told of a timing.
struct Measure {
    QString key;     ///< "clip"
    QString name;    ///< "Clipping only", translated
    QString meaning; ///< one sentence
    std::vector<double> (*times)(const Timing& timing);
    bool draws; ///< whether it tells nothing without an easel
};

/// Clipping, drawing, and their sum with the making of the lines, which is what the paper timed.
std::vector<Measure> measures();

/// The paper's experiment, made fair: the lines of a scene, all clipped at its window by every
/// variant in every run, and drawn if there is an easel. The lines come in blocks of a million,
/// so that memory stays under 200 MB. The variants take turns block by block, and who begins
/// changes from block to block and from run to run. The first warm-up tells what they find.
/// Nothing if it was stopped.
std::optional<std::vector<Timing>> experiment(const ExperimentOptions& options,
                                              std::span<const Variant> variants,
                                              const Follower& follower = {});

} // namespace app

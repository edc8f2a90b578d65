// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/base/progress.h"
#include "app/base/statistics.h"
#include "app/experiment/block.h"
#include "app/experiment/draw_target.h"
#include "app/experiment/findings.h"
#include "app/experiment/order.h"

namespace app {

struct ExperimentOptions {
    TestScene scene = testScenes().front();
    Field field{};
    std::uint64_t lines = 1'000'000; ///< at least one
    std::size_t runs = 10;           ///< at least one
    std::size_t firstRun = 0;        ///< the number of the first counted run, if others are made
    std::size_t warmUps = 1;         ///< whole runs that are not counted, at least one
    std::uint64_t seed = 1;          ///< of the first counted run; each further run has the next
    Order order = Order::AsTheyCome;
    DrawTargetMaker target = nullptr;        ///< makes the draw target; null: nothing is drawn
    Precision precision = Precision::Double; ///< single: corrected forms only
    std::size_t threads = 1;                 ///< for each algorithm; at most mostThreads
    Clock clock = processorClock();          ///< the wall clock if there are several threads
    bool inProcesses = false;                ///< each run was made by a process of its own
    bool sameLines = false;                  ///< in all runs, for who compares their results
};

/// The clock for drawing: that of the options, or the wall clock if the draw target draws
/// elsewhere.
Clock drawClock(const ExperimentOptions& options, const DrawTarget& target);

/// What one variant needed and found. Times are nanoseconds per line, one number per run.
struct Timing {
    Variant variant;
    std::vector<double> generate; ///< the same for all variants: the lines are made only once
    std::vector<double> clip;
    std::vector<double> draw; ///< zeros if nothing is drawn
    Findings found{};
    std::uint64_t pixels = 0;             ///< checksum of everything drawn; 0 if nothing is drawn
    std::vector<std::uint64_t> visible{}; ///< the number of visible lines, one number per run
};

/// One row of the catalogue of measures of a timing.
struct Measure {
    QString key;     ///< "clip"
    QString name;    ///< "Clipping only", translated
    QString meaning; ///< one sentence
    std::vector<double> (*times)(const Timing& timing);
    bool draws; ///< whether it needs a draw target
};

/// Clipping, drawing, and the sum of generation, clipping and drawing, which the paper timed.
std::vector<Measure> measures();

/// The paper's experiment, made fair: all lines of a scene are clipped at its window by every
/// variant in every run, and drawn if there is a draw target. The lines come in blocks of a
/// million, so that memory stays under 200 MB. The variants take turns block by block, and the
/// first variant changes from block to block and from run to run. Each counted run of a scene of
/// random lines has lines of its own, so that the spread of the times covers other lines, too. The
/// first warm-up has the lines of the first counted run, and provides the findings. Empty if it was
/// stopped.
std::optional<std::vector<Timing>> experiment(const ExperimentOptions& options,
                                              std::span<const Variant> variants,
                                              const Follower& follower = {});

} // namespace app

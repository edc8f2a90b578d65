// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/experiment.h"

#include "app/experiment/paper_scene.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

namespace app {
namespace {

constexpr std::uint64_t blockSize = 1'000'000;

/// The lines that are clipped, and where what is visible goes.
struct Block {
    std::vector<clipping::Segment> lines;
    std::vector<clipping::Clipped> visible;
};

/// What a contestant found in one run.
struct Turn {
    double nanoseconds = 0;
    std::uint64_t visible = 0;
};

void clip(const Contestant& contestant, std::span<const clipping::Segment> lines, Block& block,
          Turn& turn)
{
    const auto& uses = *clipping::usesOf(*contestant.algorithm, contestant.form);
    const auto start = std::chrono::steady_clock::now();
    turn.visible += uses.clipAll(lines, paperWindow, block.visible);
    turn.nanoseconds +=
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Turn> run(std::uint64_t lines, std::uint64_t seed, std::size_t first, Block& block,
                      std::span<const Contestant> contestants)
{
    std::vector<Turn> turns(contestants.size());
    PaperScene scene(seed);
    for (std::uint64_t done = 0; done < lines; done += blockSize) {
        const auto some = std::span(block.lines).first(std::min(blockSize, lines - done));
        scene.fill(some);
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const std::size_t who = (first + i) % turns.size();
            clip(contestants[who], some, block, turns[who]);
        }
    }
    return turns;
}

// Between the sorted numbers, as spreadsheets do it.
double quantile(std::vector<double> numbers, double share)
{
    std::ranges::sort(numbers);
    const double position = share * double(numbers.size() - 1);
    const auto below = std::size_t(position);
    const std::size_t above = std::min(below + 1, numbers.size() - 1);
    return std::lerp(numbers[below], numbers[above], position - double(below));
}

} // namespace

std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms)
{
    std::vector<Contestant> all;
    for (const auto form : {clipping::Form::Corrected, clipping::Form::Published})
        for (const auto* algorithm : algorithms)
            if (clipping::usesOf(*algorithm, form))
                all.push_back({algorithm, form});
    return all;
}

double Timing::median() const { return quantile(nanoseconds, 0.5); }
double Timing::spread() const { return quantile(nanoseconds, 0.75) - quantile(nanoseconds, 0.25); }

std::vector<Timing> experiment(const ExperimentOptions& options,
                               std::span<const Contestant> contestants)
{
    assert(options.lines > 0 && options.runs > 0);
    std::vector<Timing> timings;
    for (const Contestant& contestant : contestants)
        timings.push_back({contestant, {}, 0});
    const std::uint64_t most = std::min(blockSize, options.lines);
    Block block{std::vector<clipping::Segment>(most), std::vector<clipping::Clipped>(most)};
    run(most, options.seed, 0, block, contestants);
    for (std::size_t r = 0; r < options.runs; ++r) {
        const auto turns = run(options.lines, options.seed, r, block, contestants);
        for (std::size_t i = 0; i < turns.size(); ++i) {
            timings[i].nanoseconds.push_back(turns[i].nanoseconds / double(options.lines));
            timings[i].visible = turns[i].visible;
        }
    }
    return timings;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/experiment.h"

#include "app/base/progress.h"
#include "app/base/random.h"
#include "app/base/text.h"
#include "app/base/vector_registers.h"
#include "app/comparison/line_class.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

constexpr std::uint64_t blockSize = 1'000'000;
/// Lines that are generated or drawn between two tests for a stop: some hundredths of a second.
constexpr std::size_t bit = 50'000;

/// A running experiment.
class Bench {
public:
    Bench(const ExperimentOptions& options, std::span<const Variant> variants,
          const Follower& follower);
    /// Run number `r`; warm-ups come before the first counted run. Returns false if it was stopped.
    bool run(std::size_t r);
    std::vector<Timing> take() { return std::move(timings_); }

private:
    void begin();
    void fill(const LineSource& source);
    void make(const LineSource& source, std::span<Segment> lines);
    void shuffle(std::span<Segment> lines) const;
    void sort(std::span<Segment> lines) const;
    void findErrors();
    void turn(Timing& timing);
    double drawn(std::span<const Clipped> lines);
    void find(Timing& timing, std::span<const Clipped> pieces);
    void divide(std::size_t r);

    const ExperimentOptions& options_;
    TurnProgress turns_;
    Block block_;
    std::uint64_t first_ = 0;          ///< the number of the block's first line in the scene
    std::vector<Clipped> exactPieces_; ///< the exact pieces of the block, while findings are made
    std::unique_ptr<DrawTarget> target_;
    Clock drawClock_;
    std::vector<Timing> timings_;
    bool finding_ = false;
};

std::uint64_t blocksOf(std::uint64_t lines) { return (lines + blockSize - 1) / blockSize; }

Bench::Bench(const ExperimentOptions& options, std::span<const Variant> variants,
             const Follower& follower)
    : options_(options),
      turns_(follower,
             double((options.warmUps + options.runs) * blocksOf(options.lines) * variants.size())),
      block_({options.field.window, options.precision, options.threads, options.field.shape}),
      target_(options.target ? options.target(options.field) : nullptr),
      drawClock_(target_ ? drawClock(options, *target_) : options.clock)
{
    for (const Variant& variant : variants)
        timings_.push_back({.variant = variant, .generate = {}, .clip = {}, .draw = {}});
}

bool Bench::run(std::size_t r)
{
    finding_ = r == 0;
    begin();
    const std::uint64_t counted = r < options_.warmUps ? 0 : r - options_.warmUps;
    const std::uint64_t further = options_.sameLines ? 0 : options_.firstRun + counted;
    const LineSource source = options_.scene.begin(options_.field, options_.seed + further);
    for (first_ = 0; first_ < options_.lines; first_ += blockSize) {
        fill(source);
        for (std::size_t i = 0; i < timings_.size(); ++i) {
            if (turns_.stopped())
                return false;
            turn(timings_[(r + options_.firstRun + first_ / blockSize + i) % timings_.size()]);
            turns_.turnDone();
        }
    }
    if (turns_.stopped()) // during the last turn
        return false;
    divide(r);
    return true;
}

void Bench::begin()
{
    for (Timing& timing : timings_) {
        for (auto* times : {&timing.generate, &timing.clip, &timing.draw})
            times->push_back(0);
        timing.visible.push_back(0);
    }
}

void Bench::fill(const LineSource& source)
{
    block_.refill(std::min(blockSize, options_.lines - first_),
                  [&](std::span<Segment> lines) { make(source, lines); });
    if (finding_ && !turns_.stopped())
        findErrors();
}

void Bench::make(const LineSource& source, std::span<Segment> lines)
{
    const double start = options_.clock.nanoseconds();
    for (std::size_t at = 0; at < lines.size() && !turns_.stopped(); at += bit)
        source(lines.subspan(at, std::min(bit, lines.size() - at)));
    const double took = options_.clock.nanoseconds() - start;
    for (Timing& timing : timings_)
        timing.generate.back() += took;
    if (options_.order == Order::ByClass)
        sort(lines);
    else if (options_.order == Order::Shuffled)
        shuffle(lines);
}

/// The same order on every machine and in every run.
void Bench::shuffle(std::span<Segment> lines) const
{
    Random random(options_.seed);
    for (std::size_t left = lines.size(); left > 1 && !turns_.stopped(); --left)
        std::swap(lines[left - 1], lines[std::size_t(random.between(0, double(left)))]);
}

/// Groups the lines by their class; lines of the same class keep the generated order.
void Bench::sort(std::span<Segment> lines) const
{
    std::array<std::vector<Segment>, lineClasses.size()> classes;
    for (std::size_t at = 0; at < lines.size() && !turns_.stopped(); at += bit)
        for (const Segment& line : lines.subspan(at, std::min(bit, lines.size() - at)))
            classes[std::size_t(lineClassOf(line, options_.field.window))].push_back(line);
    auto to = lines.begin();
    for (const auto& some : classes)
        to = std::ranges::copy(some, to).out;
}

void Bench::findErrors()
{
    if (options_.field.shape) {
        const auto pieces = block_.pieces(block_.clip({&clipping::exactAlgorithm()}));
        exactPieces_.assign(pieces.begin(), pieces.end());
        return;
    }
    exactPieces_.resize(block_.lines().size());
    exactPieces_.resize(clipping::exactAlgorithm().corrected.clipAll(
        block_.lines(), block_.window(), exactPieces_));
}

void Bench::turn(Timing& timing)
{
    emptyUpperHalves();
    const double start = options_.clock.nanoseconds();
    const std::size_t visible = block_.clip(timing.variant);
    timing.clip.back() += options_.clock.nanoseconds() - start;
    timing.visible.back() += visible;
    const auto pieces = block_.pieces(visible);
    if (target_) {
        target_->wipe();
        timing.draw.back() += drawn(pieces);
    }
    if (finding_)
        find(timing, pieces);
}

/// Draws the lines and returns the nanoseconds.
double Bench::drawn(std::span<const Clipped> lines)
{
    const double start = drawClock_.nanoseconds();
    for (; !lines.empty() && !turns_.stopped(); lines = lines.subspan(std::min(bit, lines.size())))
        target_->draw(lines.first(std::min(bit, lines.size())));
    return drawClock_.nanoseconds() - start;
}

void Bench::find(Timing& timing, std::span<const Clipped> pieces)
{
    timing.found = added(timing.found, pieces, exactPieces_, block_.window(), first_);
    if (target_)
        timing.pixels = mixed(timing.pixels ^ target_->checksum());
}

void Bench::divide(std::size_t r)
{
    for (Timing& timing : timings_) {
        for (auto* times : {&timing.generate, &timing.clip, &timing.draw}) {
            times->back() /= double(options_.lines);
            if (r < options_.warmUps)
                times->pop_back();
        }
        if (r < options_.warmUps)
            timing.visible.pop_back();
    }
    exactPieces_ = {};
}

} // namespace

Clock drawClock(const ExperimentOptions& options, const DrawTarget& target)
{
    return target.drawsElsewhere() ? wallClock() : options.clock;
}

std::vector<Measure> measures()
{
    return {
        {"clip", Text::tr("Clipping only"), Text::tr("The time of the algorithm itself."),
         [](const Timing& timing) { return timing.clip; }, false},
        {"draw", Text::tr("Drawing only"), Text::tr("The time of drawing the visible parts."),
         [](const Timing& timing) { return timing.draw; }, true},
        {"total", Text::tr("Total"),
         Text::tr("Generating, clipping and drawing the lines together, as the paper timed them."),
         [](const Timing& timing) {
             std::vector<double> times = timing.generate;
             for (std::size_t i = 0; i < times.size(); ++i)
                 times[i] += timing.clip[i] + timing.draw[i];
             return times;
         },
         true},
    };
}

std::optional<std::vector<Timing>> experiment(const ExperimentOptions& options,
                                              std::span<const Variant> variants,
                                              const Follower& follower)
{
    assert(options.lines > 0 && options.runs > 0 && options.warmUps > 0);
    Bench bench(options, variants, follower);
    for (std::size_t r = 0; r < options.warmUps + options.runs; ++r)
        if (!bench.run(r))
            return std::nullopt;
    return bench.take();
}

} // namespace app

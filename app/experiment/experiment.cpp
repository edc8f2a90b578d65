// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/experiment.h"

#include "app/comparison/line_class.h"
#include "app/experiment/checksum.h"
#include "app/experiment/pace.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <ctime>

namespace app {
namespace {

using clipping::Clipped;
using clipping::Segment;

struct Experiments {
    Q_DECLARE_TR_FUNCTIONS(Experiments)
};

constexpr std::uint64_t blockSize = 1'000'000;
/// What is made or drawn between two looks at whether to stop: some hundredths of a second.
constexpr std::size_t bit = 50'000;

/// The lines that are clipped, and where what is visible goes.
struct Block {
    std::uint64_t first = 0; ///< the number of its first line in the scene
    std::vector<Segment> lines;
    std::vector<Clipped> visible;
    std::vector<Clipped> truth; ///< what is truly visible, while findings are made
};

/// The experiment while it goes on.
class Bench {
public:
    Bench(const ExperimentOptions& options, std::span<const Contestant> contestants,
          const Follower& follower);
    /// Run number `r`, the warm-ups before the first that counts. False if it was stopped.
    bool run(std::size_t r);
    std::vector<Timing> take() { return std::move(timings_); }

private:
    void begin();
    void fill(const LineSource& source, std::uint64_t first);
    void order();
    void tellTruth();
    void turn(Timing& timing);
    double drawn(std::span<const Clipped> lines);
    void find(Timing& timing, std::size_t visible);
    void divide(std::size_t r);

    const ExperimentOptions& options_;
    Pace pace_;
    Block block_;
    std::unique_ptr<Easel> easel_;
    std::vector<Timing> timings_;
    bool finding_ = false;
};

std::uint64_t blocksOf(std::uint64_t lines) { return (lines + blockSize - 1) / blockSize; }

Bench::Bench(const ExperimentOptions& options, std::span<const Contestant> contestants,
             const Follower& follower)
    : options_(options), pace_(follower, double((options.warmUps + options.runs)
                                                * blocksOf(options.lines) * contestants.size())),
      easel_(options.easel ? options.easel(options.field) : nullptr)
{
    for (const Contestant& contestant : contestants)
        timings_.push_back({.contestant = contestant, .generate = {}, .clip = {}, .draw = {}});
}

bool Bench::run(std::size_t r)
{
    finding_ = r == 0;
    begin();
    const LineSource source = options_.scene.begin(options_.field, options_.seed);
    for (std::uint64_t first = 0; first < options_.lines; first += blockSize) {
        fill(source, first);
        for (std::size_t i = 0; i < timings_.size(); ++i) {
            if (pace_.stopped())
                return false;
            turn(timings_[(r + first / blockSize + i) % timings_.size()]);
            pace_.turnDone();
        }
    }
    if (pace_.stopped()) // in the middle of the last turn
        return false;
    divide(r);
    return true;
}

void Bench::begin()
{
    for (Timing& timing : timings_)
        for (auto* times : {&timing.generate, &timing.clip, &timing.draw})
            times->push_back(0);
}

void Bench::fill(const LineSource& source, std::uint64_t first)
{
    block_.first = first;
    block_.lines.resize(std::min(blockSize, options_.lines - first));
    block_.visible.resize(block_.lines.size());
    const double start = options_.clock.nanoseconds();
    for (std::size_t at = 0; at < block_.lines.size() && !pace_.stopped(); at += bit)
        source(std::span(block_.lines).subspan(at, std::min(bit, block_.lines.size() - at)));
    const double took = options_.clock.nanoseconds() - start;
    for (Timing& timing : timings_)
        timing.generate.back() += took;
    if (options_.order == Order::ByClass)
        order();
    if (finding_)
        tellTruth();
}

/// As they came, class by class.
void Bench::order()
{
    std::array<std::vector<Segment>, lineClasses.size()> classes;
    for (const Segment& line : block_.lines)
        classes[std::size_t(lineClassOf(line, options_.field.window))].push_back(line);
    auto to = block_.lines.begin();
    for (const auto& lines : classes)
        to = std::ranges::copy(lines, to).out;
}

void Bench::tellTruth()
{
    block_.truth.resize(block_.lines.size());
    block_.truth.resize(clipping::exactAlgorithm().corrected.clipAll(
        block_.lines, options_.field.window, block_.truth));
}

void Bench::turn(Timing& timing)
{
    const auto& uses = *clipping::usesOf(*timing.contestant.algorithm, timing.contestant.form);
    const double start = options_.clock.nanoseconds();
    const std::size_t visible = uses.clipAll(block_.lines, options_.field.window, block_.visible);
    timing.clip.back() += options_.clock.nanoseconds() - start;
    if (easel_) {
        easel_->wipe();
        timing.draw.back() += drawn(std::span(block_.visible).first(visible));
    }
    if (finding_)
        find(timing, visible);
}

/// The nanoseconds that it took.
double Bench::drawn(std::span<const Clipped> lines)
{
    const double start = options_.clock.nanoseconds();
    for (; !lines.empty() && !pace_.stopped(); lines = lines.subspan(std::min(bit, lines.size())))
        easel_->draw(lines.first(std::min(bit, lines.size())));
    return options_.clock.nanoseconds() - start;
}

void Bench::find(Timing& timing, std::size_t visible)
{
    timing.found = added(timing.found, std::span(block_.visible).first(visible), block_.truth,
                         options_.field.window, block_.first);
    if (easel_)
        timing.pixels = mixed(timing.pixels ^ easel_->checksum());
}

void Bench::divide(std::size_t r)
{
    for (Timing& timing : timings_)
        for (auto* times : {&timing.generate, &timing.clip, &timing.draw}) {
            times->back() /= double(options_.lines);
            if (r < options_.warmUps)
                times->pop_back();
        }
    block_.truth = {};
}

} // namespace

std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms,
                                    clipping::Form form)
{
    std::vector<Contestant> all;
    for (const auto* algorithm : algorithms)
        if (clipping::usesOf(*algorithm, form))
            all.push_back({algorithm, form});
    return all;
}

std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms)
{
    auto all = contestants(algorithms, clipping::Form::Corrected);
    const auto published = contestants(algorithms, clipping::Form::Published);
    all.insert(all.end(), published.begin(), published.end());
    return all;
}

Clock wallClock()
{
    return {QStringLiteral("wall"), [] {
                const auto now = std::chrono::steady_clock::now().time_since_epoch();
                return std::chrono::duration<double, std::nano>(now).count();
            }};
}

Clock processorClock()
{
    return {QStringLiteral("processor time of the thread"), [] {
                timespec now{};
                ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
                return double(now.tv_sec) * 1e9 + double(now.tv_nsec);
            }};
}

std::vector<Measure> measures()
{
    return {
        {"clip", Experiments::tr("Clipping only"),
         Experiments::tr("The time of the algorithm itself."),
         [](const Timing& timing) { return timing.clip; }, false},
        {"draw", Experiments::tr("Drawing only"),
         Experiments::tr("The time of drawing what the algorithm left."),
         [](const Timing& timing) { return timing.draw; }, true},
        {"total", Experiments::tr("Total"),
         Experiments::tr("Making the lines, clipping and drawing together, as the paper timed it."),
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
                                              std::span<const Contestant> contestants,
                                              const Follower& follower)
{
    assert(options.lines > 0 && options.runs > 0 && options.warmUps > 0);
    Bench bench(options, contestants, follower);
    for (std::size_t r = 0; r < options.warmUps + options.runs; ++r)
        if (!bench.run(r))
            return std::nullopt;
    return bench.take();
}

} // namespace app

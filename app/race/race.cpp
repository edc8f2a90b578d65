// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/race/race.h"

#include "app/base/vector_registers.h"

#include <algorithm>
#include <cassert>

namespace app {

using clipping::Clipped;

namespace {

// Lines of a step, so that it takes at most some milliseconds even for the slowest variant: when
// they are clipped, and when their operations are counted.
constexpr std::size_t blockSize = 8192, countedAtOnce = 1024;
constexpr std::size_t leastTelling = 6;  // rounds, from which their spread is meaningful

/// At least one block: a race without lines still has rounds.
std::vector<std::span<const clipping::Segment>> blocksOf(const SceneLines& lines)
{
    std::vector<std::span<const clipping::Segment>> blocks;
    for (const SceneLines::Run& run : lines.runs())
        for (auto rest = run.segments; !rest.empty();) {
            const std::size_t size = std::min(rest.size(), blockSize);
            blocks.push_back(rest.first(size));
            rest = rest.subspan(size);
        }
    if (blocks.empty())
        blocks.emplace_back();
    return blocks;
}

std::vector<clipping::Segment> evenly(const SceneLines& lines, std::size_t most)
{
    const std::size_t count = std::min(lines.size(), most);
    std::vector<clipping::Segment> sample(count);
    for (std::size_t i = 0; i < count; ++i)
        sample[i] = lines[i * lines.size() / count];
    return sample;
}

const auto& usesOf(const Variant& variant)
{
    return *clipping::functionsOf(*variant.algorithm, variant.form);
}

} // namespace

std::span<const double> RaceRow::times() const
{
    const std::span all(milliseconds);
    return ofThisFrame < leastTelling ? all : all.last(ofThisFrame);
}

Race::Race(const std::vector<Variant>& variants, Clock clock)
    : clock_(std::move(clock)), nanoseconds_(variants.size())
{
    assert(!variants.empty());
    for (const Variant& variant : variants)
        rows_.push_back({.variant = variant});
}

void Race::begin(const RaceFrame& frame, Purpose purpose)
{
    assert(!racing_);
    if (frame.lines.size() != frame_.lines.size())
        for (RaceRow& row : rows_)
            row.milliseconds.clear();
    if (!frame.sameAs(frame_) || begun_ == 0)
        rounds_ = looks_ = 0;
    frame_ = frame;
    blocks_ = blocksOf(frame_.lines);
    purpose_ = purpose;
    next_ = rows_;
    for (RaceRow& row : next_)
        row.visible = 0;
    std::ranges::fill(nanoseconds_, 0.0);
    found_.resize(frame.lines.size());
    if (judges())
        for (RaceRow& row : next_)
            row.differences = {};
    if (counts()) {
        sample_ = evenly(frame.lines, judges() ? quickSample : thoroughSample);
        for (RaceRow& row : next_)
            row.operations = 0;
    }
    turn_ = 0;
    racing_ = true;
    ++begun_;
}

bool Race::step()
{
    assert(racing_);
    const std::size_t n = rows_.size();
    if (turn_ < n * blocks())
        clip((begun_ + turn_ / blocks()) % n, turn_ % blocks());
    else
        count((turn_ - n * blocks()) % n, (turn_ - n * blocks()) / n);
    racing_ = ++turn_ < turns();
    if (!racing_)
        finish();
    return !racing_;
}

bool Race::counts() const
{
    return purpose_ == Purpose::Findings
           && (looks_ == 0 || (looks_ == 1 && frame_.lines.size() > quickSample));
}

std::size_t Race::turns() const
{
    const std::size_t parts = (sample_.size() + countedAtOnce - 1) / countedAtOnce;
    return rows_.size() * (blocks() + (counts() ? parts : 0));
}

void Race::clip(std::size_t variant, std::size_t block)
{
    RaceRow& row = next_[variant];
    const auto out = std::span(found_).subspan(row.visible);
    const auto& uses = usesOf(row.variant);
    emptyUpperHalves();
    const double start = clock_.nanoseconds();
    const std::size_t visible = uses.clipAll(blocks_[block], frame_.window, out);
    nanoseconds_[variant] += clock_.nanoseconds() - start;
    row.visible += visible;
    if (judges())
        judge(row, block, out.first(visible));
}

// The exact result is recomputed for each variant: `exact` is so fast that storing 40 bytes for
// each visible line would gain little.
void Race::judge(RaceRow& row, std::size_t block, std::span<const Clipped> found)
{
    exactPieces_.resize(blockSize);
    const std::size_t visible =
        clipping::exactAlgorithm().corrected.clipAll(blocks_[block], frame_.window, exactPieces_);
    const DifferenceCounts here = counted(differences(
        blocks_[block], frame_.window, found, std::span(exactPieces_).first(visible),
        {contractUlps(row.variant, exactVariant()), endsOf(row.variant, exactVariant())}));
    row.differences.onlyA += here.onlyA;
    row.differences.onlyB += here.onlyB;
    row.differences.endsApart += here.endsApart;
}

void Race::count(std::size_t variant, std::size_t part)
{
    RaceRow& row = next_[variant];
    const std::size_t first = part * countedAtOnce;
    const auto lines = std::span(sample_).subspan(first);
    const auto c = usesOf(row.variant)
                       .count(lines.first(std::min(lines.size(), countedAtOnce)), frame_.window);
    row.operations += double(c.comparisons + c.additions + c.multiplications + c.divisions)
                      / double(sample_.size());
}

void Race::finish()
{
    ++rounds_;
    looks_ += purpose_ == Purpose::Findings;
    for (std::size_t i = 0; i < next_.size(); ++i) {
        if (purpose_ == Purpose::Times) // all findings belong to one frame
            next_[i].visible = rows_[i].visible;
        auto& times = next_[i].milliseconds;
        if (times.size() == length)
            times.erase(times.begin());
        times.push_back(nanoseconds_[i] * 1e-6);
        next_[i].ofThisFrame = std::min(rounds_, length);
    }
    rows_ = std::move(next_);
}

} // namespace app

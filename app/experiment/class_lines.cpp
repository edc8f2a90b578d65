// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/class_lines.h"

#include "app/base/progress.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::uint64_t block = 50'000;
constexpr std::size_t fewest = 1000;

/// Scenes of a single class, in the order of lineClasses.
constexpr std::array standIns{u"inside", u"rejected", u"crossing", u"near-miss"};

using All = std::array<ClassLines, lineClasses.size()>;

bool isEnough(const All& all, std::size_t most)
{
    return std::ranges::all_of(all,
                               [&](const ClassLines& one) { return one.lines.size() >= most; });
}

std::optional<All> lookedThrough(const TestScene& scene, const Field& field, std::uint64_t seed,
                                 std::size_t most, const Follower& follower)
{
    All all;
    for (std::size_t c = 0; c < all.size(); ++c)
        all[c].lineClass = lineClasses[c];
    const LineSource source = scene.begin(field, seed);
    const std::uint64_t last = scene.lines == 0 ? linesLookedThrough(most) : scene.lines;
    const std::uint64_t blocks = (last + block - 1) / block;
    TurnProgress turns(follower, double(blocks));
    std::vector<clipping::Segment> some;
    std::uint64_t looked = 0;
    while (looked < last && !isEnough(all, most)) {
        if (turns.stopped())
            return std::nullopt;
        some.resize(std::min(block, last - looked));
        source(some);
        looked += some.size();
        for (const clipping::Segment& line : some) {
            ClassLines& one = all[std::size_t(lineClassOf(line, field.window))];
            one.share += 1;
            if (one.lines.size() < most)
                one.lines.push_back(line);
        }
        turns.turnDone();
    }
    for (ClassLines& one : all)
        one.share /= double(looked);
    return all;
}

/// Returns false if it was stopped.
bool fill(std::span<clipping::Segment> lines, const LineSource& source, const std::stop_token& stop)
{
    for (; !lines.empty(); lines = lines.subspan(std::min<std::size_t>(block, lines.size()))) {
        if (stop.stop_requested())
            return false;
        source(lines.first(std::min<std::size_t>(block, lines.size())));
    }
    return true;
}

} // namespace

std::optional<All> linesByClass(const TestScene& scene, const Field& field, std::uint64_t seed,
                                std::size_t most, const Follower& follower)
{
    auto all = lookedThrough(scene, field, seed, most, follower);
    if (!all)
        return std::nullopt;
    for (std::size_t c = 0; c < all->size() && scene.lines == 0; ++c)
        if (ClassLines& one = (*all)[c]; one.lines.size() < std::min(fewest, most)) {
            one.standIn = QString::fromUtf16(standIns[c]);
            one.lines.resize(most);
            if (!fill(one.lines, findTestScene(one.standIn)->begin(field, seed), follower.stop))
                return std::nullopt;
        }
    return all;
}

} // namespace app

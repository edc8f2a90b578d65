// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/class_lines.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::uint64_t mostLooked = 4'000'000, block = 100'000;
constexpr std::size_t fewest = 1000;

/// In the order of lineClasses: scenes that are made of one class.
constexpr std::array standIns{u"inside", u"rejected", u"crossing", u"near-miss"};

using All = std::array<ClassLines, lineClasses.size()>;

bool isEnough(const All& all, std::size_t most)
{
    return std::ranges::all_of(all,
                               [&](const ClassLines& one) { return one.lines.size() >= most; });
}

All lookedThrough(const TestScene& scene, const Field& field, std::uint64_t seed, std::size_t most)
{
    All all;
    for (std::size_t c = 0; c < all.size(); ++c)
        all[c].lineClass = lineClasses[c];
    const LineSource source = scene.begin(field, seed);
    const std::uint64_t last = scene.lines == 0 ? mostLooked : scene.lines;
    std::vector<clipping::Segment> some;
    std::uint64_t looked = 0;
    while (looked < last && !isEnough(all, most)) {
        some.resize(std::min(block, last - looked));
        source(some);
        looked += some.size();
        for (const clipping::Segment& line : some) {
            ClassLines& one = all[std::size_t(lineClassOf(line, field.window))];
            one.share += 1;
            if (one.lines.size() < most)
                one.lines.push_back(line);
        }
    }
    for (ClassLines& one : all)
        one.share /= double(looked);
    return all;
}

} // namespace

All linesByClass(const TestScene& scene, const Field& field, std::uint64_t seed, std::size_t most)
{
    All all = lookedThrough(scene, field, seed, most);
    for (std::size_t c = 0; c < all.size() && scene.lines == 0; ++c)
        if (all[c].lines.size() < std::min(fewest, most)) {
            all[c].standIn = QString::fromUtf16(standIns[c]);
            all[c].lines.resize(most);
            findTestScene(all[c].standIn)->begin(field, seed)(all[c].lines);
        }
    return all;
}

} // namespace app

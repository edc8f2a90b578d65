// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "tests/benchmarks/area_peers/peer.h"

// Clipper 6.4 (Angus Johnson): Vatti's algorithm on whole numbers.

namespace {

// Numbers below 2^30 need no 128-bit products: the fastest that it can do.
constexpr double scale = 0x1p20;

ClipperLib::Path pathOf(const clipping::Area& area)
{
    ClipperLib::Path path;
    for (const auto& p : area.points)
        path.emplace_back(std::llround(p.x * scale), std::llround(p.y * scale));
    return path;
}

ClipperLib::PolyFillType ruleOf(const clipping::Area& area)
{
    return area.rule == clipping::FillRule::NonZero ? ClipperLib::pftNonZero
                                                    : ClipperLib::pftEvenOdd;
}

class Data : public AreaPeerData {
public:
    Data(std::span<const clipping::Area> areas, const clipping::Area& window)
        : window_(pathOf(window)), rule_(ruleOf(window))
    {
        for (const auto& area : areas)
            areas_.push_back({pathOf(area), ruleOf(area)});
    }
    double clipAll() override
    {
        double sum = 0;
        for (const auto& [path, rule] : areas_) {
            ClipperLib::Clipper clipper;
            clipper.AddPath(path, ClipperLib::ptSubject, true);
            clipper.AddPath(window_, ClipperLib::ptClip, true);
            ClipperLib::Paths left;
            clipper.Execute(ClipperLib::ctIntersection, left, rule, rule_);
            for (const auto& ring : left)
                sum += ClipperLib::Area(ring);
        }
        return sum / (scale * scale);
    }

private:
    struct Subject {
        ClipperLib::Path path;
        ClipperLib::PolyFillType rule;
    };
    std::vector<Subject> areas_;
    ClipperLib::Path window_;
    ClipperLib::PolyFillType rule_;
};

} // namespace

std::span<const AreaPeer> clipperAreaPeers()
{
    static const AreaPeer all[] = {
        {"Clipper 6.4", "libpolyclipping-dev", true,
         [](std::span<const clipping::Area> areas, const clipping::Area& window)
             -> std::unique_ptr<AreaPeerData> { return std::make_unique<Data>(areas, window); }}};
    return all;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "tests/benchmarks/line_peers/peer.h"

// Clipper 6.4 (Angus Johnson): Vatti's algorithm on whole numbers, with lines as open paths.

namespace {

// Numbers below 2^30 need no 128-bit products: the fastest that it can do.
constexpr double scale = 0x1p20;

ClipperLib::IntPoint pointOf(const glm::dvec2& p)
{
    return {std::llround(p.x * scale), std::llround(p.y * scale)};
}

class Data : public LinePeerData {
public:
    /// `together`: how many lines are clipped in one call.
    Data(std::span<const clipping::Segment> lines, const clipping::Area& window,
         std::size_t together)
        : together_(together)
    {
        for (const auto& p : window.points)
            window_.push_back(pointOf(p));
        for (const auto& [a, b] : lines)
            lines_.push_back({pointOf(a), pointOf(b)});
    }
    KeptLines clipAll() override
    {
        KeptLines kept;
        for (std::size_t i = 0; i < lines_.size(); i += together_) {
            ClipperLib::Clipper clipper;
            for (std::size_t j = i; j < std::min(lines_.size(), i + together_); ++j)
                clipper.AddPath(lines_[j], ClipperLib::ptSubject, false);
            clipper.AddPath(window_, ClipperLib::ptClip, true);
            ClipperLib::PolyTree tree;
            clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero,
                            ClipperLib::pftNonZero);
            ClipperLib::Paths left;
            ClipperLib::OpenPathsFromPolyTree(tree, left);
            for (const auto& path : left)
                add(path, kept);
        }
        return kept;
    }

private:
    static void add(const ClipperLib::Path& path, KeptLines& kept)
    {
        double length = 0;
        for (std::size_t i = 1; i < path.size(); ++i)
            length +=
                std::hypot(double(path[i].X - path[i - 1].X), double(path[i].Y - path[i - 1].Y));
        kept.length += length / scale;
        kept.pieces += length > 0;
    }
    std::size_t together_;
    ClipperLib::Path window_;
    ClipperLib::Paths lines_;
};

template <std::size_t together>
std::unique_ptr<LinePeerData> prepare(std::span<const clipping::Segment> lines,
                                      const clipping::Area& window)
{
    return std::make_unique<Data>(lines, window, together);
}

} // namespace

// It is no referee: rounding to its grid moves lines past corners, and it loses horizontal lines.
std::span<const LinePeer> clipperLinePeers()
{
    static const LinePeer all[] = {
        {"Clipper 6.4, one by one", "libpolyclipping-dev", false, prepare<1>},
        {"Clipper 6.4, 100 together", "libpolyclipping-dev", false, prepare<100>}};
    return all;
}

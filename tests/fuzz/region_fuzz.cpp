// SPDX-License-Identifier: GPL-3.0-or-later
// Regions of up to three areas: where the numbers are not too far apart, the contract against
// fractions; and for all numbers, that both directions and all rows agree, that the pieces are in
// order, and that any buffer will do.
#include <array>

#include "tests/clipping/region/contract.h"
#include "tests/fuzz/one_input.h"

using namespace clipping;

namespace {

constexpr std::size_t mostPoints = 7; // of an area: the truth takes its time

Region regionOf(Bytes& bytes)
{
    const int kind = bytes.byte();
    Region region{{}, kind % 2 ? Keep::Outside : Keep::Inside};
    for (int n = kind / 2 % 3; n >= 0; --n) {
        const int way = bytes.byte();
        Area area{{}, {}, way % 2 ? FillRule::EvenOdd : FillRule::NonZero};
        for (std::size_t i = 0; i < std::size_t(way / 8) % (mostPoints + 1); ++i)
            area.points.push_back(pointOf<2>(bytes));
        if (way / 64 % 2 && area.points.size() > 3)
            area.ringEnds = {3, std::uint32_t(area.points.size())};
        region.steps.push_back({std::move(area), AreaOperation(way / 2 % 3)});
    }
    return region;
}

/// Whether fractions of these numbers have few enough digits.
bool isNarrow(const Segment& s, const Region& region)
{
    bool narrow = true;
    const auto look = [&](const glm::dvec2& p) {
        for (const double x : {p.x, p.y})
            narrow = narrow && (x == 0 || (std::abs(x) > 0x1p-60 && std::abs(x) < 0x1p60));
    };
    look(s.a), look(s.b);
    for (const auto& step : region.steps)
        std::ranges::for_each(step.area.points, look);
    return narrow;
}

/// Whether p does not come after q in the direction of s.
bool inOrder(const Segment& s, const glm::dvec2& p, const glm::dvec2& q)
{
    const auto fine = [](double a, double b, double from, double to) {
        return a == b ? true : a < b ? from <= to : from >= to;
    };
    return fine(s.a.x, s.b.x, p.x, q.x) && fine(s.a.y, s.b.y, p.y, q.y);
}

void checkAny(const Segment& s, const Region& region, const PreparedRegion& prepared)
{
    const auto pieces = clip(s, prepared);
    const auto same = [](const RegionPiece& p, const RegionPiece& q) {
        return sameBits(p.segment, q.segment) && p.edgeOfA == q.edgeOfA && p.edgeOfB == q.edgeOfB;
    };
    const bool isFinite = std::isfinite(s.a.x) && std::isfinite(s.a.y) && std::isfinite(s.b.x)
                          && std::isfinite(s.b.y);
    glm::dvec2 last = s.a;
    for (const RegionPiece& piece : pieces) {
        if (isFinite
            && (!inOrder(s, last, piece.segment.a) || !inOrder(s, piece.segment.a, piece.segment.b)
                || !inOrder(s, piece.segment.b, s.b)))
            found("out of order for " + exactly(s, region));
        last = piece.segment.b;
    }
    RegionProgress at;
    std::array<RegionPiece, 1> out;
    for (const RegionPiece& piece : pieces) {
        at = clipAll(std::span(&s, 1), prepared, out, at);
        if (at.written != 1 || !same(out[0], piece))
            found("another result with a small buffer for " + exactly(s, region));
    }
    if (clipAll(std::span(&s, 1), prepared, out, at).written != 0)
        found("more pieces with a small buffer for " + exactly(s, region));
    if (const auto wrong = reversalFault(pieces, clip({s.b, s.a}, prepared)); !wrong.empty())
        found(wrong + " for " + exactly(s, region));
    for (const RegionAlgorithm& row : regionAlgorithms())
        if (!std::ranges::equal(row.clip(s, prepared), pieces, same))
            found(std::string(row.key) + " differs for " + exactly(s, region));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const glm::dvec2 from = pointOf<2>(bytes), to = pointOf<2>(bytes);
    const Segment s{from, to};
    const Region region = regionOf(bytes);
    const PreparedRegion prepared(region);
    checkAny(s, region, prepared);
    if (!isNarrow(s, region))
        return 0;
    const region_oracle::Truth<Rational> truth(region);
    if (const auto wrong = fault(clip(s, prepared), s, truth, prepared); !wrong.empty())
        found(wrong + " for " + exactly(s, region));
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Filled areas at regions (clipping/area/clip_area.h). For all numbers: the rings are closed by
// edges between the ends of their origins, and inside and outside together have no more corners
// than edges meet. Where the numbers are not too far apart: the exact area, and winding numbers at
// points.
#include "tests/clipping/area/contract.h"
#include "tests/clipping/area/truth.h"
#include "tests/clipping/region/contract.h"
#include "tests/fuzz/one_input.h"

using namespace clipping;
using namespace area_contract;

namespace {

constexpr std::size_t mostPoints = 6; // of an area: the truth takes its time
constexpr double narrowest = 0x1p-20, widest = 0x1p20;

Area areaFrom(Bytes& bytes, int way)
{
    Area area{{}, {}, way % 2 ? FillRule::EvenOdd : FillRule::NonZero};
    for (std::size_t i = 0; i < 3 + std::size_t(way / 8) % (mostPoints - 2); ++i)
        area.points.push_back(pointOf<2>(bytes));
    if (way / 64 % 2 && area.points.size() > 3)
        area.ringEnds = {3, std::uint32_t(area.points.size())};
    return area;
}

Region windowFrom(Bytes& bytes)
{
    const int kind = bytes.byte();
    Region region{{}, kind % 2 ? Keep::Outside : Keep::Inside};
    for (int n = kind / 2 % 2; n >= 0; --n) {
        const int way = bytes.byte();
        region.steps.push_back({areaFrom(bytes, way), AreaOperation(way / 2 % 3)});
    }
    return region;
}

/// The largest |coordinate|; nothing if fractions of these numbers have too many digits.
std::optional<double> reachOf(std::initializer_list<const Region*> regions)
{
    double reach = 0;
    for (const Region* region : regions)
        for (const auto& step : region->steps)
            for (const auto& p : step.area.points)
                for (const double x : {p.x, p.y}) {
                    if (!(x == 0 || (std::abs(x) > narrowest && std::abs(x) < widest)))
                        return std::nullopt;
                    reach = std::max(reach, std::abs(x));
                }
    return reach;
}

double toDouble(const Rational& x) { return boost::rational_cast<double>(x); }

void checkAny(const ClippedArea& result, const PreparedRegion& area, const PreparedRegion& window,
              const std::string& input)
{
    if (result.part != AreaPart::Cut && !(result.points.empty() && result.ringEnds.empty()))
        found("rings without a cut for " + input);
    if (result.points.size() != result.origins.size())
        found("not one origin for each point for " + input);
    const auto lies = [](double x, double a, double b) {
        return x >= std::min(a, b) && x <= std::max(a, b);
    };
    forEdges(result, [&](std::size_t i, const glm::dvec2& from, const glm::dvec2& to) {
        const auto& [number, isOfWindow, begin, end] = result.origins[i];
        const Segment s = (isOfWindow ? window : area).edge(number).segment;
        if (!(begin >= 0 && begin <= 1 && end >= 0 && end <= 1))
            found("wrong shares for " + input);
        for (const auto& p : {from, to})
            if (!lies(p.x, s.a.x, s.b.x) || !lies(p.y, s.a.y, s.b.y))
                found("off the edge of its origin for " + input);
    });
}

void checkTruth(const ClippedArea& result, const Region& area, const Region& window, double reach,
                Bytes& bytes, const std::string& input)
{
    const Region everything;
    const AreaTruth<Rational> truth(area, window), all(area, everything);
    const double exact = truth.area<double>(toDouble);
    const double left =
        result.part == AreaPart::Whole ? all.area<double>(toDouble) : toDouble(exactArea(result));
    // Each corner is off by half an ulp, which moves the area by at most that times two edges; and
    // the truth's sum is rounded.
    const double corners = 200 + double(result.points.size());
    if (std::abs(left - exact) > corners * 0x1p-50 * reach * reach)
        found("wrong area for " + input);
    for (int i = 0; i < 4; ++i) {
        const glm::dvec2 p = pointOf<2>(bytes);
        if (result.part == AreaPart::Whole || !(std::abs(p.x) < widest && std::abs(p.y) < widest))
            continue;
        const auto winding = windingAt(result, p, 0x1p-40 * std::max(1.0, reach));
        const bool isKept = truth.keeps<Rational>({rational(p.x), rational(p.y)});
        if (winding && *winding != int(isKept))
            found("winding number " + std::to_string(*winding) + " for " + input);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const int way = bytes.byte();
    const Region area{{{areaFrom(bytes, way)}}, Keep::Inside}, window = windowFrom(bytes);
    const PreparedRegion prepared(area), at(window);
    const ClippedArea result = clipArea(prepared, at);
    const std::string input = exactly({}, area) + "; " + exactly({}, window);
    checkAny(result, prepared, at, input);
    const auto reach = reachOf({&area, &window});
    if (!reach || result.part == AreaPart::Refused)
        return 0;
    if (const auto wrong = originFault(result, prepared, at, *reach); !wrong.empty())
        found(wrong + " for " + input);
    checkTruth(result, area, window, *reach, bytes, input);
    return 0;
}

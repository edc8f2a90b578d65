// SPDX-License-Identifier: GPL-3.0-or-later
// Every form for convex polygons, against whole numbers: the hull of the corners keeps the
// contract; the corners as they come, which are mostly no polygon, are survived, and searching them
// gives the same bits.
#include "tests/clipping/polygon/contract.h"
#include "tests/fuzz/one_input.h"

using namespace clipping;

namespace {

constexpr std::size_t most = 12; // corners: the truth takes its time

bool isFinite(const Segment& s, const ConvexPolygon& polygon)
{
    const auto finite = [](const glm::dvec2& p) {
        return std::isfinite(p.x) && std::isfinite(p.y);
    };
    return finite(s.a) && finite(s.b) && std::ranges::all_of(polygon.corners, finite);
}

bool same(const std::optional<Segment>& s, const std::optional<Segment>& t)
{
    return s.has_value() == t.has_value() && (!s || sameBits(*s, *t));
}

/// What all the ways to ask for one segment say, which is the same.
std::optional<Clipped> agreed(const PolygonUses& uses, const Segment& s,
                              const ConvexPolygon& polygon, const std::string& who)
{
    const auto one = clipOne(uses, s, polygon);
    const auto piece = one ? std::optional(one->segment) : std::nullopt;
    if (!same(uses.clip(s, polygon), piece))
        found(who + ": clipAll differs from clip for " + exactly(s, polygon));
    const Trace trace = uses.trace(s, polygon);
    const bool traced = trace.outcome == Outcome::Visible;
    if (!same(traced ? std::optional(trace.visible) : std::nullopt, piece))
        found(who + ": the trace differs from clip for " + exactly(s, polygon));
    uses.count({&s, 1}, polygon);
    if (one && !isFinite(s, polygon))
        found(who + ": seen where the contract says nothing for " + exactly(s, polygon));
    return one;
}

void tryForm(const PolygonUses& uses, const Segment& s, const ConvexPolygon& raw,
             const ConvexPolygon& hull, const std::string& who)
{
    agreed(uses, s, raw, who);
    const auto one = agreed(uses, s, hull, who);
    if (!isFinite(s, hull))
        return;
    const bool decidesExactly = !who.starts_with("cyrus-beck");
    if (const auto wrong = fault(one, s, hull, decidesExactly); !wrong.empty())
        found(who + ": " + wrong + " for " + exactly(s, hull));
}

void trySearched(const Algorithm& a, const Segment& s, const ConvexPolygon& polygon)
{
    const auto one = clipOne(*a.polygon, s, polygon), two = clipOne(*a.polygonBySearch, s, polygon);
    if (one.has_value() != two.has_value()
        || (one && (!sameBits(one->segment, two->segment) || one->cut != two->cut)))
        found(std::string(a.key) + ": searched differs for " + exactly(s, polygon));
}

/// So many segments related to one that vectors clip them, against one at a time.
void tryMany(const PolygonUses& uses, const Segment& s, const ConvexPolygon& polygon)
{
    std::vector<Segment> many;
    for (int i = 0; many.size() < 40; ++i)
        for (const auto& corner : polygon.corners)
            many.push_back(i % 3 == 0   ? Segment{s.a, corner}
                           : i % 3 == 1 ? Segment{corner, s.b}
                                        : Segment{s.b + double(i) * (s.a - s.b), s.a});
    std::vector<Clipped> out(many.size());
    out.resize(uses.clipAll(many, polygon, out));
    auto next = out.begin();
    for (std::size_t i = 0; i < many.size(); ++i) {
        const auto one = clipOne(uses, many[i], polygon);
        const bool seen = next != out.end() && next->source == i;
        if (seen != one.has_value()
            || (seen && (!sameBits(next->segment, one->segment) || next->cut != one->cut)))
            found("many differ from one for " + exactly(many[i], polygon));
        next += seen;
    }
}

/// The promise of `exact`: the same bits backwards, edges included.
void tryBackwards(const Segment& s, const ConvexPolygon& polygon)
{
    const auto& uses = *exactAlgorithm().polygon;
    const auto one = clipOne(uses, s, polygon), two = clipOne(uses, {s.b, s.a}, polygon);
    if (one.has_value() != two.has_value()
        || (one
            && (!sameBits(one->segment, {two->segment.b, two->segment.a})
                || polygonEdgeOfA(one->cut) != polygonEdgeOfB(two->cut)
                || polygonEdgeOfB(one->cut) != polygonEdgeOfA(two->cut))))
        found("exact differs backwards for " + exactly(s, polygon));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const glm::dvec2 from = pointOf<2>(bytes), to = pointOf<2>(bytes);
    const Segment s{from, to};
    ConvexPolygon raw;
    while (!bytes.ended() && raw.corners.size() < most)
        raw.corners.push_back(pointOf<2>(bytes));
    const ConvexPolygon hull = isFinite(s, raw) ? hullOf(raw.corners) : raw;
    for (const Algorithm& a : algorithms()) {
        if (a.polygon)
            tryForm(*a.polygon, s, raw, hull, std::string(a.key));
        if (!a.polygonBySearch)
            continue;
        tryForm(*a.polygonBySearch, s, raw, hull, std::string(a.key) + ", searched");
        trySearched(a, s, raw);
        trySearched(a, s, hull);
    }
    tryBackwards(s, hull);
    if (size % 8 == 0 && !hull.corners.empty()) // it takes its time
        tryMany(*exactAlgorithm().polygon, s, hull);
    return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of clipping/region/region.h one by one, with windows; the application's several clip
// windows (app/scene/region.h) have the same. And one window against the row `exact`.
#include "clipping/algorithm.h"
#include "clipping/outside.h"
#include "clipping/region/region.h"

#include <QTest>

#include <array>

#include "tests/clipping/inputs.h"
#include "tests/clipping/random.h"
#include "tests/clipping/region/contract.h"
#include "tests/clipping/scenes.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace region_region_test {

using namespace clipping;
using enum AreaOperation;

namespace {

struct Step {
    Window window;
    AreaOperation operation = Add;
};
using Segments = std::vector<Segment>;

Region regionOf(const std::vector<Step>& steps, Keep keep = Keep::Inside)
{
    Region region{{}, keep};
    for (const auto& [window, operation] : steps)
        region.steps.push_back({areaOf(window), operation});
    return region;
}

Segments kept(const Segment& line, const PreparedRegion& region)
{
    Segments all;
    for (const RegionPiece& piece : clip(line, region))
        all.push_back(piece.segment);
    return all;
}
Segments kept(const Segment& line, const std::vector<Step>& steps, Keep keep = Keep::Inside)
{
    return kept(line, PreparedRegion(regionOf(steps, keep)));
}

const Window left{{0, 0}, {2, 2}}, right{{2, 0}, {4, 2}};
const Window both{{0, 0}, {4, 2}}, middle{{1, -1}, {3, 3}};

Segments segmentsOf(std::span<const Clipped> pieces)
{
    Segments all;
    for (const Clipped& piece : pieces)
        all.push_back(piece.segment);
    return all;
}

/// By the row `exact`. -0 equals 0.
void compareWithExact(const Window& window, std::span<const Segment> segments)
{
    if (!(window.min.x < window.max.x && window.min.y < window.max.y))
        return; // an area has no lines and points without area
    const PreparedRegion inside(regionOf({{window}})), outside(regionOf({{window}}, Keep::Outside));
    for (const Segment& s : segments) {
        std::array<Clipped, 2> buffer, removed;
        const std::size_t count =
            exactAlgorithm().corrected.clipAll(std::span(&s, 1), window, buffer);
        const auto pieces = std::span(buffer).first(count);
        VERIFY_OR_SAY(kept(s, inside) == segmentsOf(pieces),
                      exactly(s, regionOf({{window}})).c_str());
        auto found = kept(s, outside);
        const Segment part = count ? pieces[0].segment : Segment{};
        // Where the part inside rounds to a point, `outsideAll` takes it for a contact.
        if (found.size() == 2 && part.a == part.b && found[0].b == part.a)
            found = {s};
        const auto all = std::span(removed).first(outsideAll(std::span(&s, 1), pieces, removed));
        VERIFY_OR_SAY(found == segmentsOf(all),
                      exactly(s, regionOf({{window}}, Keep::Outside)).c_str());
    }
}

} // namespace

class RegionTest : public QObject {
    Q_OBJECT

private slots:
    void windowsAreClosed()
    {
        QCOMPARE(kept({{0, 0}, {2, 0}}, {{left}}), (Segments{{{0, 0}, {2, 0}}}));
        QCOMPARE(kept({{2, 2}, {2, 2}}, {{left}}), (Segments{{{2, 2}, {2, 2}}}));
        QCOMPARE(kept({{-1, 1}, {5, 1}}, {{left}}), (Segments{{{0, 1}, {2, 1}}}));
    }
    void aContactIsAPoint()
    {
        QCOMPARE(kept({{1, 3}, {3, 1}}, {{left}}), (Segments{{{2, 2}, {2, 2}}}));
        QCOMPARE(kept({{2, 2}, {3, 3}}, {{left}}), (Segments{{{2, 2}, {2, 2}}}));
        QCOMPARE(kept({{3, 3}, {2, 2}}, {{left}}), (Segments{{{2, 2}, {2, 2}}}));
    }
    void aSharedEdgeLeavesALineWhole()
    {
        for (const double y : {1.0, 0.0, 2.0, 0.1, 1.0 / 3})
            QCOMPARE(kept({{-1, y}, {5, y}}, {{left}, {right}}), (Segments{{{0, y}, {4, y}}}));
        QCOMPARE(kept({{-1, 0.1}, {5, 1.7}}, {{left}, {right}}).size(), 1u);
        QCOMPARE(kept({{2, -1}, {2, 3}}, {{left}, {right}}), (Segments{{{2, 0}, {2, 2}}}));
    }
    void aCutOutRemovesItsBorder()
    {
        QCOMPARE(kept({{2, -1}, {2, 3}}, {{both}, {left, CutOut}}), Segments{});
        QCOMPARE(kept({{0, 1}, {4, 1}}, {{both}, {left, CutOut}}), (Segments{{{2, 1}, {4, 1}}}));
        QCOMPARE(kept({{2, 1}, {2, 1}}, {{both}, {left, CutOut}}), Segments{});
        QCOMPARE(kept({{0, 1}, {4, 1}}, {{both}, {middle, CutOut}}),
                 (Segments{{{0, 1}, {1, 1}}, {{3, 1}, {4, 1}}}));
    }
    void aCutOutMetInAPointRemovesNothing()
    {
        const Segment line{{0.5, 1.5}, {1.5, 0.5}};
        QCOMPARE(kept(line, {{left}, {{{0, 0}, {1, 1}}, CutOut}}), Segments{line});
        QCOMPARE(kept(line, {{left}, {{{0, 0}, {1, 1}}, CutOut}}, Keep::Outside),
                 (Segments{{{1, 1}, {1, 1}}}));
    }
    void anIntersectionIsClosed()
    {
        QCOMPARE(kept({{2, -1}, {2, 3}}, {{left}, {right, Intersect}}),
                 (Segments{{{2, 0}, {2, 2}}}));
        QCOMPARE(kept({{0, 1}, {4, 1}}, {{left}, {right, Intersect}}),
                 (Segments{{{2, 1}, {2, 1}}}));
    }
    void theFirstStepDecidesWhereTheSetStarts()
    {
        const Segment line{{-1, 1}, {5, 1}};
        QCOMPARE(kept(line, {{left, CutOut}}), (Segments{{{-1, 1}, {0, 1}}, {{2, 1}, {5, 1}}}));
        QCOMPARE(kept(line, {{left, Intersect}}), (Segments{{{0, 1}, {2, 1}}}));
        QCOMPARE(kept(line, {{left, Add}}), (Segments{{{0, 1}, {2, 1}}}));
    }
    void stepsAreFoldedFromTheTop()
    {
        const Segment line{{-1, 1}, {5, 1}};
        QCOMPARE(kept(line, {{both}, {middle, CutOut}, {{{1.5, 0}, {2.5, 2}}}}),
                 (Segments{{{0, 1}, {1, 1}}, {{1.5, 1}, {2.5, 1}}, {{3, 1}, {4, 1}}}));
        QCOMPARE(kept(line, {{{{1.5, 0}, {2.5, 2}}}, {both}, {middle, CutOut}}),
                 (Segments{{{0, 1}, {1, 1}}, {{3, 1}, {4, 1}}}));
    }
    void outsideEndsOnTheSameBorders()
    {
        QCOMPARE(kept({{-1, 1}, {5, 1}}, {{left}}, Keep::Outside),
                 (Segments{{{-1, 1}, {0, 1}}, {{2, 1}, {5, 1}}}));
        QCOMPARE(kept({{0, 0}, {2, 0}}, {{left}}, Keep::Outside), Segments{});
    }
    void edgesAreNamed()
    {
        const PreparedRegion region(regionOf({{left}, {right}}));
        const auto pieces = clip({{-1, 1}, {5, 1}}, region);
        QCOMPARE(pieces.size(), 1u);
        QCOMPARE(pieces[0].edgeOfA, 4u); // left edge of the first window
        QCOMPARE(pieces[0].edgeOfB, 6u); // right edge of the second
        QCOMPARE(region.edge(6).segment, (Segment{{4, 0}, {4, 2}}));
        QCOMPARE(region.edge(6).step, 1u);
        const auto inside = clip({{1, 1}, {3, 1}}, region);
        QCOMPARE(inside[0].edgeOfA, 0u);
        QCOMPARE(inside[0].edgeOfB, 0u);
    }
    void anEndThatIsOutByLessThanAnUlpStaysOut()
    {
        const Segment line{{1, -1e-30}, {2, 1}}; // x is 1 where it enters, to the last bit
        QCOMPARE(kept(line, {{{{0, 0}, {3, 3}}}}), (Segments{{{1, 0}, {2, 1}}}));
    }

    void oneWindowIsClippedAsByExact()
    {
        for (const Family& family : families()) {
            const auto& inputs = family.inputs();
            for (std::size_t i = 0; i < inputs.size(); i += inputs.size() / 5'000 + 1)
                compareWithExact(inputs[i].window, std::span(&inputs[i].segment, 1));
        }
        for (const auto& scene : hardScenes<double>(10'000))
            compareWithExact(scene.window, scene.segments);
    }
    void aHoleIsACutOut()
    {
        Random random(8);
        const Area frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {3, 6}, {6, 6}, {6, 3}}, {4, 8}};
        const PreparedRegion hole({{{frame}}, Keep::Inside});
        const PreparedRegion cut(regionOf({{{{0, 0}, {9, 9}}}, {{{3, 3}, {6, 6}}, CutOut}}));
        for (int i = 0; i < 2'000; ++i) {
            const auto number = [&] { return random.between(-1, 10); };
            const Segment s{{number(), number()}, {number(), number()}};
            const auto p = clip(s, hole), q = clip(s, cut);
            QVERIFY(std::ranges::equal(p, q, {}, &RegionPiece::segment, &RegionPiece::segment));
        }
    }
};

} // namespace region_region_test

TEST_CLASS(region_region_test::RegionTest, Core)
#include "tests/clipping/region/region_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/path.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <thread>
#include <tuple>

#include "tests/app/document/random_paths.h"
#include "tests/test_class.h"

namespace document_path_test {

using namespace app;

namespace {

Placement anyPlacement(Random& r)
{
    if (r.whole(0, 3) == 0)
        return {};
    const double x = r.whole(0, 1) ? 1 : r.between(-3, 3), y = r.whole(0, 1) ? 1 : r.between(-3, 3);
    return {{x, y}, {r.between(-9, 9), r.whole(0, 1) ? -0.0 : r.between(-9, 9)}};
}

template <class Change>
std::vector<Subpath> changed(std::vector<Subpath> subpaths, const Change& change)
{
    for (Subpath& subpath : subpaths) {
        subpath.start = change(subpath.start);
        for (PathSegment& segment : subpath.segments) {
            segment.to = change(segment.to);
            if (segment.curved) {
                segment.control1 = change(segment.control1);
                segment.control2 = change(segment.control2);
            }
        }
    }
    return subpaths;
}

Bits bitsOfSegments(const std::vector<clipping::Segment>& segments)
{
    Bits bits;
    for (const clipping::Segment& segment : segments) {
        add(bits, segment.a);
        add(bits, segment.b);
    }
    return bits;
}

std::vector<clipping::Segment> segmentsOf(const std::vector<Chord>& chords)
{
    std::vector<clipping::Segment> segments;
    for (const Chord& chord : chords)
        segments.push_back(chord.segment);
    return segments;
}

Path lines(int count)
{
    Subpath subpath{{0, 0}, {}, false};
    for (int i = 1; i <= count; ++i)
        subpath.segments.push_back({Point(i, i % 7)});
    return Path({&subpath, 1});
}

} // namespace

class PathTest : public QObject {
    Q_OBJECT

private slots:
    void unpackingGivesTheSubpathsBack()
    {
        RandomPaths random(1);
        for (int i = 0; i < 20'000; ++i) {
            const std::vector<Subpath> subpaths = random.subpaths();
            const Path path(subpaths);
            QCOMPARE(bitsOf(path.subpaths()), bitsOf(subpaths));
            QVERIFY(path == Path(path.subpaths()));
            QCOMPARE(path.subpathCount(), subpaths.size());
            bool straight = true, area = false;
            std::size_t points = 0;
            for (const Subpath& subpath : subpaths) {
                ++points;
                area = area || subpath.segments.size() > 1;
                for (const PathSegment& segment : subpath.segments) {
                    points += segment.curved ? 3 : 1;
                    straight = straight && !segment.curved;
                }
            }
            QCOMPARE(path.straight(), straight);
            QCOMPARE(path.hasArea(), area || !straight);
            QCOMPARE(path.pointCount(), path.singleLine() ? 2 : points);
        }
    }
    void flatteningGivesTheSameBits()
    {
        RandomPaths random(2, 500); // a huge curve has 10,000 chords
        std::size_t chordsSeen = 0;
        for (int i = 0; i < 5000; ++i) {
            const Path path = Path(random.subpaths()).placed(anyPlacement(random.random));
            const double tolerance = random.random.between(0.01, 4);
            std::vector<Chord> packed, plain;
            flatten(path, tolerance, packed);
            for (const Subpath& subpath : path.subpaths())
                flatten(subpath, tolerance, plain);
            QCOMPARE(bitsOfSegments(segmentsOf(packed)), bitsOfSegments(segmentsOf(plain)));
            const auto rest = [](const Chord& chord) {
                return std::tuple(chord.pathSegment, chord.t0, chord.t1);
            };
            QVERIFY(std::ranges::equal(packed, plain, {}, rest, rest));
            std::vector<clipping::Segment> segments;
            appendSegments(path, tolerance, segments);
            QCOMPARE(bitsOfSegments(segments), bitsOfSegments(segmentsOf(plain)));
            chordsSeen += plain.size();
        }
        QVERIFY(chordsSeen > 50'000);
    }
    void aPlacementMovesEveryPoint()
    {
        RandomPaths random(3);
        for (int i = 0; i < 5000; ++i) {
            const std::vector<Subpath> subpaths = random.subpaths();
            const Placement where = anyPlacement(random.random);
            const Path path = Path(subpaths).placed(where);
            if (Path(subpaths).singleLine())
                QVERIFY(path == Path(changed(subpaths, where)));
            else
                QCOMPARE(bitsOf(path.subpaths()), bitsOf(changed(subpaths, where)));
            QVERIFY(path == Path(path.subpaths()));

            Bits visited, points;
            path.forEachPoint([&](const Point& p) { add(visited, p); });
            for (const Subpath& subpath : path.subpaths()) {
                add(points, subpath.start);
                for (const PathSegment& segment : subpath.segments) {
                    if (segment.curved) {
                        add(points, segment.control1);
                        add(points, segment.control2);
                    }
                    add(points, segment.to);
                }
            }
            if (const auto line = path.singleLine(); line && line->a == line->b)
                visited.resize(points.size()); // a point counts twice
            QCOMPARE(visited, points);
        }
    }
    void placementsFollowEachOther()
    {
        RandomPaths random(4);
        const auto whole = [&] { return double(random.random.whole(-4, 4)); };
        for (int i = 0; i < 5000; ++i) {
            Placement first{{whole(), whole()}, {whole(), whole()}};
            Placement second{{whole(), whole()}, {whole(), whole()}};
            const Subpath triangle{{whole(), whole()}, {{{whole(), whole()}}, {{3, 5}}}, true};
            const Path once = Path({&triangle, 1}).placed(first).placed(second);
            const auto both = [&](const Point& p) { return second(first(p)); };
            QCOMPARE(once.subpaths(),
                     changed({triangle}, both)); // whole numbers: nothing is rounded
        }
    }
    void pathsAreEqualWhereTheirPointsLie()
    {
        const Subpath here{{1, 2}, {{{3, 4}}, {{5, -6}}}, false};
        const Subpath there{{11, 22}, {{{13, 24}}, {{15, 14}}}, false};
        const Path path({&here, 1});
        QVERIFY(path.placed({{1, 1}, {10, 20}}) == Path({&there, 1}));
        QVERIFY(path.placed({{1, 1}, {10, 20}}) != path);
        QVERIFY(path.placed({{1, 1}, {10, 20}}).placed({{1, 1}, {-10, -20}}) == path);

        RandomPaths random(5);
        for (int i = 0; i < 5000; ++i) {
            std::vector<Subpath> subpaths = random.subpaths();
            if (subpaths.empty())
                continue;
            const Path before(subpaths);
            Subpath& one = subpaths[std::size_t(random.random.whole(0, int(subpaths.size()) - 1))];
            PathSegment* segment = one.segments.empty() ? nullptr : &one.segments.back();
            switch (random.random.whole(0, 3)) {
            case 0:
                one.closed = !one.closed;
                break;
            case 1:
                one.start.y = one.start.y == 0 ? -one.start.y : std::nextafter(one.start.y, 0);
                break;
            case 2:
                one.segments.push_back({one.start});
                break;
            default:
                if (segment && segment->curved)
                    *segment = {segment->to};
                else if (segment)
                    *segment = {segment->to, segment->to, segment->to, true};
                else
                    subpaths.push_back(one);
            }
            QVERIFY(Path(subpaths) != before);
        }
        QVERIFY(Path() == Path(std::vector<Subpath>{}));
        QVERIFY(Path() != path);
        QVERIFY(Path(clipping::Segment{{NAN, 0}, {0, 0}})
                == Path(clipping::Segment{{NAN, 0}, {0, 0}}));
        QVERIFY(Path(clipping::Segment{{0, 0}, {1, 0}})
                != Path(clipping::Segment{{-0.0, 0}, {1, 0}}));
    }
    void aPointIsNoLineWithoutLength()
    {
        const Subpath point{{1, 2}, {}, false}, line{{1, 2}, {{{1, 2}}}, false};
        const Subpath closed{{1, 2}, {}, true}, signs{{0, 2}, {{{-0.0, 2}}}, false};
        for (const Subpath& one : {point, line, closed, signs})
            QCOMPARE(bitsOf(Path({&one, 1}).subpaths()), bitsOf({one}));
        QVERIFY(Path({&point, 1}).singleLine());
        QVERIFY(!Path({&line, 1}).singleLine());
        QVERIFY(!Path({&closed, 1}).singleLine());
        const Path collapsed =
            Path(clipping::Segment{{1, 1}, {1 + 0x1p-50, 1}}).placed({{1, 1}, {9, 9}});
        QCOMPARE(collapsed.subpaths(), (std::vector<Subpath>{{{10, 10}, {}, false}}));
    }
    void sizes()
    {
        QCOMPARE(Path(clipping::Segment{{0, 0}, {1, 2}}).heapPart().bytes, std::size_t(0));
        QVERIFY(lines(100).heapPart().bytes <= 16 * 101 + 40);
        Subpath curve{{0, 0}, {}, true};
        for (int i = 0; i < 100; ++i)
            curve.segments.push_back({Point(i, 1), Point(1, i), Point(i, i), true});
        QVERIFY(Path({&curve, 1}).heapPart().bytes <= (3 * 16 + 1) * 100 + 16 + 40);
    }
    void copiesAndPlacedOnesShareThePoints()
    {
        const Path path = lines(100);
        QVERIFY(path.heapPart().address && !path.heapPart().shared);
        Path copy = path;
        QVERIFY(path.heapPart().shared && path.heapPart().address == copy.heapPart().address);
        copy = path.placed({{2, 2}, {3, 3}});
        QVERIFY(copy.heapPart().shared && path.heapPart().address == copy.heapPart().address);
        copy = Path(copy.subpaths());
        QVERIFY(!copy.heapPart().shared && !path.heapPart().shared);
        const Path taken = std::move(copy);
        QVERIFY(!taken.heapPart().shared && taken.heapPart().address);
        copy = Path(clipping::Segment{{0, 0}, {1, 2}});
        copy = Path(copy);
        QVERIFY(copy.singleLine());
    }
    void ownersOnManyThreads()
    {
        Path path = lines(50);
        const Bits bits = bitsOf(path.subpaths());
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([mine = path, &bits] {
                for (int round = 0; round < 200; ++round) {
                    const Path copy = mine.placed({{1, 1}, {1, 0}}).placed({{1, 1}, {-1, 0}});
                    if (bitsOf(Path(copy).subpaths()) != bits)
                        qFatal("the points changed");
                }
            });
        path = Path();
        threads.clear();
    }
};

} // namespace document_path_test

TEST_CLASS(document_path_test::PathTest, None)
#include "tests/app/document/path_test.moc"

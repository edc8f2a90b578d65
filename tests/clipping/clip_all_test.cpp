// SPDX-License-Identifier: GPL-3.0-or-later
// clipAll of clearcut/clip.h: every kind of memory in and out, against `clip` one by one.
#include "clipping/limits.h"

#include <QTest>

#include <clearcut/clip.h>

#include "tests/clipping/random.h"
#include "tests/clipping/same_bits.h"
#include "tests/test_class.h"

namespace clip_all_test {

using namespace clearcut;

namespace {

const Window window{{-1, -1}, {1, 1}};
const BasicWindow<float> floatWindow{{-1, -1}, {1, 1}};

template <class T = double>
std::vector<BasicSegment<T>> someSegments(std::size_t count)
{
    Random r(7);
    const auto point = [&] { return glm::vec<2, T>(r.between(-3, 3), r.between(-3, 3)); };
    std::vector<BasicSegment<T>> all(count);
    for (auto& s : all)
        s.a = point(), s.b = point();
    return all;
}

/// What `clip` finds, one by one.
template <class S, class W>
auto oneByOne(const std::vector<S>& in, const W& w)
{
    std::vector<std::pair<std::uint32_t, std::remove_cvref_t<decltype(*clip(in[0], w))>>> found;
    for (std::uint32_t i = 0; i < in.size(); ++i)
        if (const auto piece = clip(in[i], w))
            found.emplace_back(i, *piece);
    return found;
}

template <class Expected, class Pieces>
bool same(const Expected& expected, const Pieces& pieces)
{
    return std::ranges::equal(expected, pieces, [](const auto& truth, const auto& piece) {
        return truth.first == piece.source && sameBits(truth.second, piece.segment);
    });
}

const ConvexWindow triangle = ConvexPolygon::from({{-1, -1}, {1, -1}, {0, 1}});

} // namespace

class ClipAllTest : public QObject {
    Q_OBJECT

private slots:
    void piecesAreThoseOfOneByOne()
    {
        for (const std::size_t count : {0, 1, 2, 7, 100, 1000}) {
            QVERIFY(
                same(oneByOne(someSegments(count), window), clipAll(someSegments(count), window)));
            QVERIFY(same(oneByOne(someSegments<float>(count), floatWindow),
                         clipAll(someSegments<float>(count), floatWindow)));
            QVERIFY(same(oneByOne(someSegments(count), triangle),
                         clipAll(someSegments(count), triangle)));
            QVERIFY(same(oneByOne(someSegments<float>(count), triangle),
                         clipAll(someSegments<float>(count), triangle)));
        }
    }

    void linesRaysAndBoxesToo()
    {
        std::vector<Line> lines;
        std::vector<BasicRay<float>> rays;
        std::vector<Segment3> segments;
        for (const Segment& s : someSegments(600)) {
            lines.push_back({s.a, s.b});
            rays.push_back({glm::vec2(s.a), glm::vec2(s.b)});
            segments.push_back({{s.a, s.b.x}, {s.b, s.a.x}});
        }
        std::vector<Clipped> pieces(lines.size());
        pieces.resize(clipAll(lines, window, pieces).visible);
        QVERIFY(same(oneByOne(lines, window), pieces));
        std::vector<BasicClipped<BasicSegment<float>>> ofRays(rays.size());
        ofRays.resize(clipAll(rays, floatWindow, ofRays).visible);
        QVERIFY(same(oneByOne(rays, floatWindow), ofRays));
        const Window3 box{{-1, -1, -1}, {1, 1, 1}};
        std::vector<BasicClipped<Segment3>> inBox(segments.size());
        inBox.resize(clipAll(segments, box, inBox).visible);
        QVERIFY(same(oneByOne(segments, box), inBox));
    }

    void linesAndRaysAreReadFromEveryLayout()
    {
        const auto in = someSegments(777);
        std::vector<Line> lines;
        std::vector<Ray> rays;
        std::vector<double> x1, y1, x2, y2;
        for (const auto& [a, b] : in) {
            lines.push_back({a, b}), rays.push_back({a, b});
            x1.push_back(a.x), y1.push_back(a.y), x2.push_back(b.x), y2.push_back(b.y);
        }
        const auto view = columns(x1, y1, x2, y2);
        QVERIFY(same(oneByOne(lines, window), clipAll(asLines(view), window)));
        QVERIFY(same(oneByOne(rays, window), clipAll(asRays(view), window)));
        QVERIFY(same(oneByOne(lines, triangle), clipAll(lines, triangle)));
        QVERIFY(same(oneByOne(rays, triangle), clipAll(asRays(view), triangle)));
        std::vector<std::uint8_t> mask(in.size());
        const Progress all = clipAll(asRays(view), window, mask);
        QCOMPARE(all, (Progress{in.size(), oneByOne(rays, window).size()}));
        QCOMPARE(LinesView<double>(lines).from(700).size(), 77u);
        QVERIFY(clipAll(std::vector<Line>{}, window).empty());
    }

    void everyOutputTellsTheSame()
    {
        const auto in = someSegments(1000);
        const auto pieces = clipAll(in, window);
        std::vector<std::uint32_t> sources(in.size());
        const Progress ofSources = clipAll(in, window, sources);
        std::vector<std::uint8_t> mask(in.size(), 7);
        const Progress ofMask = clipAll(in, window, mask);
        std::array<bool, 1000> flags;
        const Progress ofFlags = clipAll(in, window, flags);
        const Progress all{in.size(), pieces.size()};
        QVERIFY(ofSources == all && ofMask == all && ofFlags == all);
        std::vector<std::uint8_t> expected(in.size());
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            QCOMPARE(sources[k], pieces[k].source);
            expected[pieces[k].source] = 1;
        }
        QCOMPARE(mask, expected);
        QVERIFY(std::ranges::equal(flags, expected, {}, {}, [](auto m) { return m != 0; }));
    }

    void everyLayoutOfTheInputIsRead()
    {
        struct Point {
            std::uint32_t before;
            double x, y;
        };
        const auto in = someSegments(777);
        const auto expected = clipAll(in, window);
        std::vector<double> x1, y1, x2, y2, matrix;
        for (const auto& [a, b] : in) {
            x1.push_back(a.x), y1.push_back(a.y), x2.push_back(b.x), y2.push_back(b.y);
            matrix.insert(matrix.end(), {a.x, a.y, b.x, b.y, -1});
        }
        const auto same = [&](const SegmentsView<double>& view) {
            const auto found = clipAll(view, window);
            return std::ranges::equal(expected, found,
                                      [](const auto& p, const auto& q) { return sameBits(p, q); });
        };
        QVERIFY(same(columns(x1, y1, x2, y2)));
        QVERIFY(same(rows(matrix.data(), in.size(), 5 * sizeof(double))));
        QVERIFY(same(in));

        struct Edge {
            int id;
            Point from, to;
        };
        std::vector<Edge> edges;
        for (const auto& [a, b] : in)
            edges.push_back({1, {0, a.x, a.y}, {0, b.x, b.y}});
        QVERIFY(same(structs(edges, &Edge::from, &Edge::to)));
        QCOMPARE(structs(std::vector<Edge>{}, &Edge::from, &Edge::to).size(), 0u);

        QVERIFY(clipAll(rows<double>(nullptr, 0), window).empty());

        // From the end to the start.
        const auto backwards = clipAll(rows(matrix.data() + 5 * (in.size() - 1), in.size(),
                                            -5 * std::ptrdiff_t(sizeof(double))),
                                       window);
        QCOMPARE(backwards.size(), expected.size());
        QVERIFY(sameBits(backwards.front().segment, expected.back().segment));
    }

    void aShortOutputIsFilledAndNotOverrun()
    {
        const auto in = someSegments(1000);
        const auto expected = clipAll(in, window);
        for (const std::size_t room : {0, 1, 3, 64, 255, 256, 300}) {
            std::vector<Clipped> found(room + 1);
            const Clipped guard{{{9, 9}, {9, 9}}, 9, 9};
            found.back() = guard;
            std::vector<Clipped> together;
            for (std::size_t at = 0; at < in.size() && room > 0;) {
                const auto done = clipAll(SegmentsView<double>(in).from(at), window,
                                          std::span(found).first(room));
                QVERIFY(done.segments > 0);
                QVERIFY(sameBits(found.back(), guard));
                for (Clipped piece : std::span(found).first(done.visible)) {
                    piece.source += static_cast<std::uint32_t>(at);
                    together.push_back(piece);
                }
                at += done.segments;
            }
            QVERIFY(room == 0
                    || std::ranges::equal(together, expected, [](const auto& p, const auto& q) {
                           return sameBits(p, q);
                       }));
        }
        QCOMPARE(clipAll(in, window, std::span<Clipped>{}), Progress{});
        std::vector<std::uint8_t> mask(10);
        QCOMPARE(clipAll(in, window, mask).segments, 10u);
    }

    void moreThanSourcesCanCountAreLeftForTheNextCall()
    {
        const Segment outside{{5, 5}, {6, 6}};
        const auto& [a, b] = outside;
        const SegmentsView<double> endless(&a.x, &a.y, &b.x, &b.y, tooMany + 5, 0);
        QCOMPARE(endless.from(tooMany - 1).size(), 6u);
        std::vector<std::uint8_t> mask(3);
        QCOMPARE(clipAll(endless, window, mask), (Progress{3, 0}));
    }
};

} // namespace clip_all_test

TEST_CLASS(clip_all_test::ClipAllTest, None)
#include "tests/clipping/clip_all_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// The one header for those who only want to clip, against whole numbers of any length.
#include "clipping/algorithm.h"
#include "clipping/outcode.h"

#include <QTest>

#include <clearcut/clip.h>

#include "tests/clipping/contract.h"
#include "tests/clipping/line_or_ray_contract.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace clip_test {

using namespace clearcut;

namespace {

/// A selection of the inputs of all families.
std::vector<Input> selected(std::span<const Family> from)
{
    std::vector<Input> all;
    for (const Family& family : from) {
        const auto& inputs = family.inputs();
        const std::size_t step = std::max<std::size_t>(1, inputs.size() / 2'000);
        for (std::size_t i = 0; i < inputs.size(); i += step)
            all.push_back(inputs[i]);
    }
    return all;
}

BasicSegment<float> inFloat(const Segment& s) { return {glm::vec2(s.a), glm::vec2(s.b)}; }
BasicWindow<float> inFloat(const Window& w) { return {glm::vec2(w.min), glm::vec2(w.max)}; }
template <class S>
std::optional<Segment> inDouble(const std::optional<S>& s)
{
    return s ? std::optional(Segment{glm::dvec2(s->a), glm::dvec2(s->b)}) : std::nullopt;
}

} // namespace

class ClipTest : public QObject {
    Q_OBJECT

private slots:
    void aSegmentIsClippedAsTheOracleSays()
    {
        for (const Input& input : selected(families())) {
            const auto wrong =
                fault<2>(clip(input.segment, input.window), input, truthOf<2>(input), 0.5);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(input)).c_str());
        }
    }

    void soIsOneOfFloats()
    {
        for (const Input& input : selected(singleFamilies())) {
            const auto found = clip(inFloat(input.segment), inFloat(input.window));
            const auto wrong =
                fault<2>(inDouble(found), input, truthOf<2>(input), 0.5, oracle::Number::Single);
            VERIFY_OR_SAY(wrong.empty(), (wrong + " for " + exactly(input)).c_str());
        }
    }

    void aLineAndARayKeepTheContractOfTheirRow()
    {
        const double k = findAlgorithm(algorithmFor<Line>)->ulps;
        for (const Input& input : selected(families())) {
            const auto& [s, window] = input;
            const auto line = lineOrRayFault(clip(Line{s.a, s.b}, window), input, false, k);
            const auto ray = lineOrRayFault(clip(Ray{s.a, s.b}, window), input, true, k);
            VERIFY_OR_SAY((line + ray).empty(), (line + ray + " for " + exactly(input)).c_str());
        }
    }

    void ofFloatsTheyAreThoseOfDoubleRounded()
    {
        for (const Input& input : selected(singleFamilies())) {
            const auto s = inFloat(input.segment);
            const auto w = inFloat(input.window);
            const auto rounded = [](const std::optional<Segment>& piece) {
                return piece ? std::optional(inFloat(*piece)) : std::nullopt;
            };
            QVERIFY(clip(BasicLine<float>{s.a, s.b}, w)
                    == rounded(clip(Line{input.segment.a, input.segment.b}, input.window)));
            QVERIFY(clip(BasicRay<float>{s.a, s.b}, w)
                    == rounded(clip(Ray{input.segment.a, input.segment.b}, input.window)));
        }
    }

    void itSaysWhichRowItTakes()
    {
        QCOMPARE(algorithmFor<Segment>, std::string_view("exact"));
        QCOMPARE(algorithmFor<BasicSegment<float>>, std::string_view("exact"));
        QCOMPARE((algorithmFor<Line, ConvexWindow>), std::string_view("exact"));
        for (const Algorithm& row : algorithms()) {
            QVERIFY(row.key != algorithmFor<Line> || row.line);
            QVERIFY(row.key != algorithmFor<Ray> || row.ray);
            QVERIFY(row.key != algorithmFor<Segment3> || row.box);
        }
        const Window window{{0, 0}, {3, 1}};
        const Line line{{-1, 5}, {7, -6.3}};
        QVERIFY(clip(line, window) == findAlgorithm(algorithmFor<Line>)->line->clip(line, window));
        const Segment3 diagonal{{-2, -2, -2}, {2, 2, 2}};
        const Window3 box{{-1, -1, -1}, {1, 1, 1}};
        QVERIFY(clip(diagonal, box)
                == findAlgorithm(algorithmFor<Segment3>)->box->clip(diagonal, box));
    }

    void aPolylineIsClippedAsByItsOwnHeader()
    {
        const std::vector<glm::dvec2> points{{-2, 0}, {0, 0}, {0, 3}, {3, 0}, {0.5, 0.5}};
        const Window window{{-1, -1}, {1, 1}};
        for (const bool closed : {false, true}) {
            PolylineRuns expected;
            (closed ? clipClosedPolyline : clipPolyline)(points, window, expected);
            const VisibleRuns runs = clip(Polyline{points, closed}, window);
            QCOMPARE(runs.size(), expected.runs.size());
            for (std::size_t i = 0; i < runs.size(); ++i) {
                const auto& run = expected.runs[i];
                QVERIFY(std::ranges::equal(
                    runs[i], std::span(expected.points).subspan(run.first, run.count)));
                QCOMPARE(runs.run(i).source, run.source);
            }
        }
    }

    void aPolylineOfFloatsIsClippedToo()
    {
        const std::vector<glm::vec2> points{{-2, 0}, {0, 0}, {0, 3}};
        const auto runs = clip(BasicPolyline<float>{points}, BasicWindow<float>{{-1, -1}, {1, 1}});
        QCOMPARE(runs.size(), 1u);
        QVERIFY(std::ranges::equal(runs[0], std::vector<glm::vec2>{{-1, 0}, {0, 0}, {0, 1}}));
    }

    void anyPointWillDo()
    {
        struct Named {
            int x, y;
        };
        struct Asked {
            double x() const { return 1.5; }
            double y() const { return 2; }
        };
        static_assert(pointOf(Named{1, 2}) == glm::dvec2(1, 2));
        static_assert(pointOf(std::array{1.5F, 2.F}) == glm::vec2(1.5, 2));
        static_assert(windowOf(Named{3, 0}, Named{0, 4}) == Window{{0, 0}, {3, 4}});
        QCOMPARE(pointOf(Asked{}).x, 1.5);
        QCOMPARE(pointOf(QPointF(3, 4)).y, 4.0);
        const auto piece = clip(QPointF(-2, 0), QPointF(2, 0), Window{{-1, -1}, {1, 1}});
        QVERIFY(piece && *piece == (Segment{{-1, 0}, {1, 0}}));
    }

    // What a compiler can compute: everything but clipping itself, which needs the compiled
    // library.
    void viewsEdgesAndOutcodesAreConstants()
    {
        static constexpr std::array<double, 8> numbers{0, 0, 1, 1, 2, 2, 3, 3};
        static_assert(rows(numbers.data(), 2).size() == 2);
        static_assert(columns(numbers, numbers, numbers, numbers).size() == 8);
        static_assert(asLines(rows(numbers.data(), 2)).size() == 2);
        static constexpr std::array<Segment, 1> segments{Segment{{0, 0}, {1, 1}}};
        static_assert(SegmentsView<double>(segments).size() == 1);
        static_assert(outcodeOf(glm::dvec2(2, 0), Window{{-1, -1}, {1, 1}}) == outcode::right);
        static_assert(cutEdgeOfB(cutAt(Edge::Left, Edge::Top)) == Edge::Top);
        static_assert(levelOf(Edge::Top, Window{{-1, -1}, {1, 2}}) == 2);
    }

    void clippingNeverThrows()
    {
        static_assert(noexcept(clip(Segment{}, Window{})));
        static_assert(noexcept(clip(Segment{}, ConvexWindow{})));
        static_assert(noexcept(clip(Ray{}, ConvexWindow{})));
        static_assert(noexcept(clip(BasicLine<float>{}, BasicWindow<float>{})));
        static_assert(noexcept(clip(QPointF(), QPointF(), Window{})));
        static_assert(noexcept(clipAll(SegmentsView<double>{}, Window{}, std::span<Clipped>{})));
        static_assert(noexcept(clipAll(LinesView<float>{}, ConvexWindow{},
                                       std::span<BasicClipped<BasicSegment<float>>>{})));
        static_assert(noexcept(algorithms())&& noexcept(findAlgorithm("md")));
        static_assert(noexcept(outcodeOf(glm::dvec2(), Window{})));
        static_assert(CLEARCUT_VERSION
                      == CLEARCUT_VERSION_MINOR * 100 + CLEARCUT_VERSION_PATCH
                             + CLEARCUT_VERSION_MAJOR * 10000);
    }
};

} // namespace clip_test

TEST_CLASS(clip_test::ClipTest, None)
#include "tests/clipping/clip_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines against the oracle, segment by segment.
#include "clipping/polyline.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/clipping/contract.h"
#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace polyline_test {

using namespace clipping;
using glm::dvec2;

namespace {

using Points = std::vector<dvec2>;

enum class Kind { Open, Closed };

PolylineRuns clipped(Kind kind, const Points& points, const Window& window)
{
    PolylineRuns out;
    (kind == Kind::Open ? clipPolyline : clipClosedPolyline)(points, window, out);
    return out;
}
bool finite(const dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool contains(const Window& w, const dvec2& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

/// A run as the truth about each segment by itself has it.
struct TrueRun {
    std::size_t source;
    Points points;
    bool cutAtBegin, cutAtEnd;
};

/// The visible runs of a polyline, joined where a point of it is inside, and at last over the
/// start.
std::vector<TrueRun> trueRuns(Kind kind, const Points& points, const Window& w)
{
    std::vector<TrueRun> runs;
    const std::size_t n = points.size();
    bool open = false; // the last run has come to the point where the next segment begins
    for (std::size_t i = 0; i + (kind == Kind::Open) < n; ++i) {
        const Segment s{points[i], points[(i + 1) % n]};
        const auto truth =
            finite(s.a) && finite(s.b) ? truthOf(Input{s, w}) : std::optional<oracle::Part>{};
        if (!truth) {
            open = false;
            continue;
        }
        const dvec2 a{truth->line.a.x, truth->line.a.y}, b{truth->line.b.x, truth->line.b.y};
        if (!open)
            runs.push_back({i, {a}, truth->newA, false});
        runs.back().points.push_back(b);
        runs.back().cutAtEnd = truth->newB;
        open = contains(w, s.b);
    }
    const bool whole = std::ranges::all_of(points, [&](const dvec2& p) { return contains(w, p); });
    if (kind == Kind::Closed && runs.size() > 1 && open && contains(w, points[0]) && !whole) {
        const TrueRun first = runs.front();
        auto& last = runs.back();
        last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
        last.cutAtEnd = first.cutAtEnd;
        runs.erase(runs.begin());
    }
    return runs;
}

/// Without points that follow themselves.
Points withoutRepeats(Points points)
{
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

bool isOn(Edge edge, const dvec2& p, const Window& w)
{
    return edge != Edge::NoEdge && p[axisOf(edge)] == levelOf(edge, w);
}

/// How the runs differ from the exact ones; empty if they do not.
std::string fault(const PolylineRuns& all, std::vector<TrueRun> truth, const Points& points,
                  const Window& w)
{
    auto runs = all.runs;
    std::ranges::sort(runs, {}, &VisibleRun::source); // a closed one may begin anywhere
    if (runs.size() != truth.size())
        return "another number of runs: " + std::to_string(runs.size()) + " for "
               + std::to_string(truth.size());
    std::size_t total = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const VisibleRun& run = runs[i];
        total += run.count;
        if (run.source != truth[i].source)
            return "begins on another segment";
        if (run.count == 0 || run.first + run.count > all.points.size())
            return "not its points";
        const auto first = all.points.begin() + std::ptrdiff_t(run.first);
        const Points is(first, first + std::ptrdiff_t(run.count));
        if (withoutRepeats(is) != withoutRepeats(truth[i].points))
            return "other points";
        if (truth[i].cutAtBegin ? !isOn(run.begin, is.front(), w) : run.begin != Edge::NoEdge)
            return "another edge at the begin";
        if (truth[i].cutAtEnd ? !isOn(run.end, is.back(), w) : run.end != Edge::NoEdge)
            return "another edge at the end";
    }
    if (total != all.points.size())
        return "points of no run";
    // No point of the polyline is lost or doubled: each inner point occurs equally often.
    for (const dvec2& p : points)
        if (std::ranges::all_of(points, finite) && contains(w, p)
            && std::ranges::count(all.points, p) < std::ranges::count(points, p))
            return "a point of the polyline is lost";
    return {};
}

std::string text(Kind kind, const Points& points, const Window& w)
{
    std::string all = kind == Kind::Open ? "open" : "closed";
    for (const dvec2& p : points)
        all += " (" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
    return all + " in " + exactly(Input{{w.min, w.max}, w});
}

std::string wrong(const Points& points, const Window& w)
{
    for (const Kind kind : {Kind::Open, Kind::Closed}) {
        const auto what =
            points.size() == 1 || points.empty()
                ? ""
                : fault(clipped(kind, points, w), trueRuns(kind, points, w), points, w);
        if (!what.empty())
            return what + " for " + text(kind, points, w);
    }
    return {};
}

constexpr Window unit{{0, 0}, {1, 1}};
constexpr Window square{{1, 1}, {3, 3}};

} // namespace

class PolylineTest : public QObject {
    Q_OBJECT

private slots:
    void everyPolylineOfThreePointsOnTheGrid()
    {
        constexpr int n = 5;
        const auto at = [](int i) { return dvec2(i % n, i / n); };
        for (const Window& w :
             {square, Window{{1, 2}, {3, 2}}, Window{{2, 2}, {2, 2}}, Window{{0, 0}, {4, 4}}})
            for (int i = 0; i < n * n * n * n * n * n; ++i) {
                const Points points{at(i % 25), at(i / 25 % 25), at(i / 625)};
                const auto what = wrong(points, w);
                QVERIFY2(what.empty(), what.c_str());
            }
    }

    void longPolylinesOnTheGrid()
    {
        Random r(41);
        for (int round = 0; round < 3'000; ++round) {
            Points points(std::size_t(r.whole(2, round % 50 ? 20 : 700)));
            for (dvec2& p : points)
                p = {r.whole(0, 6), r.whole(0, 6)};
            const auto what = wrong(points, {{1, 1}, {r.whole(1, 5), r.whole(1, 5)}});
            QVERIFY2(what.empty(), what.c_str());
        }
    }

    void walks()
    {
        Random r(42);
        for (int round = 0; round < 2'000; ++round) {
            const double step = std::ldexp(1.0, r.whole(-6, 3));
            Points points(std::size_t(r.whole(2, round % 50 ? 40 : 2'000)));
            dvec2 p{r.unit(), r.unit()};
            for (dvec2& q : points) {
                p += step * dvec2{r.between(-1, 1), r.between(-1, 1)};
                q = p = glm::dvec2{std::clamp(p.x, -2.0, 3.0), std::clamp(p.y, -2.0, 3.0)};
            }
            const auto what = wrong(points, unit);
            QVERIFY2(what.empty(), what.c_str());
        }
    }

    void anyNumbers()
    {
        Random r(43);
        for (int round = 0; round < 3'000; ++round) {
            Points points(std::size_t(r.whole(2, 12)));
            for (dvec2& p : points)
                p = {anyNumber(r), anyNumber(r)};
            if (r.whole(0, 3) == 0)
                points[points.size() / 2].y = r.whole(0, 1) ? NAN : INFINITY;
            const dvec2 p{anyNumber(r), anyNumber(r)}, q{anyNumber(r), anyNumber(r)};
            const auto what = wrong(points, {{std::min(p.x, q.x), std::min(p.y, q.y)},
                                             {std::max(p.x, q.x), std::max(p.y, q.y)}});
            QVERIFY2(what.empty(), what.c_str());
        }
    }

    void anInnerPolylineIsOneRunOfAllItsPoints()
    {
        const Points points{{0, 0}, {0.5, 0.5}, {0.5, 0.5}, {-0.0, 1}, {1, 0}};
        const auto open = clipped(Kind::Open, points, unit);
        QCOMPARE(open.runs.size(), std::size_t(1));
        QVERIFY(open.points == points && std::signbit(open.points[3].x));
        QVERIFY(open.runs[0].begin == Edge::NoEdge && open.runs[0].end == Edge::NoEdge);
        auto round = points;
        round.push_back(points.front());
        QVERIFY(clipped(Kind::Closed, points, unit).points == round);
    }

    void aRunPassesTheStartOfAClosedPolyline()
    {
        const auto all =
            clipped(Kind::Closed, {{0.5, 0.5}, {2, 0.5}, {2, 0.75}, {0.5, 0.75}}, unit);
        QCOMPARE(all.runs.size(), std::size_t(1));
        QVERIFY((all.points == Points{{1, 0.75}, {0.5, 0.75}, {0.5, 0.5}, {1, 0.5}}));
        QCOMPARE(all.runs[0].source, 2U);
        QVERIFY(all.runs[0].begin == Edge::Right && all.runs[0].end == Edge::Right);
    }

    void contactsAreRunsOfOnePoint()
    {
        for (const Points& points : {Points{{0, 2}, {1, 2}, {0, 3}}, // with a point of its own
                                     Points{{0, 2}, {2, 0}}}) {      // with a segment, at a corner
            const auto all = clipped(Kind::Open, points, square);
            QCOMPARE(all.runs.size(), std::size_t(1));
            QCOMPARE(all.points.size(), std::size_t(1));
            QCOMPARE(all.runs[0].source, 0U);
            QVERIFY(isOn(all.runs[0].begin, all.points[0], square));
            QVERIFY(isOn(all.runs[0].end, all.points[0], square));
        }
    }

    // Also where the window's own number has another sign.
    void aContactPointKeepsItsBits()
    {
        const auto all = clipped(Kind::Open, {{-1, 0}, {-0.0, 0.5}, {-1, 1}}, unit);
        QVERIFY((all.points == Points{{0, 0.5}}));
        QVERIFY(std::signbit(all.points[0].x));
    }

    void aRunFollowsAnEdge()
    {
        const auto all = clipped(Kind::Open, {{0, 0}, {1, 2}, {1, 3}, {0, 4}}, square);
        QCOMPARE(all.runs.size(), std::size_t(1));
        QVERIFY((all.points == Points{{1, 2}, {1, 3}}));
        QVERIFY(all.runs[0].begin == Edge::Left && all.runs[0].end == Edge::Left);
        QCOMPARE(all.runs[0].source, 0U);
    }

    void emptyAndSinglePointPolylines()
    {
        for (const Kind kind : {Kind::Open, Kind::Closed}) {
            QVERIFY(clipped(kind, {}, unit).runs.empty());
            QVERIFY(clipped(kind, {{2, 2}}, unit).runs.empty());
            QVERIFY(clipped(kind, {{0.5, NAN}}, unit).runs.empty());
            QVERIFY(clipped(kind, {{0.5, 0.5}, {0.5, 0.25}}, {{1, 1}, {0, 0}}).runs.empty());
        }
        const auto open = clipped(Kind::Open, {{0.5, 1}}, unit);
        QVERIFY((open.points == Points{{0.5, 1}}) && open.runs.at(0).count == 1);
        const auto closed = clipped(Kind::Closed, {{0.5, 1}}, unit);
        QVERIFY((closed.points == Points{{0.5, 1}, {0.5, 1}}) && closed.runs.at(0).count == 2);
    }

    void theBufferIsReplacedAndItsMemoryReused()
    {
        PolylineRuns out{{{7, 7}}, {{0, 1, 0, Edge::NoEdge, Edge::NoEdge}}};
        Points points;
        for (int i = 0; i < 1'000; ++i)
            points.push_back({0.5, i % 4 - 1});
        clipPolyline(points, unit, out);
        const auto* memory = out.points.data();
        const auto* runs = out.runs.data();
        const auto before = out.points;
        clipPolyline(points, unit, out);
        QVERIFY(out.points == before && out.points.data() == memory && out.runs.data() == runs);
        clipPolyline({}, unit, out);
        QVERIFY(out.points.empty() && out.runs.empty());
    }
};

} // namespace polyline_test

TEST_CLASS(polyline_test::PolylineTest, None)
#include "tests/clipping/polyline_test.moc"

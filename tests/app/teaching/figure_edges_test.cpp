// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/edge_labels.h"
#include "app/teaching/figure_edges.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/scale_bar.h"

#include <QGuiApplication>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace teaching_figure_edges_test {

using namespace app;
using clipping::Edge;
using At = EdgePlace::At;

namespace {

constexpr std::array all{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};
const QSizeF stage(934, 590);

QFont usualFont()
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return font;
}

TracedLine tracedAt(const clipping::Segment& line, const clipping::Window& window,
                    YAxis y = YAxis::Down)
{
    return {.line = line, .window = window, .y = y, .unit = QStringLiteral("mm")};
}

FigureFrame magnified(const TracedLine& traced) { return nearFrame(traced, stage, usualFont()); }

/// Whether a line's extension meets an edge's line inside the picture.
bool isCrossed(const TracedLine& traced, Edge edge, const FigureFrame& frame)
{
    const auto& [a, b] = traced.line;
    const glm::length_t axis = clipping::axisOf(edge);
    const double t = (clipping::levelOf(edge, traced.window) - a[axis]) / (b[axis] - a[axis]);
    return std::isfinite(t) && frame.shows(a + t * (b - a));
}

QStringList textsOf(const TracedLine& traced)
{
    const Narration narration;
    QStringList texts;
    for (const FigureLabel& label :
         figureLabels(traced, narration, stepScene(traced, narration, 0), magnified(traced)))
        texts << label.head + u'|' + label.detail;
    return texts;
}

} // namespace

class FigureEdgesTest : public QObject {
    Q_OBJECT

    std::mt19937_64 random_{12};

    TracedLine anyLineAndWindow()
    {
        std::uniform_real_distribution<double> anywhere(-100, 100), power(-4, 2);
        const auto point = [&] { return Point(anywhere(random_), anywhere(random_)); };
        const Point a = point(), one = point(), other = point();
        return tracedAt({a, a + std::pow(10, power(random_)) / 100 * point()},
                        {glm::min(one, other), glm::max(one, other)},
                        random_() % 2 ? YAxis::Up : YAxis::Down);
    }

private slots:
    void edgesInSightAreToScaleTheOthersAtTheRim()
    {
        std::array<int, 3> found{};
        for (int i = 0; i < 5000; ++i) {
            const TracedLine traced = anyLineAndWindow();
            const FigureFrame frame = magnified(traced);
            const FigureEdges edges(traced, frame);
            for (const Edge edge : all) {
                const glm::length_t axis = clipping::axisOf(edge);
                const double level = clipping::levelOf(edge, traced.window);
                const double length = axis == 0 ? stage.width() : stage.height();
                const QPointF place = frame.at({level, level});
                const double its = axis == 0 ? place.x() : place.y();
                const EdgePlace& drawn = edges[edge];
                ++found[std::size_t(drawn.at)];
                const bool inSight = level >= frame.seen.min[axis] && level <= frame.seen.max[axis];
                QCOMPARE(drawn.at == At::Scale, inSight);
                if (isCrossed(traced, edge, frame))
                    QVERIFY(drawn.at == At::Scale);
                if (drawn.at == At::Scale)
                    QCOMPARE(drawn.place, its);
                if (drawn.at == At::Rim) {
                    QCOMPARE(drawn.place, its < 0 ? 48 : length - 48);
                    QVERIFY(drawn.further && *drawn.further > 0);
                }
                if (drawn.at == At::Away)
                    QVERIFY(drawn.place < 0 || drawn.place > length);
            }
            // The window is not inverted, and its nearest edge is in sight.
            const bool up = traced.y == YAxis::Up;
            QVERIFY(edges[Edge::Left].place < edges[Edge::Right].place);
            QVERIFY(edges[up ? Edge::Top : Edge::Bottom].place
                    < edges[up ? Edge::Bottom : Edge::Top].place);
            for (const auto& [one, other] :
                 {std::pair(Edge::Left, Edge::Right), std::pair(Edge::Bottom, Edge::Top)})
                QVERIFY(edges[one].at != At::Away || edges[other].at != At::Away);
        }
        for (const int number : found)
            QVERIFY(number > 200);
    }
    void edgesAtTheRimAreNeverAcrossTheLine() // however it is zoomed and panned
    {
        std::uniform_real_distribution<double> share(-0.5, 0.5), zoom(0.1, 4);
        int atRim = 0;
        for (int i = 0; i < 5000; ++i) {
            const TracedLine traced = anyLineAndWindow();
            FigureFrame frame = magnified(traced);
            const Point size = frame.seen.max - frame.seen.min;
            const Point middle = (frame.seen.min + frame.seen.max) / 2.0
                                 + Point(share(random_), share(random_)) * size;
            const double times = zoom(random_) / 2;
            frame.seen = {middle - times * size, middle + times * size};
            const FigureEdges edges(traced, frame);
            const auto part = frame.part(traced.line);
            for (const Edge edge : all) {
                if (edges[edge].at != At::Rim)
                    continue;
                ++atRim;
                const auto line = edges.line(edge);
                QVERIFY(line);
                QVERIFY(!part || part->intersects(*line, nullptr) != QLineF::BoundedIntersection);
            }
        }
        QVERIFY(atRim > 1000);
    }
    void aLineAtTheLeftEdge() // the picture of the design
    {
        const TracedLine traced =
            tracedAt({{41.2, 117.5}, {63.8, 104.1}}, {{48.5, 73.5}, {248.5, 223.5}});
        const FigureEdges edges(traced, magnified(traced));
        QVERIFY(edges[Edge::Left].at == At::Scale);
        QVERIFY(!edges.areToScale());
        for (const auto& [edge, further] :
             {std::pair(Edge::Right, 184.7), std::pair(Edge::Bottom, 30.6),
              std::pair(Edge::Top, 106.0)}) {
            QVERIFY(edges[edge].at == At::Rim);
            QVERIFY(std::abs(*edges[edge].further - further) < 1e-9);
        }
        QCOMPARE(edges.window(), QRectF(QPointF(edges[Edge::Left].place, 48), QPointF(886, 542)));
        QCOMPARE(edges.beyond(Edge::Left), QRectF(0, 0, edges[Edge::Left].place, 590));
        QCOMPARE(edges.beyond(Edge::Top), QRectF(0, 542, 934, 48));
        // Two on the left side, one on each of the others.
        const auto breaks = edges.breaks();
        QCOMPARE(breaks.size(), std::size_t(5));
        QCOMPARE(std::ranges::count(breaks, edges[Edge::Left].place,
                                    [](const auto& mark) { return mark.place.x(); }),
                 2);
        QCOMPARE(std::ranges::count(breaks, true, &FigureEdges::Break::acrossVertical), 3);
        const QStringList texts = textsOf(traced);
        for (const char* text :
             {"xmin = 48.5|", "xmax = 248.5|185 mm further", "ymin = 73.5|30.6 mm further up",
              "ymax = 223.5|106 mm further down"})
            QVERIFY2(texts.contains(QLatin1StringView(text)), text);
    }
    void aWindowInSightHasNoBreaks()
    {
        const TracedLine traced = tracedAt({{-5, 5}, {15, 6}}, {{0, 0}, {10, 10}});
        const FigureEdges edges(traced, magnified(traced));
        QVERIFY(edges.areToScale() && edges.breaks().empty());
    }
    void aLineFarOutsideHasTheNearestEdgeInSight()
    {
        const TracedLine traced = tracedAt({{150, 50}, {152, 51}}, {{0, 0}, {100, 100}});
        const FigureEdges edges(traced, magnified(traced));
        QVERIFY(edges[Edge::Right].at == At::Rim && edges[Edge::Right].inward > 0);
        QVERIFY(edges[Edge::Left].at == At::Away && !edges.line(Edge::Left));
        QCOMPARE(edges[Edge::Right].further.value(), 50);
        QCOMPARE(edges.side(Edge::Bottom).value(), QLineF(0, 48, 48, 48));
        QCOMPARE(edges.beyond(Edge::Right), QRectF(48, 0, 886, 590));
        QVERIFY(edges.beyond(Edge::Left).isEmpty());
        // Above the window, ymin is further down.
        QVERIFY(textsOf(tracedAt({{30, 50}, {34, 53}}, {{48, 73}, {248, 223}}))
                    .contains(QStringLiteral("ymin = 73|20 mm further down")));
    }
    void anyNumbersHaveFinitePlaces()
    {
        const double big = std::numeric_limits<double>::max();
        for (const clipping::Segment& line : {clipping::Segment{{0, 0}, {1, 1}},
                                              {{1e9, 1e9}, {1e9 + 3, 1e9}},
                                              {{5, 5}, {5, 5}},
                                              {{1e300, 0}, {-1e300, 1}},
                                              {{0, 0}, {1e-250, 0}}})
            for (const clipping::Window& window :
                 {clipping::Window{{-1e300, -1e300}, {1e300, 1e300}},
                  {{-big, -big}, {big, big}},
                  {{7, 7}, {7, 7}},
                  {{0, 1}, {0, 2}},
                  {{9, 9}, {3, 3}},
                  {{-INFINITY, 0}, {INFINITY, 1}},
                  {{std::nan(""), 0}, {3, 1}}}) {
                const TracedLine traced = tracedAt(line, window);
                const FigureEdges edges(traced, magnified(traced));
                for (const Edge edge : all) {
                    QVERIFY(std::isfinite(edges[edge].place));
                    QVERIFY(std::isfinite(edges[edge].further.value_or(0)));
                    if (const auto side = edges.side(edge))
                        QVERIFY(magnified(traced)
                                    .picture()
                                    .adjusted(-1e6, -1e6, 1e6, 1e6)
                                    .contains(side->p1())
                                && std::isfinite(side->length()));
                }
            }
    }
    void labelsAndMarksAreApart()
    {
        for (int i = 0; i < 1500; ++i) {
            const TracedLine traced = anyLineAndWindow();
            const FigureFrame frame = magnified(traced);
            const Narration narration;
            const auto labels =
                figureLabels(traced, narration, stepScene(traced, narration, 0), frame);
            const FigureEdges edges(traced, frame);
            const auto bar = scaleBarOf(traced, frame);
            QVERIFY(bar);
            for (auto label = labels.begin(); label != labels.end(); ++label) {
                QVERIFY(frame.picture().contains(label->box));
                QVERIFY(!bar->box.intersects(label->box));
                QVERIFY(std::none_of(labels.begin(), label, [&](const FigureLabel& other) {
                    return other.box.intersects(label->box);
                }));
                for (const FigureEdges::Break& mark : edges.breaks())
                    QVERIFY(!edges.boxOf(mark).intersects(label->box));
            }
        }
    }
    void scaleBarsAreRound()
    {
        const TracedLine traced = tracedAt({{0, 0}, {11, 3}}, {{-99, -99}, {99, 99}});
        const FigureFrame frame = magnified(traced);
        const auto bar = scaleBarOf(traced, frame);
        QVERIFY(bar);
        QCOMPARE(bar->text, "1 mm");
        const Point from = frame.pointAt(bar->line.p1()), to = frame.pointAt(bar->line.p2());
        QVERIFY(std::abs(to.x - from.x - 1) < 1e-9);
        QVERIFY(bar->box.left() < 20 && bar->box.bottom() > stage.height() - 10);
        QVERIFY(!scaleBarOf(traced, figureFrame(traced, stage, usualFont())));
    }
};

} // namespace teaching_figure_edges_test

TEST_CLASS(teaching_figure_edges_test::FigureEdgesTest, Gui)
#include "tests/app/teaching/figure_edges_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/flatten.h"
#include "app/drawing/freehand.h"
#include "app/view/picking.h"

#include <QElapsedTimer>
#include <QTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace drawing_freehand_test {

using namespace app;

class FreehandTest : public QObject {
    Q_OBJECT

    using Stroke = std::vector<Point>;

    static double farthest(const Stroke& stroke, const Subpath& path, double tolerance)
    {
        std::vector<Chord> chords;
        flatten(path, tolerance / 100, chords);
        double most = 0;
        for (const Point& p : stroke) {
            double nearest = HUGE_VAL;
            for (const Chord& chord : chords)
                nearest = std::min(nearest, distance(p, chord.segment));
            most = std::max(most, nearest);
        }
        return most;
    }
    /// A stroke as a mouse sees it: whole pixels.
    template <class Curve>
    static Stroke drawn(int points, const Curve& curve)
    {
        Stroke stroke;
        for (int i = 0; i < points; ++i)
            if (const Point p = glm::round(Point(curve(double(i) / (points - 1))));
                stroke.empty() || p != stroke.back())
                stroke.push_back(p);
        return stroke;
    }

private slots:
    void everyPointLiesWithinTheTolerance()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> turn(0, 0.4);
        for (const double tolerance : {0.5, 2.0, 10.0})
            for (int i = 0; i < 60; ++i) {
                Stroke stroke{{0, 0}};
                double way = 0;
                for (int k = 0; k < 300; ++k) {
                    way += turn(random);
                    stroke.push_back(stroke.back() + 3.0 * Point(std::cos(way), std::sin(way)));
                }
                const Subpath path = smoothed(stroke, tolerance);
                QCOMPARE(path.start, stroke.front());
                QCOMPARE(path.segments.back().to, stroke.back());
                QVERIFY(farthest(stroke, path, tolerance) <= tolerance);
                QVERIFY(path.segments.size() < stroke.size() / 2);
            }
    }
    void aWaveNeedsFewNodesAndMeetsItselfSmoothly()
    {
        const Stroke wave =
            drawn(400, [](double t) { return Point(400 * t, 50 * std::sin(4 * M_PI * t)); });
        const Subpath path = smoothed(wave, 2);
        QVERIFY2(path.segments.size() <= 8, qPrintable(QString::number(path.segments.size())));
        for (std::size_t i = 1; i < path.segments.size(); ++i) {
            const Point& at = path.segments[i - 1].to;
            const Point a = glm::normalize(at - path.segments[i - 1].control2),
                        b = glm::normalize(path.segments[i].control1 - at);
            QVERIFY(glm::dot(a, b) > 1 - 1e-9);
        }
    }
    void aCornerStaysACorner()
    {
        const Stroke corner = drawn(300, [](double t) {
            return t < 0.5 ? Point(200 * t, 0) : Point(100, 200 * (t - 0.5));
        });
        const Subpath path = smoothed(corner, 2);
        QCOMPARE(path.segments.size(), std::size_t(2));
        QVERIFY(glm::distance(path.segments[0].to, {100, 0}) <= 2);
    }
    void aStraightStrokeIsOneLine()
    {
        const Stroke straight = drawn(100, [](double t) { return Point(300 * t, 0); });
        const Subpath path = smoothed(straight, 1);
        QCOMPARE(path.segments, (std::vector<PathSegment>{{{300, 0}}}));
        QCOMPARE(smoothed(Stroke{{1, 2}, {3, 4}}, 1).segments,
                 (std::vector<PathSegment>{{{3, 4}}}));
    }
    void finerIsNearer()
    {
        const Stroke wave =
            drawn(400, [](double t) { return Point(400 * t, 90 * std::sin(9 * t * t)); });
        QVERIFY(smoothed(wave, 0.5).segments.size() > smoothed(wave, 8).segments.size());
    }
    void aStrokeIsFittedWhileItIsDrawn()
    {
        constexpr int count = 1'000'000;
        const auto at = [](int i) {
            return Point(i * 0.5 + 20 * std::cos(i * 0.03), 300 * std::sin(i * 0.002));
        };
        Freehand freehand(at(0), 2);
        QElapsedTimer clock;
        qint64 longest = 0; // nanoseconds
        for (int i = 1; i < count; ++i) {
            clock.start();
            freehand.add(at(i));
            longest = std::max(longest, clock.nsecsElapsed());
        }
        clock.start();
        const Subpath path = freehand.path();
        qInfo("%d points: at most %.1f ms a point, %.1f ms at the end, %zu nodes", count,
              double(longest) / 1e6, double(clock.nsecsElapsed()) / 1e6, path.segments.size());
        QVERIFY(path.segments.size() < count / 5);
    }
    void curvesThatAreFittedEarlierMeetSmoothly()
    {
        Stroke wave;
        for (int i = 0; i < 20'000; ++i)
            wave.emplace_back(i * 0.5, 200 * std::sin(i * 0.002) + 40 * std::sin(i * 0.011));
        const Subpath path = smoothed(wave, 2);
        QVERIFY(farthest(wave, path, 2) <= 2);
        QVERIFY2(path.segments.size() < 200, qPrintable(QString::number(path.segments.size())));
        for (std::size_t i = 1; i < path.segments.size(); ++i) {
            const Point& at = path.segments[i - 1].to;
            const Point a = glm::normalize(at - path.segments[i - 1].control2),
                        b = glm::normalize(path.segments[i].control1 - at);
            QVERIFY(glm::dot(a, b) > 1 - 1e-9);
        }
    }
    void aCornerNearAnEarlierFitStays()
    {
        Stroke zigzag;
        for (int i = 0; i < 200'000; ++i)
            zigzag.emplace_back(i * 0.7, std::abs(i % 600 - 300));
        const Subpath path = smoothed(zigzag, 2);
        QVERIFY2(path.segments.size() < 1400, qPrintable(QString::number(path.segments.size())));
        QVERIFY(farthest({zigzag.begin(), zigzag.begin() + 20'000}, path, 2) <= 2);
    }
};

} // namespace drawing_freehand_test

TEST_CLASS(drawing_freehand_test::FreehandTest, None)
#include "tests/app/drawing/freehand_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/polygon_edges.h"
#include "app/teaching/figure.h"
#include "app/teaching/figure_labels.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/step_scene.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <cmath>
#include <numbers>

#include "tests/clipping/random.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace teaching_polygon_test {

using namespace app;

namespace {

/// Corners on a circle, counterclockwise.
std::vector<Point> polygon(Random& random)
{
    std::vector<Point> corners;
    const int count = random.whole(3, 9);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.between(0, 0.9)) / count;
        corners.emplace_back(50 * std::cos(angle), 50 * std::sin(angle));
    }
    return corners;
}

TracedLine traced(const clipping::Algorithm& row, Random& random)
{
    TracedLine line{.variant = {&row}, .y = YAxis::Up, .corners = polygon(random)};
    line.window = {{-50, -50}, {50, 50}};
    const auto point = [&] { return Point(random.between(-80, 80), random.between(-80, 80)); };
    line.line = {point(), point()};
    return line;
}

} // namespace

class PolygonTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepHasASentenceAndALine()
    {
        Random random(1);
        std::size_t cuts = 0;
        for (int i = 0; i < 300; ++i)
            for (const clipping::Algorithm& row : clipping::algorithms()) {
                if (!row.polygon)
                    continue;
                const TracedLine line = traced(row, random);
                const Narration narration = narrationOf(line);
                QCOMPARE(narration.visible, row.polygon->clip(line.line, {line.corners}));
                QVERIFY(!notEmpty(narration.steps).empty());
                for (const NarratedStep& step : narration.steps) {
                    const QByteArray told = row.key.data() + step.sentence.toUtf8().prepend(": ");
                    QVERIFY2(step.sentence.endsWith(u'.') && !step.sentence.contains(u'%'), told);
                    QVERIFY2(step.line > 0 && step.line <= narration.code.size(), told);
                    QVERIFY2(step.polygonEdge <= line.corners.size(), told);
                    QVERIFY2(!step.sentence.contains("edge 0"), told);
                }
                const StepScene scene = stepScene(line, narration, narration.steps.size() - 1);
                for (const CutPoint& cut : scene.cuts) {
                    const auto [from, to] = polygonEdge(cut.polygonEdge, line.corners);
                    const Point along = to - from, at = cut.at - from;
                    QVERIFY(std::abs(along.x * at.y - along.y * at.x) < 1e-9);
                    ++cuts;
                }
            }
        QVERIFY(cuts > 500);
    }
    void theFigureShowsThePolygon()
    {
        Random random(2);
        const TracedLine line{.variant = {&clipping::exactAlgorithm()},
                              .line = {{-160, -30}, {70, 130}},
                              .window = {{-100, -75}, {100, 90}},
                              .y = YAxis::Up,
                              .corners = {{-100, -75}, {100, -75}, {0, 90}}};
        QImage picture(400, 300, QImage::Format_RGB32);
        QFont font;
        font.setPixelSize(13);
        const FigureFrame frame = figureFrame(line, picture.size(), font);
        const Narration narration = narrationOf(line);
        const FigureColours colours = figureColours(Ground::Light);
        QPainter painter(&picture);
        paintStep(painter, {line, narration, 0}, frame, colours);
        painter.end();
        const auto at = [&](const Point& p) { return picture.pixelColor(frame.at(p).toPoint()); };
        QCOMPARE(at({-70, -75}).name(), colours.window.name()); // on edge 1
        QVERIFY(at({-95, 80}) != colours.window.name());        // a corner of the box
    }
    void aMagnifiedLineSaysThatNoEdgeIsInSight()
    {
        QFont font;
        font.setPixelSize(13);
        const auto windowLabel = [&](const clipping::Segment& line) {
            const TracedLine traced{.variant = {&clipping::exactAlgorithm()},
                                    .line = line,
                                    .window = {{-100, -75}, {100, 90}},
                                    .y = YAxis::Up,
                                    .corners = {{-100, -75}, {100, -75}, {0, 90}}};
            const Narration narration = narrationOf(traced);
            const auto labels = figureLabels(traced, narration, stepScene(traced, narration, 0),
                                             nearFrame(traced, {900, 500}, font));
            return labels.back().head + u'|' + labels.back().detail;
        };
        QCOMPARE(windowLabel({{0, 0}, {2, 1}}), "Clip window|no edge is in sight");
        QCOMPARE(windowLabel({{0, -76}, {2, -74}}), "Clip window|");
        QCOMPARE(windowLabel({{-160, -30}, {70, 130}}), "Clip window|");
    }
};

} // namespace teaching_polygon_test

TEST_CLASS(teaching_polygon_test::PolygonTest, Gui)
#include "tests/app/teaching/polygon_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_edges.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/quiet_corner.h"
#include "app/teaching/scale_bar.h"

#include <QGuiApplication>
#include <QTest>

#include "tests/test_class.h"

namespace teaching_quiet_corner_test {

using namespace app;

namespace {

const QSizeF stage(934, 590), box(172, 150);

FigureFrame frameOf(const TracedLine& traced)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return nearFrame(traced, stage, font);
}

TracedLine inWindow(const clipping::Segment& line,
                    const clipping::Window& window = {{0, 0}, {1000, 700}})
{
    return {.variant = exactVariant(), .line = line, .window = window, .y = YAxis::Down};
}

CornerPlace placed(const TracedLine& traced)
{
    return quietCorner(box, traced, narrationOf(traced), frameOf(traced));
}

} // namespace

class QuietCornerTest : public QObject {
    Q_OBJECT

private slots:
    void theFirstOfEquals() // all edges are at the rim; the line leaves two corners free
    {
        QCOMPARE(placed(inWindow({{500, 310}, {510, 303}})).corner, Qt::TopLeftCorner);
        QCOMPARE(placed(inWindow({{500, 303}, {510, 310}})).corner, Qt::TopRightCorner);
        QCOMPARE(placed(inWindow({{500, 303}, {510, 303}})).covered, 0);
    }
    void whereNoEdgeIs() // the picture of the design: left of the window, inside the rim at the top
    {
        const TracedLine traced =
            inWindow({{41.2, 117.5}, {63.8, 104.1}}, {{48.5, 73.5}, {248.5, 223.5}});
        const CornerPlace place = placed(traced);
        QCOMPARE(place.corner, Qt::TopLeftCorner);
        QCOMPARE(place.covered, 0);
        QCOMPARE(place.box.topLeft(), QPointF(12, 66));
    }
    void awayFromTheLine()
    {
        // Above the window, from the left to the right: the lower corners hide less.
        TracedLine traced = inWindow({{-900, -600}, {1900, -590}});
        const CornerPlace below = placed(traced);
        QCOMPARE(below.corner, Qt::BottomRightCorner);
        traced.line = {{-900, 1290}, {1900, 1300}};
        QCOMPARE(placed(traced).corner, Qt::TopLeftCorner);
    }
    void noneOfThePlacesIsOnTheScaleBar()
    {
        const TracedLine traced = inWindow({{500, 310}, {510, 303}});
        const FigureFrame frame = frameOf(traced);
        const auto bar = scaleBarOf(traced, frame);
        QVERIFY(bar);
        for (const Qt::Corner corner :
             {Qt::TopLeftCorner, Qt::TopRightCorner, Qt::BottomLeftCorner, Qt::BottomRightCorner}) {
            const CornerPlace place = placeIn(corner, box, traced, narrationOf(traced), frame);
            QCOMPARE(place.corner, corner);
            QVERIFY(frame.picture().contains(place.box) && !place.box.intersects(bar->box));
            const FigureEdges edges(traced, frame);
            if (place.covered == 0)
                QVERIFY(edges.window().contains(place.box)); // inside of the rim
        }
    }
};

} // namespace teaching_quiet_corner_test

TEST_CLASS(teaching_quiet_corner_test::QuietCornerTest, Gui)
#include "tests/app/teaching/quiet_corner_test.moc"

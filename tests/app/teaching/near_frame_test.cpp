// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/finite.h"
#include "app/comparison/variants.h"
#include "app/teaching/near_frame.h"

#include <QGuiApplication>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/test_class.h"

namespace teaching_near_frame_test {

using namespace app;

namespace {

const QSizeF stage(934, 590);

QFont bodyFont()
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return font;
}

TracedLine traced(const clipping::Segment& line,
                  const clipping::Window& window = {{-100, -75}, {100, 75}})
{
    return {.line = line, .window = window, .y = YAxis::Up};
}

/// The share of the stage that a line's box takes.
QSizeF shareOf(const FigureFrame& frame, const clipping::Segment& line)
{
    const QRectF box = QRectF(frame.at(line.a), frame.at(line.b)).normalized();
    return {box.width() / frame.size.width(), box.height() / frame.size.height()};
}

} // namespace

class NearFrameTest : public QObject {
    Q_OBJECT

private slots:
    /// A misprint moves an end of a short line far beyond the line.
    void aWrongResultIsInSight()
    {
        TracedLine wrong = traced({{40, 70}, {44, 79}});
        const FigureFrame right = nearFrame(wrong, stage, bodyFont());
        wrong.variant = *findVariant("md-step-2");
        const auto piece = *clipped(wrong.variant, wrong.line, wrong.window);
        const FigureFrame frame = nearFrame(wrong, stage, bodyFont());
        const QRectF picture(QPointF(), stage);
        QVERIFY(!picture.contains(right.at(piece.b)));
        QVERIFY(picture.contains(frame.at(piece.a)) && picture.contains(frame.at(piece.b)));
        wrong.variant = *findVariant("matthes-drakopoulos");
        QVERIFY(nearFrame(wrong, stage, bodyFont()).seen == right.seen);
    }

    void theBoxFillsOneOfBothSides()
    {
        std::mt19937_64 random(9);
        std::uniform_real_distribution<double> power(-12, 12), size(50, 2000), part(-1, 1);
        for (int i = 0; i < 3000; ++i) {
            const double scale = std::pow(10, power(random));
            const auto point = [&] { return scale * Point(part(random), part(random)); };
            clipping::Segment line{point(), point()};
            if (i % 5 == 0)
                line.b[i % 2] = line.a[i % 2];
            if (i % 7 == 0)
                line.b = line.a + 1e-6 * (line.b - line.a);
            FigureFrame frame{
                .size = {size(random), size(random)}, .seen = {}, .y = YAxis::Down, .font = {}};
            const auto seen = magnifying(line, frame.size);
            QVERIFY(seen && isFinite(*seen));
            frame.seen = *seen;
            const QSizeF share = shareOf(frame, line);
            const double both = std::max(share.width() / 0.58, share.height() / 0.60);
            QVERIFY2(std::abs(both - 1) < 1e-3, QByteArray::number(both));
            const double across = (seen->max.x - seen->min.x) / frame.size.width(),
                         down = (seen->max.y - seen->min.y) / frame.size.height();
            QVERIFY(std::abs(across / down - 1) < 1e-3); // nothing is stretched
            QVERIFY(frame.shows(line.a) && frame.shows(line.b));
        }
    }
    void whatCannotBeMagnified()
    {
        const double big = std::numeric_limits<double>::max();
        QVERIFY(!magnifying({{3, 4}, {3, 4}}, stage));
        QVERIFY(!magnifying({{std::nan(""), 4}, {3, 5}}, stage));
        QVERIFY(!magnifying({{-INFINITY, 4}, {3, 5}}, stage));
        QVERIFY(!magnifying({{-big, -big}, {big, big}}, stage)); // room around it has no numbers
        QVERIFY(!magnifying({{1e15, 1}, {1e15 + 1, 1}}, stage)); // few numbers lie between
        QVERIFY(!magnifying({{0, 0}, {1, 1}}, {0, 0}));
        QVERIFY(magnifying({{-1e307, 1e307}, {1e307, 0}}, stage));
        QVERIFY(magnifying({{1e-280, 0}, {0, 0}}, stage));
    }
    void tinyLinesAreMagnified()
    {
        for (const clipping::Segment& line : {clipping::Segment{{99, 10}, {102, 12}},
                                              {{10, 10}, {11, 11}}, // far from every edge
                                              {{120, 90}, {121, 90}},
                                              {{1e9, 1e9}, {1e9 + 3, 1e9 + 1}},
                                              {{3, 3}, {3, 4}}}) {
            const FigureFrame frame = nearFrame(traced(line), stage, bodyFont());
            const QSizeF share = shareOf(frame, line);
            QVERIFY(std::max(share.width() / 0.58, share.height() / 0.60) > 0.999);
            QVERIFY(frame.hasScale);
        }
    }
    void allIsShownWithLinesThatAreNotTiny()
    {
        for (const clipping::Segment& line : {clipping::Segment{{-90, 0}, {90, 20}},
                                              {{-160, -30}, {70, 130}},
                                              {{60, 0}, {140, 20}},
                                              {{100, 3}, {100, 3}},
                                              {{0, 0}, {1e9, 2e8}}}) {
            const TracedLine all = traced(line);
            QCOMPARE(nearFrame(all, stage, bodyFont()).seen,
                     figureFrame(all, stage, bodyFont()).seen);
        }
    }
};

} // namespace teaching_near_frame_test

TEST_CLASS(teaching_near_frame_test::NearFrameTest, Gui)
#include "tests/app/teaching/near_frame_test.moc"

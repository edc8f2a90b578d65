// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/coverage.h"
#include "app/view/raster.h"

#include <QPainter>
#include <QPainterPath>
#include <QTest>

#include <cmath>
#include <random>

#include "tests/app/view/compare_images.h"
#include "tests/test_class.h"

namespace view_raster_test {

namespace {

constexpr int side = 150;

// A path that crosses itself all over the picture.
std::vector<QPointF> scribble(std::size_t points, double step)
{
    std::mt19937 random(7);
    std::normal_distribution<double> any(0, step);
    std::vector<QPointF> path{{side / 2.0, side / 2.0}};
    while (path.size() < points) {
        const QPointF p(path.back().x() + any(random), path.back().y() + any(random));
        if (QRectF(10, 10, side - 20, side - 20).contains(p))
            path.push_back(p);
    }
    return path;
}

app::Picture stroked(std::vector<QPointF> points, const app::Polyline& ends,
                     const app::StrokeStyle& strokeStyle)
{
    app::Picture picture;
    picture.kept.points = std::move(points);
    picture.kept.polylines = {{0, std::uint32_t(picture.kept.points.size()), ends.closed,
                               ends.capAtStart, ends.capAtEnd}};
    picture.kept.commands = {{strokeStyle, {}, {}, 0, 1}};
    return picture;
}

// As QPainter paints the whole path at once, with round caps, which both ends get.
QImage atOnce(std::span<const QPointF> points, bool closed, const app::StrokeStyle& strokeStyle,
              double ratio)
{
    QPainterPath path(points[0]);
    for (const QPointF& p : points.subspan(1, points.size() - (closed ? 2 : 1)))
        path.lineTo(p);
    if (closed)
        path.closeSubpath();
    QPen pen(QColor(strokeStyle.colour.red, strokeStyle.colour.green, strokeStyle.colour.blue,
                    strokeStyle.colour.alpha),
             strokeStyle.width, Qt::SolidLine,
             strokeStyle.cap == app::Cap::Butt    ? Qt::FlatCap
             : strokeStyle.cap == app::Cap::Round ? Qt::RoundCap
                                                  : Qt::SquareCap,
             strokeStyle.join == app::Join::Miter   ? Qt::SvgMiterJoin
             : strokeStyle.join == app::Join::Round ? Qt::RoundJoin
                                                    : Qt::BevelJoin);
    pen.setMiterLimit(strokeStyle.miterLimit);
    QImage image(int(side * ratio), int(side * ratio), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(ratio, ratio);
    painter.strokePath(path, pen);
    return image;
}

QImage painted(const app::Picture& picture, double ratio)
{
    const int pixels = int(side * ratio);
    return app::rasterised(picture, {0, pixels}, {.width = pixels, .pixelRatio = ratio});
}

} // namespace

class RasterTest : public QObject {
    Q_OBJECT

private slots:
    void aStrokeThatIsSummedLooksAsQPaintersDoes_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("step");
        QTest::addColumn<double>("ratio");
        QTest::newRow("short segments") << 2.5 << 12.0 << 1.0;
        QTest::newRow("long segments") << 3.5 << 90.0 << 1.0;
        QTest::newRow("wide") << 14.0 << 20.0 << 1.0;
        QTest::newRow("many pixels") << 3.0 << 30.0 << 2.0;
    }
    void aStrokeThatIsSummedLooksAsQPaintersDoes()
    {
        QFETCH(double, width);
        QFETCH(double, step);
        QFETCH(double, ratio);
        QVERIFY(app::worthSumming(600 * step * ratio / 2,
                                  {0, 0, int(side * ratio), int(side * ratio)}));
        for (const auto join : {app::Join::Miter, app::Join::Round, app::Join::Bevel})
            for (const auto cap : {app::Cap::Butt, app::Cap::Round, app::Cap::Square})
                for (const bool closed : {false, true})
                    for (const int alpha : {255, 90}) {
                        if (cap == app::Cap::Round && width * ratio < 3)
                            continue; // painted as square, see raster.cpp
                        const app::StrokeStyle strokeStyle{
                            {20, 60, 200, std::uint8_t(alpha)}, width, cap, join};
                        auto points = scribble(600, step);
                        if (closed)
                            points.push_back(points.front());
                        const QImage expected = atOnce(points, closed, strokeStyle, ratio);
                        const QImage found = painted(
                            stroked(points, {0, 0, closed, !closed, !closed}, strokeStyle), ratio);
                        const QString where =
                            QStringLiteral("join %1, cap %2, closed %3, alpha %4: %5 of 255, "
                                           "%6 % of the bytes")
                                .arg(int(join))
                                .arg(int(cap))
                                .arg(closed)
                                .arg(alpha)
                                .arg(farthest(found, expected))
                                .arg(shareBeyond(found, expected, 5) * 100);
                        // Tiny round joins and caps have another number of corners.
                        QVERIFY2(farthest(found, expected) <= 32, qPrintable(where));
                        QVERIFY2(shareBeyond(found, expected, 5) < 0.004, qPrintable(where));
                    }
    }

    // QPainter takes minutes for it, longer than a test function may.
    void manyCrossingSegmentsArePainted()
    {
        const auto points = scribble(60'000, 80);
        for (const int alpha : {255, 128}) {
            const app::StrokeStyle strokeStyle{{0, 0, 0, std::uint8_t(alpha)}, 2};
            const QImage image =
                painted(stroked(points, {0, 0, false, true, true}, strokeStyle), 8);
            QCOMPARE(image.pixelColor(4 * side, 4 * side).alpha(), alpha); // covered once, or often
            QCOMPARE(image.pixelColor(5, 5).alpha(), 0);
        }
        app::Picture area = stroked(points, {0, 0, true, false, false}, {});
        area.kept.commands[0] = {std::nullopt, {200, 0, 0, 255}, app::FillRule::EvenOdd, 0, 1};
        const QImage image = painted(area, 8);
        QVERIFY(qAlpha(image.pixel(4 * side, 4 * side)) > 0
                || qAlpha(image.pixel(4 * side, 4 * side + 1)) > 0);
        QCOMPARE(image.pixelColor(5, 5).alpha(), 0);
    }

    // Whenever it is cancelled it asks no more than a few times again, and it asks often.
    void paintingIsCancelled()
    {
        const app::Picture picture =
            stroked(scribble(100'000, 5), {0, 0, false, true, true}, {{}, 2});
        int asked = 0;
        app::RasterOptions options{.width = side};
        options.cancelled = [&] {
            ++asked;
            return false;
        };
        const QImage whole = app::rasterised(picture, {0, side}, options);
        QVERIFY2(asked >= 500, qPrintable(QString::number(asked)));
        for (const int most : {1, 2, 5, 100}) {
            asked = 0;
            options.cancelled = [&] { return ++asked >= most; };
            const QImage part = app::rasterised(picture, {0, side}, options);
            QCOMPARE(part.size(), whole.size());
            QVERIFY2(asked <= most + 5, qPrintable(QString::number(asked)));
            QCOMPARE(farthest(part, painted({}, 1)), 0); // a stroke is there as a whole, or not
        }
    }
};

} // namespace view_raster_test

TEST_CLASS(view_raster_test::RasterTest, Gui)
#include "tests/app/view/raster_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/painter_path.h"
#include "app/view/summed_shape.h"

#include <QPainter>
#include <QPainterPath>
#include <QTest>

#include <random>

#include "tests/app/view/compare_images.h"

namespace {

constexpr int side = 120;
constexpr double scale = 1.5; // device pixels of a user unit
constexpr app::Colour blue{20, 60, 200, 150};

// Two paths, one of them with curves, that cross themselves and each other.
app::Shape scribble(std::size_t count, bool closed)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1, side / scale + 1);
    const auto point = [&] {
        const double x = anywhere(random);
        return app::Point(x, anywhere(random));
    };
    app::Shape shape;
    for (const bool curved : {false, true}) {
        app::Subpath path{point(), {}, closed};
        for (std::size_t i = 0; i < count; ++i) {
            const app::Point to = point(), one = point();
            path.segments.push_back({to, one, point(), curved && i % 4 == 0});
        }
        shape.paths.push_back(path);
    }
    return shape;
}

QImage painted(const std::function<void(QPainter& painter)>& paint)
{
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    paint(painter);
    return image;
}

// QPainter would flatten curves a quarter of a pixel from where they are.
QPainterPath finelyFlattened(const app::Shape& shape)
{
    constexpr double finer = 64;
    QPainterPath flat;
    flat.setFillRule(app::painterPath(shape).fillRule());
    for (const auto& points :
         app::painterPath(shape).toSubpathPolygons(QTransform::fromScale(finer, finer))) {
        flat.addPolygon(QTransform::fromScale(1 / finer, 1 / finer).map(points));
        if (shape.paths[0].closed)
            flat.closeSubpath();
    }
    return flat;
}

QColor qColor(const app::Colour& c) { return {c.red, c.green, c.blue, c.alpha}; }

QPen penOf(const app::Style& style)
{
    const Qt::PenJoinStyle join = style.join == app::Join::Miter   ? Qt::SvgMiterJoin
                                  : style.join == app::Join::Round ? Qt::RoundJoin
                                                                   : Qt::BevelJoin;
    QPen pen(qColor(*style.stroke), style.width, Qt::SolidLine,
             style.cap == app::Cap::Butt    ? Qt::FlatCap
             : style.cap == app::Cap::Round ? Qt::RoundCap
                                            : Qt::SquareCap,
             join);
    pen.setMiterLimit(style.miterLimit);
    QList<qreal> pattern; // in widths
    for (const double dash : style.dashes)
        pattern << dash / style.width;
    if (!pattern.isEmpty())
        pen.setDashPattern(pattern);
    return pen;
}

QString distanceOf(const QImage& found, const QImage& expected)
{
    return QStringLiteral("%1 of 255, %2 % of the bytes")
        .arg(farthest(found, expected))
        .arg(shareBeyond(found, expected, 8) * 100);
}

} // namespace

class SummedShapeTest : public QObject {
    Q_OBJECT

private slots:
    void strokesLookAsQPaintersDo_data()
    {
        QTest::addColumn<app::Cap>("cap");
        QTest::addColumn<app::Join>("join");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<double>("width");
        QTest::addColumn<std::vector<double>>("dashes");
        using Lengths = std::vector<double>;
        QTest::newRow("miter") << app::Cap::Butt << app::Join::Miter << false << 1.0 << Lengths{};
        QTest::newRow("round") << app::Cap::Round << app::Join::Round << false << 3.0 << Lengths{};
        QTest::newRow("square") << app::Cap::Square << app::Join::Bevel << false << 4.0
                                << Lengths{};
        QTest::newRow("closed") << app::Cap::Butt << app::Join::Miter << true << 2.0 << Lengths{};
        QTest::newRow("dashed") << app::Cap::Butt << app::Join::Bevel << false << 2.0
                                << Lengths{9, 4};
    }
    void strokesLookAsQPaintersDo()
    {
        QFETCH(bool, closed);
        app::Shape shape = scribble(180, closed);
        shape.style.stroke = blue;
        QFETCH(app::Cap, cap);
        QFETCH(app::Join, join);
        shape.style.cap = cap;
        shape.style.join = join;
        QFETCH(double, width);
        QFETCH(std::vector<double>, dashes);
        shape.style.width = width;
        shape.style.dashes = dashes;
        if (!dashes.empty()) // flattened otherwise, curves are longer, and later dashes move on
            shape.paths.resize(1);
        bool summed = false;
        const QImage found =
            painted([&](QPainter& painter) { summed = app::strokeSummed(painter, shape); });
        QVERIFY(summed);
        const QImage expected = painted([&](QPainter& painter) {
            painter.strokePath(finelyFlattened(shape), penOf(shape.style));
        });
        QVERIFY2(shareBeyond(found, expected, 8) < 0.01, qPrintable(distanceOf(found, expected)));
    }

    void areasLookAsQPaintersDo()
    {
        for (const auto rule : {app::FillRule::EvenOdd, app::FillRule::NonZero}) {
            app::Shape shape = scribble(300, true);
            shape.style.fill = blue;
            shape.style.fillRule = rule;
            bool summed = false;
            const QImage found =
                painted([&](QPainter& painter) { summed = app::fillSummed(painter, shape); });
            QVERIFY(summed);
            const QImage expected = painted(
                [&](QPainter& painter) { painter.fillPath(finelyFlattened(shape), qColor(blue)); });
            QVERIFY2(shareBeyond(found, expected, 8) < 0.01,
                     qPrintable(distanceOf(found, expected)));
        }
    }

    void whatIsSmallIsLeftToQPainter()
    {
        app::Shape shape = scribble(5, true);
        shape.style.stroke = shape.style.fill = blue;
        const QImage found = painted([&](QPainter& painter) {
            QVERIFY(!app::strokeSummed(painter, shape));
            QVERIFY(!app::fillSummed(painter, shape));
        });
        QCOMPARE(found, painted([](QPainter&) {}));
    }

    void endlessDashesAreLeftToQPainter()
    {
        app::Shape shape = scribble(300, false);
        shape.style.stroke = blue;
        shape.style.dashes = {1, 1};
        shape.paths[0].segments[9].to = {1e100, 1e100};
        painted([&](QPainter& painter) { QVERIFY(!app::strokeSummed(painter, shape)); });
    }
};

QTEST_GUILESS_MAIN(SummedShapeTest)
#include "summed_shape_test.moc"

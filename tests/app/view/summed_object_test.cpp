// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/outline.h"
#include "app/view/summed_object.h"

#include <QPainter>
#include <QPainterPath>
#include <QTest>

#include <random>

#include "tests/app/view/compare_images.h"
#include "tests/test_class.h"

namespace view_summed_object_test {

namespace {

constexpr int side = 120;
constexpr double scale = 1.5; // device pixels of a user unit
constexpr app::Colour blue{20, 60, 200, 150};

// Two paths, one of them with curves, that cross themselves and each other.
std::vector<app::Subpath> scribble(std::size_t count, bool closed)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1, side / scale + 1);
    const auto point = [&] {
        const double x = anywhere(random);
        return app::Point(x, anywhere(random));
    };
    std::vector<app::Subpath> paths;
    for (const bool curved : {false, true}) {
        app::Subpath path{point(), {}, closed};
        for (std::size_t i = 0; i < count; ++i) {
            const app::Point to = point(), one = point();
            path.segments.push_back({to, one, point(), curved && i % 4 == 0});
        }
        paths.push_back(path);
    }
    return paths;
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
QPainterPath finelyFlattened(const app::Object& object)
{
    constexpr double finer = 64;
    QPainterPath flat;
    const QPainterPath outline = app::painterPath(object.path, object.style.fillRule);
    flat.setFillRule(outline.fillRule());
    for (const auto& points : outline.toSubpathPolygons(QTransform::fromScale(finer, finer))) {
        flat.addPolygon(QTransform::fromScale(1 / finer, 1 / finer).map(points));
        if (object.path.subpaths()[0].closed)
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

class SummedObjectTest : public QObject {
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
        auto paths = scribble(180, closed);
        app::Style style{.stroke = blue};
        QFETCH(app::Cap, cap);
        QFETCH(app::Join, join);
        style.cap = cap;
        style.join = join;
        QFETCH(double, width);
        QFETCH(std::vector<double>, dashes);
        style.width = width;
        style.dashes = dashes;
        if (!dashes.empty()) // flattened otherwise, curves are longer, and later dashes move on
            paths.resize(1);
        const app::Object object{app::Path(paths), style};
        bool summed = false;
        const QImage found =
            painted([&](QPainter& painter) { summed = app::strokeSummed(painter, object); });
        QVERIFY(summed);
        const QImage expected = painted(
            [&](QPainter& painter) { painter.strokePath(finelyFlattened(object), penOf(style)); });
        QVERIFY2(shareBeyond(found, expected, 8) < 0.01, qPrintable(distanceOf(found, expected)));
    }

    void areasLookAsQPaintersDo()
    {
        for (const auto rule : {app::FillRule::EvenOdd, app::FillRule::NonZero}) {
            app::Object object{app::Path(scribble(300, true)), {.fill = blue}};
            object.style.fillRule = rule;
            bool summed = false;
            const QImage found =
                painted([&](QPainter& painter) { summed = app::fillSummed(painter, object); });
            QVERIFY(summed);
            const QImage expected = painted([&](QPainter& painter) {
                painter.fillPath(finelyFlattened(object), qColor(blue));
            });
            QVERIFY2(shareBeyond(found, expected, 8) < 0.01,
                     qPrintable(distanceOf(found, expected)));
        }
    }

    void whatIsSmallIsLeftToQPainter()
    {
        const app::Object object{app::Path(scribble(5, true)), {.stroke = blue, .fill = blue}};
        const QImage found = painted([&](QPainter& painter) {
            QVERIFY(!app::strokeSummed(painter, object));
            QVERIFY(!app::fillSummed(painter, object));
        });
        QCOMPARE(found, painted([](QPainter&) {}));
    }

    void endlessDashesAreLeftToQPainter()
    {
        auto paths = scribble(300, false);
        paths[0].segments[9].to = {1e100, 1e100};
        app::Object object{app::Path(paths), {.stroke = blue}};
        object.style.dashes = {1, 1};
        painted([&](QPainter& painter) { QVERIFY(!app::strokeSummed(painter, object)); });
    }
};

} // namespace view_summed_object_test

TEST_CLASS(view_summed_object_test::SummedObjectTest, Core)
#include "tests/app/view/summed_object_test.moc"

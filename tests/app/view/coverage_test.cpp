// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/coverage.h"

#include <QPainter>
#include <QPainterPath>
#include <QTest>

#include <random>

#include "tests/app/view/compare_images.h"
#include "tests/test_class.h"

namespace view_coverage_test {

namespace {

constexpr int side = 90;

using Contours = std::vector<std::vector<QPointF>>;

// Some points lie outside of the picture, some on the grid of its pixels.
Contours anyContours(std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(-0.3 * side, 1.3 * side);
    Contours contours(1 + random() % 3);
    for (auto& contour : contours)
        for (std::size_t i = 3 + random() % 40; i > 0; --i) {
            const QPointF p(anywhere(random), anywhere(random));
            contour.push_back(random() % 4 == 0 ? QPointF(p.toPoint()) : p);
        }
    return contours;
}

QImage filled(const Contours& contours, app::FillRule rule, const QColor& colour)
{
    QPainterPath path;
    path.setFillRule(rule == app::FillRule::EvenOdd ? Qt::OddEvenFill : Qt::WindingFill);
    for (const auto& contour : contours)
        path.addPolygon(QPolygonF(QList<QPointF>(contour.begin(), contour.end())));
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(path, colour);
    return image;
}

QImage summed(const Contours& contours, const QRect& pixels, app::FillRule rule,
              const app::Colour& colour)
{
    app::Coverage coverage(pixels);
    for (const auto& contour : contours)
        coverage.add(contour);
    return coverage.coloured(rule, colour);
}

} // namespace

class CoverageTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatQPainterMakesOfAPath()
    {
        for (std::uint32_t seed = 1; seed <= 200; ++seed)
            for (const auto rule : {app::FillRule::NonZero, app::FillRule::EvenOdd})
                for (const int alpha : {255, 100}) {
                    const Contours contours = anyContours(seed);
                    const QImage expected = filled(contours, rule, QColor(200, 90, 30, alpha));
                    const QImage found = summed(contours, {0, 0, side, side}, rule,
                                                {200, 90, 30, std::uint8_t(alpha)});
                    QVERIFY2(farthest(found, expected) <= 5,
                             qPrintable(QStringLiteral("seed %1, rule %2, alpha %3: %4")
                                            .arg(seed)
                                            .arg(int(rule))
                                            .arg(alpha)
                                            .arg(farthest(found, expected))));
                }
    }

    void aPartIsWhatItIsInTheWhole()
    {
        const QRect part(30, 20, 25, 40);
        for (std::uint32_t seed = 1; seed <= 100; ++seed) {
            const Contours contours = anyContours(seed);
            const app::Colour black{0, 0, 0, 255};
            const QImage whole =
                summed(contours, {0, 0, side, side}, app::FillRule::NonZero, black);
            const QImage found = summed(contours, part, app::FillRule::NonZero, black);
            QVERIFY2(farthest(found, whole.copy(part)) <= 1, qPrintable(QString::number(seed)));
        }
    }

    void whatIsNotFiniteCoversNothing()
    {
        const double infinite = std::numeric_limits<double>::infinity();
        for (const double bad : {infinite, -infinite, std::nan("")}) {
            const QImage found = summed({{{10, bad}, {bad, 20}, {bad, bad}}, {}},
                                        {0, 0, side, side}, app::FillRule::NonZero, {});
            QCOMPARE(farthest(found, filled({}, app::FillRule::NonZero, Qt::black)), 0);
        }
    }

    void pays()
    {
        const QRect pixels(0, 0, 1000, 800);
        QVERIFY(!app::worthSumming(2 * 800, pixels));      // an outline
        QVERIFY(app::worthSumming(100'000 * 5.0, pixels)); // a scribble
    }
};

} // namespace view_coverage_test

TEST_CLASS(view_coverage_test::CoverageTest, Core)
#include "tests/app/view/coverage_test.moc"

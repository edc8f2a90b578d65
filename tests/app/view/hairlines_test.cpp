// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairline_run.h"

#include <QPainter>
#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <ranges>

#include "tests/test_class.h"

namespace view_hairlines_test {

namespace {

using app::Hairline, app::Hairlines;

constexpr int width = 300, height = 200;
constexpr app::Colour ink{200, 30, 60, 255};

struct Lines {
    std::vector<QLineF> list;
    double width = 1;
    app::Cap cap = app::Cap::Butt;
};

/// Lines over the image and beyond it; longest: along one axis, in device pixels.
Lines lines(int count, double longest, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> x(-50, width + 50), y(-50, height + 50);
    std::uniform_real_distribution<double> far(-longest, longest);
    Lines lines;
    for (int i = 0; i < count; ++i) {
        const QPointF from(x(random), y(random));
        lines.list.emplace_back(from, from + QPointF(far(random), far(random)));
    }
    return lines;
}

QImage background(int rows)
{
    QImage image(width, rows, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    return image;
}

QImage painted(const Lines& lines, app::Band band = {0, height})
{
    QImage image = background(band.height);
    Hairlines hairlines(width, band);
    for (const QLineF& line : lines.list)
        hairlines.add(*Hairline::of(line.p1(), line.p2(), lines.width, lines.cap), ink);
    hairlines.paintOn(image);
    return image;
}

QImage paintedOneByOne(const Lines& lines, app::Band band = {0, height})
{
    QImage image = background(band.height);
    for (const QLineF& line : lines.list)
        app::paintHairline(image, band.top,
                           *Hairline::of(line.p1(), line.p2(), lines.width, lines.cap), ink);
    return image;
}

/// A square cap lengthens a line by half a pixel along the axis on which it is longer. QPainter
/// (Qt 6.4) forgets the other axis, which moves the line.
QLineF capped(const QLineF& line)
{
    const double longer = std::max(std::abs(line.dx()), std::abs(line.dy()));
    const QPointF more = (line.p2() - line.p1()) * (longer > 0 ? 0.5 / longer : 0);
    return {line.p1() - more, line.p2() + more};
}

QImage byQPainter(const Lines& lines)
{
    QImage image = background(height);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(QColor(ink.red, ink.green, ink.blue), lines.width, Qt::SolidLine, Qt::FlatCap);
    pen.setCosmetic(true);
    painter.setPen(pen);
    for (const QLineF& line : lines.list)
        painter.drawLine(lines.cap == app::Cap::Butt ? line : capped(line));
    return image;
}

struct Distance {
    double mean = 0, worstTile = 0; ///< over pixels with ink, of 255; tiles are 16 × 16
    int worst = 0;
};

Distance distance(const QImage& a, const QImage& b)
{
    Distance distance;
    double sum = 0, count = 0;
    for (int top = 0; top < height; top += 16)
        for (int left = 0; left < width; left += 16) {
            double tileSum = 0, tileCount = 0;
            for (int y = top; y < std::min(top + 16, height); ++y)
                for (int x = left; x < std::min(left + 16, width); ++x) {
                    const int difference = std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(x, y)));
                    distance.worst = std::max(distance.worst, difference);
                    tileSum += difference;
                    tileCount += qAlpha(a.pixel(x, y)) > 0 || qAlpha(b.pixel(x, y)) > 0;
                }
            sum += tileSum, count += tileCount;
            if (tileCount > 0)
                distance.worstTile = std::max(distance.worstTile, tileSum / tileCount);
        }
    distance.mean = count > 0 ? sum / count : 0;
    return distance;
}

} // namespace

class HairlinesTest : public QObject {
    Q_OBJECT

private slots:
    void theyLookAsQPainterPaintsThem_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("longest");
        QTest::addColumn<double>("penWidth");
        QTest::addColumn<bool>("square");
        for (const auto& [count, longest] :
             {std::pair{20, 400.0}, {400, 400.0}, {4000, 400.0}, {300, 20.0}, {6000, 8.0}})
            for (const double penWidth : {0.3, 0.75, 1.0})
                for (const bool square : {false, true})
                    QTest::addRow("%d of %g, %g wide, %s", count, longest, penWidth,
                                  square ? "square" : "flat")
                        << count << longest << penWidth << square;
    }

    void theyLookAsQPainterPaintsThem()
    {
        QFETCH(int, count);
        QFETCH(double, longest);
        QFETCH(double, penWidth);
        QFETCH(bool, square);
        Lines some = lines(count, longest, unsigned(count));
        some.width = penWidth;
        some.cap = square ? app::Cap::Square : app::Cap::Butt;
        const Distance found = distance(painted(some), byQPainter(some));
        const QString text = QStringLiteral("mean %1, worst tile %2, worst pixel %3")
                                 .arg(found.mean)
                                 .arg(found.worstTile)
                                 .arg(found.worst);
        QVERIFY2(found.mean <= 3 && found.worstTile <= 12, qPrintable(text));
        const int apart = distance(painted(some), paintedOneByOne(some)).worst;
        QVERIFY2(apart <= 2, qPrintable(QString::number(apart))); // each line is rounded
    }

    void bandsJoinWithoutASeam()
    {
        for (const double longest : {5.0, 60.0, 900.0}) {
            const Lines some = lines(500, longest, 3);
            const QImage whole = painted(some), oneByOne = paintedOneByOne(some);
            for (int top = 0, rows = 1; top < height; top += rows, rows = rows * 2 + 1) {
                const int end = std::min(top + rows, height);
                QCOMPARE(painted(some, {top, end - top}), whole.copy(0, top, width, end - top));
                QCOMPARE(paintedOneByOne(some, {top, end - top}),
                         oneByOne.copy(0, top, width, end - top));
            }
        }
    }

    void theirOrderShows_byOneStepAtMost()
    {
        Lines some = lines(3000, 300, 5);
        const QImage forwards = painted(some);
        std::ranges::reverse(some.list);
        const int worst = distance(forwards, painted(some)).worst;
        QVERIFY2(worst <= 1, qPrintable(QString::number(worst)));
    }

    /// Runs of one colour, shorter and longer than it is worth tiles, look as painted one by one.
    void aRunLooksAsOneByOne()
    {
        std::mt19937 random(4);
        QImage run = background(height), oneByOne = background(height);
        app::HairlineRun hairlines(run);
        for (int i = 0; i < 12; ++i) {
            const app::Colour colour{std::uint8_t(random()), std::uint8_t(random()), 90};
            const int count = i % 3 == 0 ? 400 : i % 3 == 1 ? 64 : 5;
            for (const QLineF& each : lines(count, 60, unsigned(i)).list) {
                const auto line = *Hairline::of(each.p1(), each.p2(), 0.8, app::Cap::Butt);
                hairlines.add(line, colour);
                app::paintHairline(oneByOne, 0, line, colour);
            }
        }
        hairlines.flush();
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const QRgb a = run.pixel(x, y), b = oneByOne.pixel(x, y);
                QVERIFY(std::abs(qRed(a) - qRed(b)) <= 4 && std::abs(qGreen(a) - qGreen(b)) <= 4
                        && std::abs(qAlpha(a) - qAlpha(b)) <= 2);
            }
    }
    // The truth: one over the other from the back, with numbers that are not rounded.
    void coloursFromTheFrontLookAsFromTheBack_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("longest");
        for (const auto& [count, longest] : {std::pair{30, 300.0}, {3000, 300.0}, {30'000, 20.0}})
            QTest::addRow("%d of %g", count, longest) << count << longest;
    }
    void coloursFromTheFrontLookAsFromTheBack()
    {
        QFETCH(int, count);
        QFETCH(double, longest);
        const Lines some = lines(count, longest, 11);
        std::mt19937 random(12);
        const auto channel = [&] { return std::uint8_t(random()); };
        std::vector<std::pair<Hairline, app::Colour>> all;
        for (const QLineF& line : some.list)
            all.emplace_back(*Hairline::of(line.p1(), line.p2(), 1, app::Cap::Butt),
                             app::Colour{channel(), channel(), channel()});
        app::ColouredHairlines front(width, {0, height});
        for (const auto& [line, colour] : all | std::views::reverse)
            front.add(line, colour);
        QImage image = background(height);
        image.fill(qRgb(250, 240, 230));
        front.paintOn(image);
        std::vector<std::array<double, 3>> truth(width * height, {250, 240, 230});
        for (const auto& [line, colour] : all)
            line.visitPixels(int(std::floor(line.from)), int(std::floor(line.to)),
                             [&](int along, int across, unsigned share) {
                                 const int x = line.steep ? across : along,
                                           y = line.steep ? along : across;
                                 if (x < 0 || x >= width || y < 0 || y >= height)
                                     return;
                                 auto& [red, green, blue] = truth[std::size_t(y * width + x)];
                                 red += (colour.red - red) * share / 256;
                                 green += (colour.green - green) * share / 256;
                                 blue += (colour.blue - blue) * share / 256;
                             });
        double worst = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const QRgb is = image.pixel(x, y);
                const auto& [red, green, blue] = truth[std::size_t(y * width + x)];
                worst = std::max({worst, std::abs(qRed(is) - red), std::abs(qGreen(is) - green),
                                  std::abs(qBlue(is) - blue)});
            }
        QVERIFY2(worst <= 1, qPrintable(QString::number(worst)));
    }

    // As of lines that are nearly parallel to an axis, whose second pixels get little each.
    void manyThinCoversKeepTheirColour()
    {
        for (const unsigned share : {1U, 2U, 4U, 200U})
            for (const int covers : {10, 1000, 4000}) {
                app::InkedPixel pixel{};
                pixel.shown = 65'535;
                for (int i = 0; i < covers; ++i)
                    pixel.cover(share, {200, 255, 3});
                const QRgb is = pixel.above(qRgb(200, 255, 3), {});
                const int worst = std::max({std::abs(qRed(is) - 200), std::abs(qGreen(is) - 255),
                                            std::abs(qBlue(is) - 3), std::abs(qAlpha(is) - 255)});
                QVERIFY2(worst <= 1, qPrintable(QString("%1 × %2: %3")
                                                    .arg(covers)
                                                    .arg(share)
                                                    .arg(QString::number(is, 16))));
            }
    }

    // Tiles beyond the first 64 of a row.
    void aWideImageIsPaintedToItsEnd()
    {
        constexpr int wide = 4200;
        std::mt19937 random(13);
        QImage image(wide, 40, QImage::Format_ARGB32_Premultiplied), oneByOne(image);
        image.fill(Qt::transparent);
        oneByOne.fill(Qt::transparent);
        Hairlines hairlines(wide, {0, 40});
        for (int i = 0; i < 1500; ++i) {
            const QPointF a(random() % 4400 - 100.0, random() % 60 - 10.0);
            const auto line = *Hairline::of(
                a, QPointF(random() % 4400 - 100.0, random() % 60 - 10.0), 1, app::Cap::Butt);
            hairlines.add(line, ink);
            app::paintHairline(oneByOne, 0, line, ink);
        }
        hairlines.paintOn(image);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < wide; ++x)
                QVERIFY(std::abs(qAlpha(image.pixel(x, y)) - qAlpha(oneByOne.pixel(x, y))) <= 3);
    }

    void whatIsCoveredIsOpaque()
    {
        const QImage image = painted(lines(60'000, 400, 1));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                QCOMPARE(image.pixel(x, y), qRgb(ink.red, ink.green, ink.blue));
    }

    /// Also of lines inside a pixel, which QPainter paints too light or too dark.
    void theirInkIsAsLongAsTheyAre()
    {
        for (const QLineF& line : lines(500, 1.5, 9).list) {
            const QImage image = painted({{line.translated(QPointF(60, 60))}});
            const double longer = std::max(std::abs(line.dx()), std::abs(line.dy()));
            double found = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    found += qAlpha(image.pixel(x, y)) / 255.0;
            const QPointF at = line.p1() + QPointF(60, 60);
            if (QRectF(5, 5, width - 10, height - 10).contains(at))
                QVERIFY2(std::abs(found - longer) < 0.03,
                         qPrintable(QString::number(found - longer)));
        }
    }

    void theyLieOverWhatIsThere()
    {
        QImage image = background(height);
        image.fill(Qt::white);
        Hairlines hairlines(width, {0, height});
        hairlines.add(*Hairline::of({10, 20.5}, {50, 20.5}, 0.5, app::Cap::Butt), app::Colour{});
        hairlines.paintOn(image);
        const QRgb grey = image.pixel(30, 20);
        QVERIFY2(std::abs(qRed(grey) - 128) <= 1 && qAlpha(grey) == 255,
                 qPrintable(QString::number(grey, 16)));
        QCOMPARE(image.pixel(30, 22), qRgb(255, 255, 255));
        hairlines.paintOn(image); // nothing is left to paint
        QCOMPARE(image.pixel(30, 20), grey);
    }

    void lengthZeroIsADotWithSquareCapsOnly()
    {
        const Lines dot{{QLineF(40.5, 30.5, 40.5, 30.5)}, 1, app::Cap::Square};
        QCOMPARE(qAlpha(painted(dot).pixel(40, 30)), 255);
        const Lines nothing{{QLineF(40.5, 30.5, 40.5, 30.5)}};
        QCOMPARE(painted(nothing), background(height));
    }

    void hugeNumbersAreRefused()
    {
        for (const double x : {2e6, 1e300, HUGE_VAL, std::nan("")}) {
            QVERIFY(!Hairline::of({x, 0}, {1, 1}, 1, app::Cap::Butt));
            QVERIFY(!Hairline::of({0, 0}, {1, -x}, 1, app::Cap::Butt));
        }
        Hairlines hairlines(width, {0, height});
        hairlines.add(*Hairline::of({-1e6, -1e6}, {1e6, 1e6}, 1, app::Cap::Butt), ink);
        QImage image = background(height);
        hairlines.paintOn(image);
        QCOMPARE(image.pixel(50, 50), qRgb(ink.red, ink.green, ink.blue));
    }
};

} // namespace view_hairlines_test

TEST_CLASS(view_hairlines_test::HairlinesTest, Core)
#include "tests/app/view/hairlines_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/formats/format.h"

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QTest>

#include <array>
#include <random>

#include "tests/test_class.h"

namespace formats_png_test {

namespace {

constexpr int side = 240; // pixels
constexpr double dpi = 96;

struct Thin {
    QLineF line;
    app::Style style;
};

std::vector<Thin> thinLines(int count)
{
    std::mt19937 random(6);
    const auto place = [&] { return double(random() % 2600) / 10 - 10; };
    const std::array colours{app::Colour{}, app::Colour{200, 30, 40}, app::Colour{0, 90, 200}};
    std::vector<Thin> all;
    for (int i = 0; i < count; ++i) {
        const bool isFlat = i % 10 == 0;
        const double x = place(), y = place();
        all.push_back({QLineF(x, y, place(), isFlat ? y : place()),
                       {.stroke = colours[random() % 3],
                        .width = double(1 + random() % 10) / 10,
                        .cap = app::Cap(random() % 3)}});
    }
    return all;
}

QImage written(const std::vector<Thin>& lines)
{
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    for (const Thin& thin : lines)
        builder.addLine({{thin.line.x1(), thin.line.y1()}, {thin.line.x2(), thin.line.y2()}},
                        builder.style(thin.style));
    builder.close();
    const app::Document document =
        builder.take({{0, 0}, {side, side}, {side, app::Unit::Px}, {side, app::Unit::Px}});
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    const auto error = app::findFormat(u"png")->write(document, out, {.dpi = dpi});
    if (error)
        qWarning("%s", qPrintable(*error));
    return QImage::fromData(out.data()).convertToFormat(QImage::Format_RGB32);
}

/// By QPainter, on `times` as many pixels a side.
QImage painted(const std::vector<Thin>& lines, int times)
{
    QImage large(side * times, side * times, QImage::Format_RGB32);
    large.fill(Qt::white);
    QPainter painter(&large);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(times, times);
    for (const auto& [line, style] : lines) {
        const QColor colour(style.stroke->red, style.stroke->green, style.stroke->blue);
        painter.setPen(QPen(colour, style.width, Qt::SolidLine,
                            style.cap == app::Cap::Butt    ? Qt::FlatCap
                            : style.cap == app::Cap::Round ? Qt::RoundCap
                                                           : Qt::SquareCap));
        QPainterPath path(line.p1());
        path.lineTo(line.p2());
        painter.drawPath(path);
    }
    painter.end();
    return large.scaled(side, side, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

double difference(const QImage& a, const QImage& b)
{
    double sum = 0, inked = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q))
                   + std::abs(qBlue(p) - qBlue(q));
            inked += (p & q & 0xffffff) != 0xffffff;
        }
    return sum / 3 / inked;
}

} // namespace

class PngTest : public QObject {
    Q_OBJECT

private slots:
    // Lines of at most one pixel are not painted by QPainter.
    void thinLinesAreAsTrueAsThoseOfQPainter_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {12, 100, 600})
            QTest::addRow("%d", count) << count;
    }
    void thinLinesAreAsTrueAsThoseOfQPainter()
    {
        QFETCH(int, count);
        const auto lines = thinLines(count);
        const QImage truth = painted(lines, 8), image = written(lines);
        QCOMPARE(image.size(), QSize(side, side));
        const double own = difference(image, truth),
                     qPainter = difference(painted(lines, 1), truth);
        qInfo("from 64 times as many pixels: %.2f of 255, QPainter %.2f", own, qPainter);
        QVERIFY(own <= qPainter);
        QVERIFY(difference(image, written({})) > 5);
    }
};

} // namespace formats_png_test

TEST_CLASS(formats_png_test::PngTest, Gui)
#include "tests/app/formats/png_test.moc"

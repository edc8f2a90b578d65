// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"

#include <QBuffer>
#include <QColor>
#include <QImage>
#include <QTest>

#include <cmath>

#include "tests/app/command_line/program.h"
#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace formats_paper_test {

// PDF and PNG, against what poppler and librsvg make of the same drawing.

namespace {

using app::Point;

constexpr double dpi = 150;

app::Style pen(double width, app::Colour colour = {})
{
    app::Style style{.stroke = colour};
    style.width = width;
    return style;
}

// Caps, joins, dashes, holes, alpha, a curve, a point, and a page that does not fill its paper.
app::Sheet drawing()
{
    app::Sheet sheet;
    sheet.page = {{10, 20}, {120, 60}, {70, app::Unit::Mm}, {30, app::Unit::Mm}};
    const auto add = [&](std::vector<app::Subpath> paths, app::Style style) {
        sheet.shapes.push_back({std::move(paths), std::move(style), {}, 0, false});
    };
    const app::Subpath square{{80, 25}, {{{110, 25}}, {{110, 55}}, {{80, 55}}}, true};
    const app::Subpath hole{{85, 30}, {{{105, 30}}, {{105, 50}}, {{85, 50}}}, true};
    app::Style filled = pen(3, {0, 0, 128, 255});
    filled.fill = app::Colour{250, 200, 100, 128};
    filled.fillRule = app::FillRule::EvenOdd;
    add({square, hole}, filled);
    app::Style dashed = pen(2, {200, 0, 0, 255});
    dashed.dashes = {6, 3, 1};
    dashed.dashOffset = -2;
    dashed.cap = app::Cap::Round;
    add({{{20, 70}, {{{120, 40}, {40, 20}, {60, 120}, true}}, false}}, dashed);
    app::Style faint = pen(6, {0, 160, 0, 100});
    faint.join = app::Join::Round;
    add({{{20, 30}, {{{60, 30}}, {{40, 60}}}, true}}, faint);
    add({{{65, 75}, {{{75, 60}}, {{80, 75}}}, false}}, pen(4)); // a miter
    app::Style dot = pen(8, {0, 0, 255, 255});
    dot.cap = app::Cap::Square;
    add({{{30, 72}, {}, false}}, dot);
    return sheet;
}

QImage onRgb(const QImage& image) { return image.convertToFormat(QImage::Format_RGB32); }

// Root of the mean square of the differences of all channels, 0 to 255. One row or column more or
// less (a page of half a pixel) is passed over.
double difference(const QImage& a, const QImage& b)
{
    const int width = std::min(a.width(), b.width()), height = std::min(a.height(), b.height());
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            sum += std::pow(p.red() - q.red(), 2) + std::pow(p.green() - q.green(), 2)
                   + std::pow(p.blue() - q.blue(), 2);
        }
    return std::sqrt(sum / (3.0 * width * height));
}

} // namespace

class PaperTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }

    QImage byLibrsvg(const app::Sheet& sheet)
    {
        if (const auto error = app::writeFile(app::documentOf(sheet), path("a.svg")))
            qWarning("%s", qPrintable(*error));
        const auto resolution = QString::number(dpi);
        const auto run =
            runProgram("rsvg-convert", {"-b", "white", "-d", resolution, "-p", resolution, "-o",
                                        path("svg.png"), path("a.svg")});
        return run.code == 0 ? onRgb(QImage(path("svg.png"))) : QImage();
    }

    QImage byPoppler(const app::Sheet& sheet)
    {
        if (const auto error = app::writeFile(app::documentOf(sheet), path("a.pdf")))
            qWarning("%s", qPrintable(*error));
        const auto run =
            runProgram("pdftocairo", {"-png", "-singlefile", "-r", QString::number(dpi),
                                      path("a.pdf"), path("pdf")});
        return run.code == 0 && run.err.isEmpty() ? onRgb(QImage(path("pdf.png"))) : QImage();
    }

    QImage ours(const app::Sheet& sheet)
    {
        app::WriteOptions options;
        options.dpi = dpi;
        if (const auto error = app::writeFile(app::documentOf(sheet), path("a.png"), options))
            qWarning("%s", qPrintable(*error));
        return onRgb(QImage(path("a.png")));
    }

private slots:
    void picturesAgree()
    {
        const auto sheet = drawing();
        const QImage svg = byLibrsvg(sheet), pdf = byPoppler(sheet), png = ours(sheet);
        QVERIFY(!svg.isNull() && !pdf.isNull() && !png.isNull());
        QVERIFY(std::abs(png.width() - svg.width()) <= 1
                && std::abs(pdf.width() - svg.width()) <= 1);
        QVERIFY(std::abs(png.height() - svg.height()) <= 1);
        const double pngs = difference(png, svg), pdfs = difference(pdf, svg);
        QVERIFY2(pngs < 6, qPrintable(QString::number(pngs)));
        QVERIFY2(pdfs < 6, qPrintable(QString::number(pdfs)));
    }

    void aFaultIsSeen()
    {
        auto sheet = drawing();
        const QImage svg = byLibrsvg(sheet);
        sheet.shapes[3].style.width = 5;
        QVERIFY(difference(ours(sheet), svg) > 6 && difference(byPoppler(sheet), svg) > 6);
    }

    void thePageHasItsSizeOnPaper()
    {
        app::Sheet sheet;
        QVERIFY(!app::writeFile(app::documentOf(sheet), path("a4.pdf")));
        const auto info = runProgram("pdfinfo", {path("a4.pdf")});
        QVERIFY2(info.out.contains("841.89 x 595.276 pts (A4)"), info.out.constData());
        QCOMPARE(info.err, "");
        app::WriteOptions options;
        options.dpi = 300;
        QVERIFY(!app::writeFile(app::documentOf(sheet), path("a4.png"), options));
        const QImage image(path("a4.png"));
        QCOMPARE(image.size(), QSize(3508, 2480));
        QCOMPARE(image.dotsPerMeterX(), 11811);
        QCOMPARE(image.dotsPerMeterY(), 11811);
        QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    }

    void strokesStayStrokesAndBytesTheSame()
    {
        const auto sheet = drawing();
        QByteArray bytes[2];
        for (QByteArray& one : bytes) {
            QBuffer buffer(&one);
            buffer.open(QIODevice::WriteOnly);
            QVERIFY(!app::findFormat(u"pdf")->write(app::documentOf(sheet), buffer, {}));
        }
        QCOMPARE(bytes[0], bytes[1]);
        const auto begin = bytes[0].indexOf("stream\n") + 7;
        auto packed = bytes[0].mid(begin, bytes[0].indexOf("\nendstream") - begin);
        packed.prepend(QByteArray("\0\1\0\0", 4)); // the size that qUncompress begins with
        const QByteArray content = qUncompress(packed);
        QCOMPARE(content.count("S\n"), 6);
        QCOMPARE(content.count("f*\n"), 1);
        QVERIFY(content.contains("20 70 m\n40 20 60 120 120 40 c\nS\n"));
        QVERIFY(content.contains("[6 3 1 6 3 1 ] 18 d\n"));
    }

    void aPictureThatIsTooLargeIsRefused()
    {
        app::WriteOptions options;
        options.dpi = 5000;
        const auto error = app::writeFile({}, path("large.png"), options);
        QVERIFY(error);
        QVERIFY2(
            error->endsWith("the picture would have 58465 × 41339 pixels, but at most 32767 pixels "
                            "a side and 150000000 in all are possible. Choose 1245 dpi or less."),
            qPrintable(*error));
        QVERIFY(!QFile::exists(path("large.png")));
    }

    void hugeNumbersAndFineDashesEnd()
    {
        app::Sheet sheet;
        app::Style style = pen(1);
        style.dashes = {1e-6, 1e-6};
        style.fill = app::Colour{255, 0, 0, 255};
        sheet.shapes = {
            {{{{-1e300, 105}, {{{1e300, 105}}, {{1e300, 1e300}}, {{-1e300, 1e300}}}, true}},
             style,
             {},
             0,
             false}};
        const QImage png = ours(sheet), pdf = byPoppler(sheet);
        for (const QImage& image : {png, pdf}) {
            QVERIFY(!image.isNull());
            QCOMPARE(image.pixelColor(image.width() / 2, image.height() / 4), QColor(Qt::white));
            QCOMPARE(image.pixelColor(image.width() / 2, image.height() * 3 / 4), QColor(Qt::red));
        }
    }

    // QPainter takes longer for it than a test function may.
    void aLongScribbleIsExported()
    {
        app::Sheet sheet;
        app::Subpath path{{0, 0}, {}, false};
        for (std::int64_t i = 1; i < 60'000; ++i)
            path.segments.push_back({{(i * 7919) % 211, (i * 104'729) % 149}});
        app::Style style = pen(1);
        style.fill = app::Colour{255, 255, 0, 255};
        sheet.shapes = {{{path}, style, {}, 0, false}};
        const QImage png = ours(sheet);
        QVERIFY(!png.isNull());
        QCOMPARE(png.pixelColor(100, 75), QColor(Qt::black)); // covered many times
    }
};

} // namespace formats_paper_test

TEST_CLASS(formats_paper_test::PaperTest, Core)
#include "tests/app/formats/paper_test.moc"

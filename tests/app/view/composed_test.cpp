// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that are put together from the picture of all lines, beside those painted from the pieces.
#include "app/base/background.h"
#include "app/base/variant.h"
#include "app/document/document_builder.h"
#include "app/scene/scene_lines.h"
#include "app/view/frame_painting.h"
#include "app/view/hairline_drawing.h"
#include "app/view/region_mask.h"

#include <QTest>
#include <QThreadPool>

#include <random>

#include "tests/app/scene/mixed_windows.h"
#include "tests/app/view/joined.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace view_composed_test {

namespace {

constexpr int side = 300; // pixels
const app::Page page{{0, 0}, {100, 100}, {100, app::Unit::Mm}, {100, app::Unit::Mm}};

/// Lines with both ends anywhere, of some colours, thinner than a pixel and a half.
enum class Colours : std::uint8_t { One, Opaque, Mixed };
app::Document thinLines(int count, unsigned seed, Colours colours = Colours::Mixed, int beside = 0)
{
    std::mt19937 random(seed);
    const auto point = [&] { return app::Point(random() % 1100, random() % 1100) / 10.0 - 5.0; };
    const std::array all{app::Colour{}, app::Colour{200, 30, 40}, app::Colour{0, 90, 200, 120}};
    const std::size_t used = colours == Colours::One ? 1 : colours == Colours::Opaque ? 2 : 3;
    const unsigned widths = colours == Colours::Mixed ? 5 : 4; // at most a pixel
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    for (int i = 0; i < count; ++i) {
        const app::Style style{.stroke = all[random() % used],
                               .width = double(random() % widths) / 10};
        builder.addLine({point(), point()}, builder.style(style));
        for (int k = 0; k < beside / count; ++k) // not seen, but clipped
            builder.addLine({{-9, 300 + k}, {99, 300}}, builder.style(style));
    }
    builder.close();
    return builder.take(page);
}

app::FrameWish wishFor(const app::Document& document, const app::ClipWindows& windows)
{
    app::FrameWish wish{.key = {}, .document = document, .lines = app::linesOf(document)};
    wish.key = {.lines = wish.lines.revision(),
                .view = {.size = {side, side}, .centre = {50, 50}, .zoom = 3},
                .region = regionOf(windows, 0.001),
                .variant = {&clipping::exactAlgorithm()},
                .pixels = {side, side}};
    wish.ghost = 0.3;
    return wish;
}

/// Black lines of one width, at a rectangular window.
app::FrameWish wishFor(const std::vector<clipping::Segment>& lines, double width)
{
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    for (const clipping::Segment& line : lines)
        builder.addLine(line, builder.style({.stroke = app::Colour{}, .width = width}));
    builder.close();
    return wishFor(builder.take(page), {{{.shape = app::RectangleShape{{{20, 20}, {60, 70}}}}}});
}

app::PaintedFrame framePaintedWith(app::FramePainter& painter, const app::FrameWish& wish)
{
    return painter.paint(wish, {{}, [](const app::Progress&) {}},
                         std::make_shared<app::FrameParts>());
}

QImage paintedWith(app::FramePainter& painter, const app::FrameWish& wish)
{
    return framePaintedWith(painter, wish).image;
}

app::PaintedFrame roughFrameOfPublishedKwc(app::FramePainter& painter, app::FrameWish& wish)
{
    wish.key.variant = {clipping::findAlgorithm("kodituwakku-wijeweera-chamikara"),
                        clipping::Form::Published};
    wish.rough = true;
    return framePaintedWith(painter, wish);
}

/// The same from the pieces of its lines.
int threads() { return app::paintingThreads().maxThreadCount(); }
QImage paintedFromPieces(const app::FrameWish& wish, int scale = 1)
{
    app::SceneClipping clipping;
    const auto* uses = clipping::functionsOf(*wish.key.variant.algorithm, wish.key.variant.form);
    const app::SceneFrame frame = clipping.clip(wish.lines, wish.key.region, uses->clipAll);
    const app::PictureOptions options = wish.pictureOptions();
    const app::Picture shown = picture(wish.document.styles(), wish.lines, frame, options);
    std::vector<QImage> bands; // as many: edges are rounded from where a band begins
    for (const app::Band& band : app::bandsOf(side * scale, scale > 1 ? 1 : threads()))
        bands.push_back(rasterised(shown, band, {side * scale, double(scale), wish.ghost}));
    return joined(bands);
}

/// The truth: the pieces on 8 by 8 times as many pixels.
QImage supersampled(const app::FrameWish& wish)
{
    constexpr int times = 8;
    const QImage large = paintedFromPieces(wish, times);
    QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            std::array<int, 4> sum{};
            for (int i = 0; i < times * times; ++i) {
                const QRgb p = reinterpret_cast<const QRgb*>(
                    large.constScanLine(y * times + i / times))[x * times + i % times];
                const std::array channels{qRed(p), qGreen(p), qBlue(p), qAlpha(p)};
                for (std::size_t k = 0; k < 4; ++k)
                    sum[k] += channels[k];
            }
            for (int& channel : sum)
                channel /= times * times;
            reinterpret_cast<QRgb*>(image.scanLine(y))[x] = qRgba(sum[0], sum[1], sum[2], sum[3]);
        }
    return image;
}

int differenceOf(const QImage& a, const QImage& b, int x, int y) // of premultiplied channels
{
    const QRgb p = reinterpret_cast<const QRgb*>(a.constScanLine(y))[x];
    const QRgb q = reinterpret_cast<const QRgb*>(b.constScanLine(y))[x];
    return std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                     std::abs(qBlue(p) - qBlue(q)), std::abs(qAlpha(p) - qAlpha(q))});
}

/// Empty if the frame looks as one for which no picture was kept. QPainter rounds an edge from
/// where its image begins.
QString differenceFromAnew(const QImage& frame, app::FrameWish wish)
{
    wish.drawings.reset();
    app::FramePainter painter;
    const QImage expected = paintedWith(painter, wish);
    int sum = 0, many = 0;
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x) {
            const int difference = differenceOf(frame, expected, x, y);
            sum += difference;
            many += difference > 12;
        }
    const bool isSame = sum <= frame.width() * frame.height() * 0.2 && many <= 3;
    return isSame ? QString() : QString("%1, %2").arg(sum).arg(many);
}

/// Whether no edge is within some pixels of a pixel.
bool isFarFromEdges(const QImage& mask, int x, int y, int far = 2)
{
    const int here = mask.constScanLine(y)[x];
    for (int v = std::max(0, y - far); v <= std::min(side - 1, y + far); ++v)
        for (int u = std::max(0, x - far); u <= std::min(side - 1, x + far); ++u)
            if (const int other = mask.constScanLine(v)[u]; other != here || other % 255 != 0)
                return false;
    return true;
}

struct Compared {
    int most = 0;               ///< far from the edges
    double sum = 0, pixels = 0; ///< near them
    int mostNear = 0;
};
void compare(const QImage& a, const QImage& b, const QImage& mask, Compared& into)
{
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int difference = differenceOf(a, b, x, y);
            if (isFarFromEdges(mask, x, y)) {
                into.most = std::max(into.most, difference);
                continue;
            }
            into.sum += difference, into.pixels += 1;
            into.mostNear = std::max(into.mostNear, difference);
        }
}

} // namespace

class ComposedTest : public QObject {
    Q_OBJECT

private slots:
    void itLooksLikeThePieces_data()
    {
        QTest::addColumn<Mixed>("most");
        QTest::addColumn<int>("windows");
        QTest::newRow("a rectangle") << Mixed::Rectangle << 1;
        QTest::newRow("a rotated one") << Mixed::Rotated << 1;
        QTest::newRow("a convex one") << Mixed::Convex << 1;
        QTest::newRow("any") << Mixed::Any << 1;
        QTest::newRow("several rectangles") << Mixed::Rectangle << 3;
        QTest::newRow("several of any shape") << Mixed::Any << 4;
    }
    void itLooksLikeThePieces()
    {
        QFETCH(Mixed, most);
        QFETCH(int, windows);
        Compared beside, composed, pieces;
        for (unsigned seed = 1; seed <= 12; ++seed) {
            MixedWindows mixed(seed);
            app::FrameWish wish = wishFor(thinLines(120, seed), mixed.windows(windows, most));
            wish.options.removed = app::RemovedPart(seed % 3);
            app::FramePainter painter;
            const QImage image = paintedWith(painter, wish), old = paintedFromPieces(wish),
                         truth = supersampled(wish),
                         mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, 1);
            compare(image, old, mask, beside);
            compare(image, truth, mask, composed);
            compare(old, truth, mask, pieces);
        }
        qInfo("far from edges at most %d; near them %.2f on average, at most %d, and of the pieces "
              "%.2f, at most %d",
              beside.most, composed.sum / composed.pixels, composed.mostNear,
              pieces.sum / pieces.pixels, pieces.mostNear);
        // A piece is rounded from its own start. In a pixel that an edge crosses a mask does not
        // know on which side of the edge a line lies, which is seen where they are almost parallel.
        QVERIFY(beside.most <= 6);
        QVERIFY(composed.sum / composed.pixels <= 1.3 * pieces.sum / pieces.pixels);
        QVERIFY(composed.mostNear <= 190);
    }
    /// A window that moves changes nothing else: the picture of all lines is painted once.
    void onlyTheMaskMoves()
    {
        app::ClipWindows windows{{{.shape = app::RectangleShape{{{20, 20}, {60, 70}}}}}};
        app::FrameWish wish = wishFor(thinLines(200, 1), windows);
        app::FramePainter painter;
        paintedWith(painter, wish);
        for (int step = 1; step < 20; ++step) {
            windows.list[0].shape =
                app::RectangleShape{{{20 + step * 0.37, 20}, {60, 70 - step * 1.1}}};
            wish.key.region = regionOf(windows, 0.001);
            app::FramePainter another;
            QCOMPARE(paintedWith(painter, wish), paintedWith(another, wish));
        }
        wish.key.view.pan({10.3, 3}); // another view is painted anew
        app::FramePainter another;
        QCOMPARE(paintedWith(painter, wish), paintedWith(another, wish));
        wish.key.look = 1; // and another look
        wish.options.page = app::Colour{20, 20, 20};
        app::FramePainter third;
        QCOMPARE(paintedWith(painter, wish), paintedWith(third, wish));
    }
    /// A pan by whole device pixels moves the picture of all lines, and paints what it uncovers.
    void aPanPaintsWhatItUncovers_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("pixelRatio");
        QTest::newRow("hairlines") << 0.3 << 1.0;
        QTest::newRow("thick strokes") << 2.0 << 1.0;
        QTest::newRow("two pixels a point") << 0.1 << 2.0;
    }
    void aPanPaintsWhatItUncovers()
    {
        QFETCH(double, width);
        QFETCH(double, pixelRatio);
        std::mt19937 random(5);
        const auto point = [&] {
            return app::Point(random() % 1100, random() % 1100) / 10.0 - 5.0;
        };
        std::vector<clipping::Segment> lines;
        for (int i = 0; i < 300; ++i)
            lines.push_back({point(), point()});
        for (int i = 0; i < 30'000; ++i) // so many that wide strokes have rough frames
            lines.push_back({{300, 300}, {301, 300 + i * 0.01}});
        app::FrameWish wish = wishFor(lines, width);
        wish.rough = true;
        wish.key.pixelRatio = pixelRatio;
        wish.key.pixels = wish.key.pixels * pixelRatio;
        wish.drawings = std::make_shared<app::DrawingPictures>();
        app::FramePainter painter;
        paintedWith(painter, wish);
        for (int i = 0; i < 16; ++i) {
            const glm::dvec2 by{int(random() % 121) - 60,
                                i % 5 == 0 ? 0 : int(random() % 121) - 60};
            wish.key.view.pan(by / pixelRatio);
            if (i % 6 == 5)
                wish.key.view.centre = {50, 50}; // or all lines would be gone in the end
            const QImage moved = paintedWith(painter, wish);
            const QString fault = differenceFromAnew(moved, wish);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(fault)));
        }
    }
    void keptPicturesAreAsThoseMadeAnew_data()
    {
        QTest::addColumn<Colours>("colours");
        QTest::newRow("one colour") << Colours::One;
        QTest::newRow("some") << Colours::Opaque;
        QTest::newRow("also translucent") << Colours::Mixed;
    }
    void keptPicturesAreAsThoseMadeAnew()
    {
        QFETCH(Colours, colours);
        std::mt19937 random(21);
        const auto whole = [&](int below) { return double(random() % unsigned(below)); };
        app::FrameWish wish = wishFor(thinLines(60, 1, colours), {});
        wish.drawings = std::make_shared<app::DrawingPictures>();
        app::FramePainter painter;
        const std::array<std::function<void()>, 6> acts{
            [&] {
                wish.document = thinLines(60, random(), colours);
                wish.lines = app::linesOf(wish.document);
                wish.key.lines = wish.lines.revision();
            },
            [&] {
                const app::Point from(whole(90), whole(90)), size(whole(60), whole(60));
                const app::ClipWindows windows{
                    {{.shape = app::RectangleShape{{from, from + size}}}}};
                wish.key.region = regionOf(windows, page);
            },
            [&] {
                wish.key.view.zoomAt({whole(side), whole(side)}, 0.7 + whole(7) / 10);
            },
            [&] {
                wish.key.view.pan({whole(81) - 40, whole(81) - 40});
            },
            [&] {
                wish.key.view.pan({whole(81) - 40, 0});
            },
            [&] { wish.options.removed = app::RemovedPart(random() % 3); }};
        const int steps = qEnvironmentVariableIsSet("CLEARCUT_DEEP") ? 1000 : 100;
        for (int i = 0; i < steps; ++i) {
            acts[random() % acts.size()]();
            if (i % 40 == 0)
                wish.key.view = wishFor(wish.document, {}).key.view; // or all would be gone
            const QImage kept = paintedWith(painter, wish);
            const QString fault = differenceFromAnew(kept, wish);
            QVERIFY2(fault.isEmpty(), qPrintable(QString("%1: %2").arg(i).arg(fault)));
        }
    }
    void aPanKeepsWhatItDoesNotUncover()
    {
        app::FrameWish wish = wishFor(thinLines(200, 1), {});
        wish.drawings = std::make_shared<app::DrawingPictures>();
        app::FramePainter painter, another;
        paintedWith(painter, wish);
        QImage planted = wish.drawings->find(drawingKeyOf(wish)).picture;
        planted.fill(qRgb(1, 2, 3));
        wish.drawings->keep(drawingKeyOf(wish), planted);
        wish.key.view.pan({-40, 25});
        const QImage moved = paintedWith(painter, wish);
        wish.drawings.reset();
        const QImage expected = paintedWith(another, wish);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                QVERIFY(differenceOf(moved, x < side - 40 && y >= 25 ? planted : expected, x, y)
                        <= (x < side - 40 && y >= 25 ? 0 : 8));
        app::FrameKey key = wish.key;
        key.view.pan({3, -7});
        QCOMPARE(wholePixelsBetween(wish.key, key), std::optional(QPoint(3, -7)));
        key.view.pan({0.5, 0});
        QVERIFY(!wholePixelsBetween(wish.key, key));
        key = wish.key;
        key.view.zoomAt({9, 9}, 1.1);
        QVERIFY(!wholePixelsBetween(wish.key, key));
        key = wish.key;
        key.view.centre.x = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!wholePixelsBetween(wish.key, key));
    }
    /// Panes of the same view paint the lines once.
    void panesShareThePictureOfAllLines()
    {
        app::FrameWish wish = wishFor(thinLines(200, 1), {});
        wish.drawings = std::make_shared<app::DrawingPictures>();
        app::FramePainter one, other;
        const QImage expected = paintedWith(one, wish);
        const QImage kept = wish.drawings->find(drawingKeyOf(wish)).picture;
        QCOMPARE(kept, expected); // without a window nothing is removed
        QImage planted = kept;
        planted.fill(qRgb(1, 2, 3));
        wish.drawings->keep(drawingKeyOf(wish), planted);
        QCOMPARE(paintedWith(other, wish), planted);
        for (int i = 1; i <= 2; ++i) {             // only the latest are kept
            wish.key.view.pan({double(i) / 4, 0}); // by no whole pixel
            paintedWith(one, wish);
        }
        wish.key.view.pan({-0.75, 0});
        QCOMPARE(wish.drawings->find(drawingKeyOf(wish)).missing,
                 std::vector{QRect(0, 0, side, side)}); // nothing is known
        QCOMPARE(paintedWith(other, wish), expected);
    }
    /// A published form that loses lines is shown to lose them.
    void whatARowLosesIsSeenToBeLost()
    {
        app::FrameWish wish = wishFor({{{39.7, 30}, {40.3, 50}}}, 0.3); // less than 1 in x
        wish.key.variant = {clipping::findAlgorithm("kodituwakku-wijeweera-chamikara"),
                            clipping::Form::Published};
        app::FramePainter painter;
        const app::PaintedFrame frame = framePaintedWith(painter, wish);
        const QImage lost = frame.image, expected = paintedFromPieces(wish);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                QVERIFY(differenceOf(lost, expected, x, y) <= 2); // of one line alone
        QCOMPARE(frame.differing, std::size_t(1));
        wish.key.variant = {&clipping::exactAlgorithm()};
        QVERIFY(paintedWith(painter, wish) != lost);
    }
    /// Of a large drawing such a frame is put together at once, with these lines painted anew, and
    /// painted from the pieces later.
    void whatARowLosesIsSeenAtOnce_data()
    {
        QTest::addColumn<double>("width");
        QTest::addColumn<int>("removed");
        for (const auto removed : {app::RemovedPart::Ghosted, app::RemovedPart::Hidden}) {
            QTest::addRow("hairlines, %d", int(removed)) << 0.3 << int(removed);
            QTest::addRow("thick strokes, %d", int(removed)) << 2.0 << int(removed);
        }
    }
    void whatARowLosesIsSeenAtOnce()
    {
        QFETCH(double, width);
        QFETCH(int, removed);
        std::vector<clipping::Segment> lines{{{39.7, 30}, {40.3, 50}}, // KWC loses it
                                             {{30, 10}, {50, 40}},
                                             {{10, 45}, {55, 55}}};
        for (int i = 0; i < 30'000; ++i) // a crowd beside the window
            lines.push_back({{80, 80 + i % 100 * 0.1}, {82, 80 + i % 90 * 0.1}});
        app::FrameWish wish = wishFor(lines, width);
        wish.options.removed = app::RemovedPart(removed);
        app::FramePainter painter;
        const app::PaintedFrame frame = roughFrameOfPublishedKwc(painter, wish);
        QVERIFY(frame.rough);
        QCOMPARE(frame.differing, std::size_t(1));
        wish.rough = false;
        const app::PaintedFrame fine = framePaintedWith(painter, wish);
        QVERIFY(!fine.rough);
        QCOMPARE(fine.differing, std::size_t(1));
        const QImage pieces = paintedFromPieces(wish),
                     mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, 1);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                VERIFY_OR_SAY(differenceOf(fine.image, pieces, x, y) <= 6,
                              qPrintable(QString("%1, %2").arg(x).arg(y)));
                if (isFarFromEdges(mask, x, y, 2 + int(3 * width)))
                    VERIFY_OR_SAY(differenceOf(frame.image, pieces, x, y) <= 6,
                                  qPrintable(QString("%1, %2").arg(x).arg(y)));
            }
        QVERIFY(qAlpha(frame.image.pixel(120, 120)) < 100); // in the middle of the lost line
    }
    /// A lost line leaves no gap where other lines cover the same pixels.
    void whatOtherLinesCoverStaysCovered_data()
    {
        QTest::addColumn<int>("others");
        QTest::addColumn<double>("width");
        QTest::addColumn<int>("lost");
        for (const double width : {0.3, 1.0 / 3}) { // 0.9 and 1 pixel, which covers some completely
            QTest::addRow("a few lines, %g", width) << 100 << width << 20;
            QTest::addRow("many, %g", width) << 1000 << width << 20;
            QTest::addRow("everything is covered, %g", width) << 9000 << width << 20;
        }
        QTest::newRow("a crowd is lost in a crowd") << 25'000 << 1.0 / 3 << 2000;
    }
    void whatOtherLinesCoverStaysCovered()
    {
        QFETCH(int, others);
        QFETCH(double, width);
        QFETCH(int, lost);
        std::mt19937 random(7);
        const auto number = [&] { return double(random() % 1000) / 10; };
        std::vector<clipping::Segment> lines;
        for (int i = 0; i < lost; ++i) { // less than 1 in x: KWC loses it
            const double x = 22 + 36.0 / lost * i;
            lines.push_back({{x, 30}, {x + 0.7, 60}});
        }
        for (int i = 0; i < others; ++i)
            lines.push_back({{number(), number()}, {number(), number()}});
        while (lines.size() < 30'000) // a crowd beside the window
            lines.push_back({{80, 80}, {82, 80 + double(lines.size() % 90) * 0.1}});
        app::FrameWish wish = wishFor(lines, width);
        app::FramePainter painter;
        const app::PaintedFrame frame = roughFrameOfPublishedKwc(painter, wish);
        QVERIFY(frame.rough);
        QVERIFY(frame.differing >= 20);
        const QImage pieces = paintedFromPieces(wish),
                     mask = regionMask(wish.key.region, wish.key.view, wish.key.pixels, 1);
        double sum = 0, pixels = 0;
        int many = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (isFarFromEdges(mask, x, y)) {
                    const int difference = differenceOf(frame.image, pieces, x, y);
                    sum += difference, pixels += 1;
                    many += difference > 24;
                }
        // Where lines that are removed cover a pixel completely, what others leave of it is a
        // guess.
        QVERIFY2(sum / pixels < 2 && many < (width < 1.0 / 3 ? 30 : 90),
                 qPrintable(QString("%1, %2").arg(sum / pixels).arg(many)));
    }
    /// Separate hairlines are painted straight from the scene, with the same pixels in any bands.
    void hairlinesFromTheSceneLookLikeThoseOfADrawList_data()
    {
        QTest::addColumn<int>("colours");
        QTest::newRow("one colour") << 1;
        QTest::newRow("many") << 7;
    }
    void hairlinesFromTheSceneLookLikeThoseOfADrawList()
    {
        QFETCH(int, colours);
        std::mt19937 random(3);
        app::DocumentBuilder builder;
        builder.open({.name = "Lines"});
        const auto styleOf = [&](int colour) {
            return builder.style({.stroke = app::Colour{std::uint8_t(colour * 30), 0, 90},
                                  .width = 0.1 + 0.05 * (colour % 3),
                                  .cap = app::Cap(colour % 3)});
        };
        const auto point = [&] {
            return app::Point(random() % 1400, random() % 1400) / 10.0 - 20.0;
        };
        clipping::Segment line{{-20, 50}, {120, 50}};
        for (int i = 0; i < 2000; ++i) {
            const app::StyleEntry style = styleOf((i / 150) % colours); // longer than a chunk
            if (i % 150 == 0)
                builder.addLine(line, style); // the last one in the next colour
            const app::Point from = point();
            line = {from, random() % 4 == 0 ? from : point()};
            for (int same = 1 + int(random() % 30) / 28 * 200; same > 0; --same)
                builder.addLine(line, style); // a repeated one adds nothing
        }
        builder.addLine({{-1e7, -1e7}, {1e9, 1e9 + 10}},
                        builder.style({.stroke = app::Colour{}, .width = 0.1}));
        builder.close();
        app::FrameWish wish = wishFor(builder.take(page), {});
        wish.options.leastWidth = 0.3;
        const app::StyleTable& styles = wish.document.styles();
        const app::PictureOptions options = wish.pictureOptions();
        const app::RasterOptions raster = wish.rasterOptions({});
        QVERIFY(app::hasOnlyHairlines(wish.lines, styles, options, 1));
        QVERIFY(!app::hasOnlyHairlines(wish.lines, styles, options, 4)); // wider than a pixel
        app::Picture list;
        app::SceneClipping clipping;
        const app::SceneFrame frame = clipping.clip(wish.lines, wish.key.region,
                                                    clipping::exactAlgorithm().corrected.clipAll);
        list.kept = wholeDrawing(styles, wish.lines, frame, options);
        const QImage expected = rasterised(list, {0, side}, raster);
        const auto painted = [&](const app::Band& band) {
            QImage image(side, band.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            paintHairlines(image, wish.lines, {{}, app::Painted::All}, styles, options, band,
                           raster);
            return image;
        };
        const QImage whole = painted({0, side});
        std::vector<QImage> bands;
        for (const app::Band& band : app::bandsOf(side, 7))
            bands.push_back(painted(band));
        QCOMPARE(joined(bands), whole);
        double sum = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const int difference = differenceOf(whole, expected, x, y);
                sum += difference;
                VERIFY_OR_SAY(difference <= 12,
                              qPrintable(QString("%1, %2: %3").arg(x).arg(y).arg(difference)));
            }
        // A draw list rounds to 255 steps at each change of colour; from the front nothing is
        // rounded before the end (hairlines_test compares it with the truth).
        const double mean = sum / (side * side), most = colours == 1 ? 0.5 : 0.75;
        QVERIFY2(mean < most, qPrintable(QString::number(mean)));
    }
    /// Lines that a row cuts differently are painted straight from the frame.
    void piecesOfHairlinesLookLikeThoseOfADrawList_data()
    {
        QTest::addColumn<Colours>("colours");
        QTest::addColumn<int>("behind"); // lines beside the view, in other blocks
        QTest::newRow("one colour") << Colours::One << 0;
        QTest::newRow("some") << Colours::Opaque << 0;
        QTest::newRow("some, of many blocks") << Colours::Opaque << 150'000;
    }
    void piecesOfHairlinesLookLikeThoseOfADrawList()
    {
        QFETCH(Colours, colours);
        QFETCH(int, behind);
        std::size_t differing = 0;
        int most = 0;
        for (unsigned seed = 1; seed <= (behind > 0 ? 4 : 30); ++seed) {
            MixedWindows mixed(seed);
            app::FrameWish wish = wishFor(thinLines(500, seed, colours, behind),
                                          mixed.windows(1 + int(seed % 3), Mixed::Rectangle));
            wish.selection = {3, 7, 200, 400};
            const auto marked = std::make_shared<std::vector<clipping::Clipped>>();
            marked->push_back({{{10, 20}, {90, 60}}, 0, 0});
            wish.differing = marked;
            wish.options.marked = {168, 15, 134};
            wish.key.variant = {clipping::findAlgorithm("kodituwakku-wijeweera-chamikara"),
                                clipping::Form::Published};
            wish.options.removed = app::RemovedPart(seed % 2); // ghosted or hidden
            app::FramePainter painter;
            const app::PaintedFrame frame = framePaintedWith(painter, wish);
            const QImage list = paintedFromPieces(wish);
            differing += frame.differing;
            double sum = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    const int difference = differenceOf(frame.image, list, x, y);
                    sum += difference;
                    if (frame.differing > 0)
                        most = std::max(most, difference);
                }
            QVERIFY2(frame.differing == 0
                         || sum / (side * side) < 1, // a draw list rounds more often
                     qPrintable(QString("seed %1: %2").arg(seed).arg(sum / (side * side))));
        }
        qInfo("%zu lines differ, pixels by at most %d of 255", differing, most);
        QVERIFY(differing > 0 && most <= 12);
    }
    /// Every piece of a line that a file repeats is there once: its coverage does not add up.
    void piecesOfRepeatedLinesAreThereOnce()
    {
        const clipping::Segment line{{1, 12}, {99, 77}};
        const auto painted = [&](std::size_t times) {
            const app::FrameWish wish = wishFor(std::vector(times, line), 0.3);
            const app::PictureOptions options = wish.pictureOptions();
            app::SceneClipping clipping;
            const app::SceneFrame frame = clipping.clip(
                wish.lines, wish.key.region, clipping::exactAlgorithm().corrected.clipAll);
            QImage image(side, side, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            paintHairlines(image, wish.lines, {frame, app::Painted::Removed},
                           wish.document.styles(), options, {0, side}, wish.rasterOptions({}));
            return image;
        };
        const QImage once = painted(1), often = painted(1000);
        QVERIFY(qAlpha(once.pixel(10, side - 45)) == 0); // transparent beside it
        QCOMPARE(often, once);
    }
    void aLineAlongAnEdgeIsKeptWhole()
    {
        // On the window's lower and right edges.
        const app::FrameWish wish = wishFor({{{0, 20}, {100, 20}}, {{60, 90}, {60, 10}}}, 0.4);
        app::FramePainter painter;
        const QImage composed = paintedWith(painter, wish), pieces = paintedFromPieces(wish);
        for (int x = 62; x < 178; ++x) // between the corners
            for (int y = 58; y < 63; ++y)
                QVERIFY(differenceOf(composed, pieces, x, y) <= 3);
        for (int y = 62; y < 208; ++y)
            for (int x = 178; x < 183; ++x)
                QVERIFY(differenceOf(composed, pieces, x, y) <= 3);
    }
    /// Thick strokes end at the cut at right angles to themselves, which a mask cannot show.
    void thickStrokesArePaintedFromPieces()
    {
        const app::FrameWish wish = wishFor({{{10, 10}, {90, 80}}}, 2);
        app::FramePainter painter;
        QCOMPARE(paintedWith(painter, wish), paintedFromPieces(wish));
    }
    void opacities()
    {
        QImage drawing(256, 2, QImage::Format_ARGB32_Premultiplied),
            mask(256, 2, QImage::Format_Alpha8);
        for (int x = 0; x < 256; ++x)
            for (int y = 0; y < 2; ++y) {
                drawing.setPixel(x, y, qRgba(x, x / 2, 0, x));
                mask.scanLine(y)[x] = uchar(y * 255);
            }
        QImage image(drawing.size(), drawing.format());
        app::compose(drawing, mask, 0.5, image);
        for (int x = 0; x < 256; ++x) {
            QCOMPARE(reinterpret_cast<const QRgb*>(image.constScanLine(1))[x],
                     reinterpret_cast<const QRgb*>(drawing.constScanLine(1))[x]);
            QVERIFY(
                std::abs(qAlpha(reinterpret_cast<const QRgb*>(image.constScanLine(0))[x]) - x / 2.0)
                <= 1);
        }
    }
};

} // namespace view_composed_test

TEST_CLASS(view_composed_test::ComposedTest, Gui)
#include "tests/app/view/composed_test.moc"

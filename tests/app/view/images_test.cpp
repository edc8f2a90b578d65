// SPDX-License-Identifier: GPL-3.0-or-later
// Images below layers, on the canvas: at their place among the lines, cut as the drawing is.
#include "app/document/document_builder.h"
#include "app/formats/paint_drawing.h"
#include "app/scene/scene.h"
#include "app/scene/scene_clipping.h"
#include "app/view/frame_painting.h"
#include "app/view/image_pixels.h"

#include <QBuffer>
#include <QImageWriter>
#include <QPainter>
#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace view_images_test {

using namespace app;

namespace {

constexpr int side = 100;
constexpr QRgb red = 0xff0000, green = 0x00ff00, black = 0, white = 0xffffff;

Style filled(const Colour& colour) { return {.stroke = std::nullopt, .fill = colour}; }

Object box(double x, double y, double width, double height, const Colour& colour)
{
    const Subpath path{
        {x, y}, {{{x + width, y}}, {{x + width, y + height}}, {{x, y + height}}}, true};
    return {Path({&path, 1}), filled(colour)};
}

/// A black area, above it an image of 40 by 30 at (10, 10), above that a white one.
Document drawing(ClipWindows windows = {})
{
    DocumentBuilder builder;
    builder.open({.name = "a"});
    builder.add(box(0, 0, 60, 60, {0, 0, 0}));
    builder.open({.name = "b", .underlay = testUnderlay({10, 10}, 10)});
    builder.add(box(20, 20, 10, 10, {255, 255, 255}));
    builder.close();
    builder.close();
    Page page;
    page.size = Point(side);
    page.width = page.height = {side, Unit::Px};
    return builder.take(page, {}, std::move(windows));
}

QImage onWhite(const QImage& image)
{
    QImage whole(side, side, QImage::Format_RGB32);
    whole.fill(Qt::white);
    QPainter(&whole).drawImage(0, 0, image);
    return whole;
}

/// The frame of a document of which a pixel is a unit.
QImage frameOf(const Document& document, RemovedPart removed = RemovedPart::Hidden)
{
    FrameWish wish{.key = {}, .document = document, .lines = linesOf(document)};
    wish.key.view.size = Point(side);
    wish.key.view.centre = Point(side / 2.0);
    wish.key.view.zoom = 1;
    wish.key.region = regionOf(document.windows(), document.page());
    wish.key.variant = {&clipping::exactAlgorithm(), clipping::Form::Corrected};
    wish.key.pixels = {side, side};
    wish.options.removed = removed;
    wish.underlays = seenUnderlays(document);
    wish.ghost = 0.5;
    return onWhite(FramePainter()
                       .paint(wish, {{}, [](const Progress&) {}}, std::make_shared<FrameParts>())
                       .image);
}

QRgb at(const QImage& image, int x, int y) { return image.pixel(x, y) & 0xffffff; }

ClipWindows windowsOf(std::vector<ClipWindow> list) { return {std::move(list), Keep::Inside}; }

} // namespace

class ImagesTest : public QObject {
    Q_OBJECT

private slots:
    void ofAnAnimationTheFirstPictureIsShown()
    {
        const QImage shown =
            pixelsOf(std::get<0>(imageFileOf(testGif()))).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(shown, testImage(4, 3));
        QVERIFY(isReadable(*std::get<0>(imageFileOf(testGif()))));
    }
    /// A photograph is seen as its camera was held.
    void isTurnedAsExifSays()
    {
        QImage held(40, 30, QImage::Format_RGB32); // red at the left
        held.fill(Qt::green);
        QPainter(&held).fillRect(0, 0, 20, 30, Qt::red);
        for (int turn = 0; turn < 8; ++turn) {
            QBuffer out;
            QImageWriter writer(&out, "jpeg");
            writer.setTransformation(QImageIOHandler::Transformations(turn));
            QVERIFY(writer.write(held));
            const auto found = imageFileOf(out.data());
            const auto* file = std::get_if<std::shared_ptr<const ImageFile>>(&found);
            QVERIFY(file);
            const bool across = turn & QImageIOHandler::TransformationRotate90;
            QCOMPARE(QSize((*file)->width, (*file)->height),
                     across ? QSize(30, 40) : QSize(40, 30));
            const QImage seen = pixelsOf(*file, 0);
            QCOMPARE(seen.size(), QSize((*file)->width, (*file)->height));
            const bool mirrored = turn & QImageIOHandler::TransformationMirror;
            const auto isRed = [&](int x, int y) { return qRed(seen.pixel(x, y)) > 128; };
            QCOMPARE(isRed(2, 2), !mirrored); // the left is the top after a quarter turn
            QCOMPARE(isRed(seen.width() - 3, seen.height() - 3), mirrored);
            QCOMPARE(isRed(seen.width() - 3, 2), across != mirrored);
        }
    }

    void liesAmongTheLines()
    {
        const QImage frame = frameOf(drawing());
        QCOMPARE(at(frame, 5, 5), black);
        QCOMPARE(at(frame, 15, 30), red);
        QCOMPARE(at(frame, 45, 30), green);
        QCOMPARE(at(frame, 25, 25), white);
        QCOMPARE(at(frame, 90, 90), white);
    }
    // The screen and a written picture show the same.
    void isThatOfAWrittenPicture()
    {
        const Document document = drawing();
        QImage written(side, side, QImage::Format_RGB32);
        written.fill(Qt::white);
        paintOn(written, document, 1);
        const QImage frame = frameOf(document);
        for (int y = 0; y < side; y += 3)
            for (int x = 0; x < side; x += 3)
                QCOMPARE(at(frame, x, y), at(written, x, y));
    }
    void isCutWithTheDrawing()
    {
        const Document document =
            drawing(windowsOf({{.shape = RectangleShape{{{0, 0}, {30, 60}}}}}));
        const QImage hidden = frameOf(document);
        QCOMPARE(at(hidden, 15, 30), red);
        QCOMPARE(at(hidden, 45, 30), white);
        const QImage ghosted = frameOf(document, RemovedPart::Ghosted);
        QCOMPARE(at(ghosted, 15, 30), red);
        QVERIFY(qGreen(ghosted.pixel(45, 30)) == 255 && qRed(ghosted.pixel(45, 30)) > 100);
        QCOMPARE(at(frameOf(document, RemovedPart::Shown), 45, 30), green);
    }
    // At other windows: at the rectangle around them, as in a file.
    void isCutAtTheRectangleAroundOtherWindows()
    {
        const Document document =
            drawing(windowsOf({{.shape = RectangleShape{{{10, 10}, {14, 40}}}},
                               {.shape = RectangleShape{{{30, 10}, {34, 40}}}}}));
        const QImage hidden = frameOf(document);
        QCOMPARE(at(hidden, 12, 30), red);
        QCOMPARE(at(hidden, 18, 35), red);
        QCOMPARE(at(hidden, 40, 30), white);
        QCOMPARE(at(hidden, 5, 5), white); // lines are cut along the windows
    }
    void isHalvedWhereItIsSmall()
    {
        const auto file = testFile(64, 32);
        QCOMPARE(pixelsOf(file).size(), QSize(64, 32));
        QCOMPARE(pixelsOf(file, 3).size(), QSize(8, 4));
        QCOMPARE(pixelsOf(file, 15).size(), QSize(1, 1));
        ImageFile damaged = *file;
        damaged.bytes.truncate(damaged.bytes.size() / 2);
        QVERIFY(isReadable(*file) && !isReadable(damaged));
        QVERIFY(pixelsOf(std::make_shared<const ImageFile>(damaged)).isNull());
    }
    // Far inside an image nothing overflows.
    void isPaintedAtDeepZoom()
    {
        QImage picture(side, side, QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        painter.scale(1e7, 1e7);
        painter.translate(-15, -30);
        paintUnderlay(painter, testUnderlay({10, 10}, 10));
        painter.end();
        QCOMPARE(at(picture, 50, 50), red);
    }
};

} // namespace view_images_test

TEST_CLASS(view_images_test::ImagesTest, Gui)
#include "tests/app/view/images_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Images of SVG files lie below layers, and are written again.
#include "app/formats/paint_drawing.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_image_test {

using namespace app;

namespace {

QByteArray address(const QByteArray& bytes, const char* kind = "png")
{
    return "data:image/" + QByteArray(kind) + ";base64," + bytes.toBase64();
}

/// An image of 4 by 3 pixels.
QByteArray image(const QByteArray& attributes)
{
    return "<image xlink:href='" + address(bytesOf(testImage(4, 3))) + "' " + attributes + "/>";
}

Document read(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? result.value->document : Document();
}

std::vector<Underlay> imagesOf(const Document& document)
{
    std::vector<Underlay> images;
    for (const ContainerId id : document.containers().underlaid())
        images.push_back(*document.containers()[id].underlay);
    return images;
}

QStringList layersOf(const Document& document)
{
    QStringList names;
    for (const ContainerId id : document.containers().inOrder())
        names << document.containers()[id].name;
    return names;
}

/// A picture of 100 by 100 pixels, one for each unit.
QImage painted(const Document& document)
{
    QImage picture(100, 100, QImage::Format_RGB32);
    picture.fill(Qt::white);
    paintOn(picture, document, 1);
    return picture;
}

QRgb at(const QImage& picture, int x, int y) { return picture.pixel(x, y) & 0xffffff; }
constexpr QRgb red = 0xff0000, green = 0x00ff00, black = 0, white = 0xffffff;

} // namespace

class ImageTest : public QObject {
    Q_OBJECT

private slots:
    void pixelsAreSmoothedOrItIsTold()
    {
        const auto told = [](const char* value) {
            return !readText(drawing(image("style='image-rendering:" + QByteArray(value) + "'")))
                        .value->report.empty();
        };
        for (const char* smooth : {"auto", "smooth", "optimizeQuality"})
            QVERIFY2(!told(smooth), smooth);
        for (const char* sharp : {"pixelated", "crisp-edges", "optimizeSpeed"})
            QVERIFY2(told(sharp), sharp);
    }
    void isReadWhereItLies_data()
    {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<QRectF>("seen"); // of it
        const auto row = [](const char* attributes, const QRectF& seen) {
            QTest::newRow(attributes) << QByteArray(attributes) << seen;
        };
        row("x='10' y='20' width='40' height='30'", {10, 20, 40, 30});
        row("", {0, 0, 4, 3});
        row("width='40'", {0, 0, 40, 30});
        row("height='30'", {0, 0, 40, 30});
        row("style='x:10px; width:8px; height:6px'", {10, 0, 8, 6});
        row("width='80' height='30'", {20, 0, 40, 30});
        row("width='80' height='30' preserveAspectRatio='xMinYMin'", {0, 0, 40, 30});
        row("width='80' height='30' preserveAspectRatio='none'", {0, 0, 80, 30});
        row("width='40' height='60' preserveAspectRatio='xMidYMid slice'", {0, 0, 40, 60});
        row("width='4' height='3' transform='translate(5 6) scale(2)'", {5, 6, 8, 6});
        row("width='40' height='30' clip-path='inset(10px)'", {10, 10, 20, 10});
    }
    void isReadWhereItLies()
    {
        QFETCH(QByteArray, attributes);
        QFETCH(QRectF, seen);
        const auto images = imagesOf(read(image(attributes)));
        QCOMPARE(images.size(), 1);
        QPolygonF outline;
        for (const Point& corner : outlineOf(images[0]))
            outline << QPointF(corner.x, corner.y);
        QCOMPARE(outline.boundingRect(), seen);
        QVERIFY(images[0].file->bytes == bytesOf(testImage(4, 3)));
    }

    void keepsThePaintingOrder()
    {
        const QByteArray below = "<path d='M0 0H60V60H0Z' fill='#000'/>";
        const QByteArray above = "<path d='M20 10H30V40H20Z' fill='#fff'/>";
        const Document document =
            read(below + image("x='10' y='10' width='40' height='30' opacity='1'") + above);
        QCOMPARE(layersOf(document), QStringList({"Drawing", "Image 1", "Drawing (2)"}));
        const QImage picture = painted(document);
        QCOMPARE(at(picture, 5, 5), black);
        QCOMPARE(at(picture, 15, 30), red);
        QCOMPARE(at(picture, 45, 30), green);
        QCOMPARE(at(picture, 25, 30), white);
        QCOMPARE(at(picture, 70, 70), white);
    }

    void belongsToTheLayerThatItBegins()
    {
        const QByteArray line = "<path d='M0 0L9 9' stroke='#000'/>";
        const QByteArray open = "<g inkscape:groupmode='layer' inkscape:label='a'>";
        const Document own = read(open + "<title>t</title>" + image("id='i'") + line + "</g>");
        QCOMPARE(layersOf(own), QStringList("a"));
        QCOMPARE(imagesOf(own).at(0).svgId, "i");
        const Document inner = read(open + line + image("inkscape:label='b'") + "</g>");
        QCOMPARE(layersOf(inner), QStringList({"a", "b"}));
        QVERIFY(inner.containers()[inner.containers().underlaid()[0]].locked);
        const Document hidden = read(open + image("display='none'") + line + "</g>");
        QCOMPARE(layersOf(hidden), QStringList({"a", "Image 1"}));
        QVERIFY(seenUnderlays(hidden).empty());
        const Document group = read("<g id='g'><g id='h'>" + line + image("") + "</g></g>");
        QCOMPARE(layersOf(group), QStringList({"g", "h", "Image 1"}));
    }

    void isUsedLikeAnyElement()
    {
        const auto images =
            imagesOf(read("<defs>" + image("id='i'") + "</defs><use xlink:href='#i' x='9'/>"
                          + "<g id='g'><use xlink:href='#i' y='9'/></g>"));
        QCOMPARE(images.size(), 2);
        QCOMPARE(images[0].place.to, Point(9, 0));
        QCOMPARE(images[1].place.to, Point(0, 9));
        QVERIFY(images[0].file == images[1].file); // read once
    }

    void isWrittenAgain_data()
    {
        QTest::addColumn<QByteArray>("attributes");
        for (const char* attributes :
             {"x='10' y='20' width='40' height='30'", "width='7' height='.3' opacity='0.25'",
              "transform='rotate(30 3 4) skewX(5)' x='.1'", "transform='scale(-1 1)'",
              "width='40' height='30' transform='rotate(20)' clip-path='inset(3px)'",
              "width='40' height='60' preserveAspectRatio='xMidYMid slice'", "visibility='hidden'"})
            QTest::newRow(attributes) << QByteArray(attributes);
    }
    void isWrittenAgain()
    {
        QFETCH(QByteArray, attributes);
        const Document document =
            read("<g inkscape:groupmode='layer' inkscape:label='a'><path d='M0 0L9 9' "
                 "stroke='#000'/>"
                 + image(attributes) + "</g>");
        QCOMPARE(imagesOf(document).size(), 1);
        const auto again = readText(textOf(document));
        QVERIFY2(again, qPrintable(again.error));
        QCOMPARE(again.value->report.size(), 0);
        QVERIFY(again.value->document.containers() == document.containers());
        QVERIFY(imagesOf(again.value->document) == imagesOf(document));
    }

    void aGifIsKeptAsItIs()
    {
        const Document document =
            read("<image xlink:href='" + address(testGif(), "gif") + "' width='40' height='30'/>");
        const QImage picture = painted(document);
        QCOMPARE(at(picture, 10, 20), red);
        QCOMPARE(at(picture, 30, 20), green);
        const QByteArray text = textOf(document);
        QVERIFY2(text.contains("\"data:image/gif;base64,R0lGOD"), text);
        const auto again = readText(text);
        QVERIFY(again);
        QCOMPARE(again.value->report.size(), 0);
        QCOMPARE(imagesOf(again.value->document).at(0).file->bytes, testGif());
    }

    void liesBesideItsFile()
    {
        QTemporaryDir folder;
        QDir dir(folder.path());
        QVERIFY(dir.mkpath("in/below"));
        const auto put = [&](const QString& name, const QByteArray& bytes) {
            QFile file(dir.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
        };
        const QByteArray png = bytesOf(testImage(4, 3));
        QVERIFY(put("outside.png", png) && put("in/a b.png", png) && put("in/below/c.jpg", png));
        QVERIFY(QFile::link(dir.filePath("outside.png"), dir.filePath("in/link.png")));
        const auto lost = [&](const QByteArray& href) {
            const bool isPut = put("in/d.svg", drawing("<image href='" + href + "'/>"));
            const auto result = isPut ? readFile(dir.filePath("in/d.svg")) : Result<Imported>();
            return !result                        ? result.error
                   : result.value->report.empty() ? QString("nothing")
                                                  : result.value->report[0].what;
        };
        const QByteArray whole = dir.filePath("in/a b.png").toUtf8();
        for (const QByteArray& kept :
             {QByteArray("a%20b.png"), QByteArray("a b.png"), QByteArray("./below/c.jpg"),
              QByteArray("below/../a b.png"), whole, "file://" + whole.toPercentEncoding("/")})
            QCOMPARE(lost(kept), "nothing");
        const QString elsewhere = "image that is neither in the file nor in its folder or below";
        for (const QByteArray& other :
             {QByteArray("../outside.png"), QByteArray("link.png"),
              dir.filePath("outside.png").toUtf8(), QByteArray("http://example.org/a.png"),
              QByteArray("file:a b.png"), QByteArray("below/../../outside.png")})
            QCOMPARE(lost(other), elsewhere);
        QCOMPARE(lost("none.png"), "image whose own file is missing or cannot be read");
        QCOMPARE(lost("below"), "image whose own file is missing or cannot be read");
        QCOMPARE(lost("d.svg"), "image that an SVG image takes from another file"); // itself
    }

    void tellsWhatItCannotKeep()
    {
        const auto told = [](const QByteArray& bytes) {
            return reportOf("<image href='" + address(bytes) + "'/>");
        };
        const QByteArray png = bytesOf(testImage(40, 30));
        QByteArray huge = png;
        huge.replace(16, 17, QByteArray::fromHex("000186a0000186a0080200000027309c9f"));
        QCOMPARE(told(png), "");
        QCOMPARE(told(huge), "1 image that is too large");
        QCOMPARE(told(png.first(png.size() / 2)), "1 damaged image");
        QCOMPARE(told("GIF89a"), "1 damaged image");
        QCOMPARE(told("RIFF....WEBP"), "1 image that is neither PNG, JPEG, GIF nor SVG");
        QCOMPARE(reportOf(image("width='0'")),
                 "1 element of size 0 or less, which SVG does not draw, was left out");
        QCOMPARE(
            reportOf("<clipPath id='c'><circle r='9'/></clipPath>" + image("clip-path='url(#c)'")),
            "1 clip path was replaced by a real cut; 1 clip path of an image that is not one "
            "convex polygon");
        QCOMPARE(reportOf(image("").repeated(501)), "1 image beyond the first 500");
    }

    void hidesWhatItsClipPathHides()
    {
        const Document document = read("<clipPath id='c'><rect x='20' width='10' height='100'/>"
                                       "</clipPath><g clip-path='url(#c)'>"
                                       + image("y='10' width='40' height='30'") + "</g>");
        const QImage picture = painted(document);
        QCOMPARE(at(picture, 15, 30), white);
        QCOMPARE(at(picture, 25, 30), green);
        QCOMPARE(at(picture, 35, 30), white);
        QVERIFY(imagesOf(read("<clipPath id='c'/><g clip-path='url(#c)'>" + image("") + "</g>"))
                    .empty());
    }
};

} // namespace formats_svg_image_test

TEST_CLASS(formats_svg_image_test::ImageTest, Gui)
#include "tests/app/formats/svg/image_test.moc"

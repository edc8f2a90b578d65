// SPDX-License-Identifier: GPL-3.0-or-later
// An image that is an SVG drawing is drawn into its box, as objects.
#include "app/formats/gzip.h"
#include "app/formats/paint_drawing.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_svg_image_test {

using namespace app;

namespace {

QByteArray address(const QByteArray& svg) { return "data:image/svg+xml;base64," + svg.toBase64(); }

QByteArray svg(const QByteArray& attributes, const QByteArray& elements)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
           "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
           + attributes + ">" + elements + "</svg>";
}

QByteArray image(const QByteArray& attributes, const QByteArray& content)
{
    return "<image " + attributes + " xlink:href='" + address(content) + "'/>";
}

Document read(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? result.value->document : Document();
}

/// The box around all points.
QRectF boxOf(const Document& document)
{
    QPolygonF points;
    document.objects().forEach(
        0, document.objects().size(), [&](std::size_t, const ObjectView& object) {
            object.path().forEachPoint([&](const Point& p) { points << QPointF(p.x, p.y); });
        });
    return points.boundingRect();
}

const QByteArray square = "<rect x='2' y='2' width='6' height='6' fill='#f00'/>";

} // namespace

class SvgImageTest : public QObject {
    Q_OBJECT

private slots:
    void liesInItsBox_data()
    {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<QByteArray>("root");
        QTest::addColumn<QRectF>("seen");
        const auto row = [](const char* attributes, const char* root, const QRectF& seen) {
            QTest::addRow("%s / %s", attributes, root)
                << QByteArray(attributes) << QByteArray(root) << seen;
        };
        const char* const box = "x='10' y='20' width='40' height='20'";
        row(box, "viewBox='0 0 10 10'", {24, 24, 12, 12});
        row("x='10' y='20' width='40' height='20' preserveAspectRatio='xMinYMin'",
            "viewBox='0 0 10 10'", {14, 24, 12, 12});
        row("x='10' y='20' width='40' height='20' preserveAspectRatio='none'",
            "viewBox='0 0 10 10'", {18, 24, 24, 12});
        row("x='10' y='20' width='40' height='20' preserveAspectRatio='xMidYMid slice'",
            "viewBox='0 0 10 10'", {18, 20, 24, 20});
        row(box, "width='10' height='10'", {24, 24, 12, 12});
        row(box, "width='20' height='20' viewBox='0 0 10 10'", {24, 24, 12, 12});
        row(box, "width='20' height='10' viewBox='0 0 10 10'", {24, 24, 12, 12});
        row(box, "", {12, 22, 6, 6});
        row(box, "viewBox='0 0 5 5'", {28, 28, 12, 12}); // nothing is seen outside its viewport
        row("x='10' y='20'", "viewBox='0 0 10 10'", {12, 22, 6, 6});
        row("x='10' y='20'", "width='20' viewBox='0 0 10 10'", {14, 24, 12, 12});
        row("width='40'", "viewBox='0 0 10 10'", {8, 8, 24, 24});
        row("height='auto' width='auto'", "height='20' viewBox='0 0 10 10'", {4, 4, 12, 12});
        row("width='10' height='10' transform='translate(5 6) scale(2)'", "viewBox='0 0 10 10'",
            {9, 10, 12, 12});
        row("width='10' height='10' clip-path='inset(5px 0 0 0)'", "viewBox='0 0 10 10'",
            {2, 5, 6, 3});
    }
    void liesInItsBox()
    {
        QFETCH(QByteArray, attributes);
        QFETCH(QByteArray, root);
        QFETCH(QRectF, seen);
        const Document document = read(image(attributes, svg(root, square)));
        QCOMPARE(document.objects().size(), std::size_t(1));
        const QRectF box = boxOf(document);
        QVERIFY2(std::abs(box.left() - seen.left()) < 1e-9
                     && std::abs(box.top() - seen.top()) < 1e-9
                     && std::abs(box.right() - seen.right()) < 1e-9
                     && std::abs(box.bottom() - seen.bottom()) < 1e-9,
                 qPrintable(QString("%1 %2 %3 %4")
                                .arg(box.x())
                                .arg(box.y())
                                .arg(box.width())
                                .arg(box.height())));
    }

    // It inherits nothing but how it is seen.
    void isADrawingOfItsOwn()
    {
        const QByteArray inner = svg("viewBox='0 0 10 10' opacity='0.5'",
                                     "<style>rect{stroke:#0f0}</style><g id='g'>" + square
                                         + "</g><path id='a' "
                                           "d='M0 0H9' stroke='red'/>");
        const Document document =
            read("<style>rect{stroke-width:7}</style><path id='a' d='M0 0H9' stroke='red'/>"
                 "<g fill='blue' stroke='blue' font-size='40'>"
                 + image("id='i' width='20' height='20' opacity='0.5'", inner) + "</g>");
        QCOMPARE(document.objects().size(), std::size_t(3));
        const Style& style = document.objects()[1].style();
        QCOMPARE(style.fill, (Colour{255, 0, 0, 64}));
        QCOMPARE(style.stroke, (Colour{0, 255, 0, 64}));
        QCOMPARE(style.width, 2.0);
        QVERIFY(document.objects()[2].particulars().id.isEmpty()); // another object has it
        const Containers& tree = document.containers();
        const ContainerId group = tree.parentOf(tree.containerOf(1));
        QCOMPARE(tree[group].svgId, "i");
        QCOMPARE(tree.rangeOf(group), (ObjectRange{1, 3}));
        const Document hidden =
            read(image("width='9' height='9' visibility='hidden'", svg("", square)));
        QVERIFY(hidden.objects()[0].hidden());
    }

    void isWrittenAsObjects()
    {
        const Document document = read(image("width='20' height='30'", svg("", square + square)));
        const auto again = readText(textOf(document));
        QVERIFY2(again, qPrintable(again.error));
        QCOMPARE(again.value->report.size(), 0);
        QVERIFY(again.value->document.objects() == document.objects());
    }

    void hasImagesOfItsOwn()
    {
        const QByteArray png = "<image width='4' height='3' xlink:href='data:image/png;base64,"
                               + bytesOf(testImage(4, 3)).toBase64() + "'/>";
        const Document document = read(
            image("x='10' width='40' height='40' preserveAspectRatio='xMinYMin slice'",
                  svg("viewBox='0 0 4 8'",
                      png + "<g inkscape:groupmode='layer' display='none'>" + square + "</g>")));
        const Containers& tree = document.containers();
        QCOMPARE(tree.underlaid().size(), std::size_t(1));
        const Underlay& inner = *tree[tree.underlaid()[0]].underlay;
        QCOMPARE(inner.place({4, 3}), Point(50, 30));
        QVERIFY(tree[tree.underlaid()[0]].locked);
        const Document cut =
            read("<clipPath id='c'><rect width='20' height='9'/></clipPath><g clip-path='url(#c)'>"
                 + image("width='40' height='30'", svg("viewBox='0 0 4 3'", png)) + "</g>");
        const Containers& cutTree = cut.containers();
        QCOMPARE(cutTree.underlaid().size(), std::size_t(1));
        const auto corners = outlineOf(*cutTree[cutTree.underlaid()[0]].underlay);
        QCOMPARE(corners.size(), std::size_t(4));
        QCOMPARE(corners[2], Point(20, 9));
    }

    void itsLossesAreToldAtItsLine()
    {
        const auto result =
            readText(drawing("\n\n" + image("", svg("", "\n\n\n\n<foreignObject/>" + square))));
        QVERIFY(result);
        QCOMPARE(result.value->report.size(), std::size_t(1));
        QCOMPARE(result.value->report[0].what, "foreign object");
        QVERIFY(result.value->report[0].line <= 4);
    }

    void hasNothingFromOtherFiles()
    {
        QTemporaryDir folder;
        const QDir dir(folder.path());
        const auto put = [&](const QString& name, const QByteArray& bytes) {
            QFile file(dir.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
        };
        QVERIFY(put("a.png", bytesOf(testImage(4, 3))));
        QVERIFY(put("itself.svg", svg("viewBox='0 0 10 10'",
                                      square + "<image href='itself.svg' width='9' height='9'/>")));
        QVERIFY(put("inner.svg", svg("viewBox='0 0 10 10'", square + "<image href='a.png'/>")));
        QVERIFY(put("outer.svg", svg("", "<image href='inner.svg' width='9' height='9'/>")));
        QVERIFY(put("inner.svgz", zipped(svg("viewBox='0 0 10 10'", square))));
        QVERIFY(put("zipped.svg", svg("", "<image href='inner.svgz' width='9' height='9'/>")));
        const QString lost = "image that an SVG image takes from another file";
        for (const auto& [name, objects] :
             {std::pair("itself.svg", 2), std::pair("outer.svg", 1)}) {
            const auto result = readFile(dir.filePath(name));
            QVERIFY2(result, qPrintable(result.error));
            QCOMPARE(result.value->document.objects().size(), std::size_t(objects));
            QCOMPARE(result.value->report.size(), std::size_t(1));
            QCOMPARE(result.value->report[0].what, lost);
            QVERIFY(!result.value->document.containers().isUnderlaid());
        }
        const auto zip = readFile(dir.filePath("zipped.svg"));
        QVERIFY(zip && zip.value->report.empty());
        QCOMPARE(zip.value->document.objects().size(), std::size_t(1));
    }

    void whatCannotBeReadIsTold()
    {
        QCOMPARE(reportOf(image("", "<svg xmlns='http://www.w3.org/2000/svg'><g>")),
                 "1 damaged image");
        QCOMPARE(reportOf(image("", "<html xmlns='h'><svg/></html>")), "1 damaged image");
        QByteArray nested = svg("", square);
        for (int i = 0; i < 6; ++i)
            nested = svg("", image("", nested));
        QCOMPARE(reportOf(image("", nested)), "1 SVG image in more than five others");
    }

    // A small file cannot make a huge drawing of it, also not with many images.
    void isBounded()
    {
        QByteArray uses = "<defs><g id='a'>" + square + "</g>";
        for (char c = 'b'; c < 'h'; ++c)
            uses += "<g id='" + QByteArray(1, c) + "'>"
                    + ("<use xlink:href='#" + QByteArray(1, char(c - 1)) + "'/>").repeated(10)
                    + "</g>";
        uses += "</defs><use xlink:href='#g'/>";
        QElapsedTimer time;
        time.start();
        const auto result = readText(drawing(square + image("", svg("", uses)).repeated(100)));
        QVERIFY2(result, qPrintable(result.error));
        QCOMPARE(result.value->document.objects().size(), std::size_t(1));
        QCOMPARE(reportOf(square + image("", svg("", uses)).repeated(3)),
                 "3 SVG images with, or after one with, more than a drawing can have");
        QVERIFY2(time.elapsed() < 60'000, qPrintable(QString::number(time.elapsed())));
    }
};

} // namespace formats_svg_svg_image_test

TEST_CLASS(formats_svg_svg_image_test::SvgImageTest, Gui)
#include "tests/app/formats/svg/svg_image_test.moc"

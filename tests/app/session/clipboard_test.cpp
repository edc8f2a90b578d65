// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/formats/format.h"
#include "app/session/clipboard.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <glm/geometric.hpp>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace session_clipboard_test {

namespace {

// Three objects with numbers that have no short decimals.
app::Document drawing(const app::Page& page)
{
    app::DocumentBuilder builder;
    builder.open({.name = "one"});
    for (int i = 0; i < 3; ++i) {
        const std::vector<app::Subpath> subpaths{
            {{0.1 * i, 1.0 / 3}, {{{5, 5}}, {{7, 1}, {5.5, 2}, {6.5, 8}, true}}, i == 1}};
        app::Object object{app::Path(subpaths), {.stroke = app::Colour{1, 2, 3}, .width = 0.7}};
        object.particulars.id = QStringLiteral("o%1").arg(i);
        builder.add(object);
    }
    builder.close();
    return builder.take(page);
}

} // namespace

class ClipboardTest : public QObject {
    Q_OBJECT

private slots:
    void pasteReturnsTheCopyBitForBit()
    {
        const app::Document document = drawing({});
        const auto data = app::copied(document, {0, 2});
        const app::Objects objects = app::pasted(*data, document.page()).drawing.objects();
        QCOMPARE(objects.size(), std::size_t(2));
        QVERIFY(objects[0].path() == document.objects()[0].path());
        QVERIFY(objects[0].style() == document.objects()[0].style());
        QVERIFY(objects[1].path() == document.objects()[2].path());
        QVERIFY(objects[1].particulars().id.isEmpty()); // the original has it
    }
    void anotherPageKeepsTheSizeOnPaper()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='10cm' "
                     "viewBox='0 0 10 10'>"
                     "<line x1='1' y1='2' x2='3' y2='2' stroke='red' stroke-width='0.5'/></svg>");
        const app::Page millimetres; // 297 mm and as many units
        const app::Objects objects = app::pasted(data, millimetres).drawing.objects();
        QCOMPARE(objects.size(), std::size_t(1));
        QVERIFY(glm::distance(objects[0].singleLine()->a, {10, 20}) < 1e-9);
        QVERIFY(std::abs(objects[0].style().width - 5) < 1e-9);
    }
    void otherProgramsGetPictures()
    {
        // A line of 50.8 mm, 1 mm wide: 600 by about 12 pixels at 300 dpi.
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        builder.add(app::Object{app::Path(clipping::Segment{{10, 20}, {60.8, 20}}),
                                {.stroke = app::Colour{255, 0, 0}, .width = 1}});
        builder.close();
        const auto copy = app::copied(builder.take({}), {0});
        const QImage png = QImage::fromData(copy->data(QStringLiteral("image/png")), "PNG");
        QVERIFY(std::abs(png.width() - 600) <= 1 && std::abs(png.height() - 12) <= 1);
        QCOMPARE(png.pixelColor(300, 6), QColor(255, 0, 0));
        QVERIFY(copy->data(QStringLiteral("application/pdf")).startsWith("%PDF-"));
        const app::Document none = app::pasted(*copy, {}).drawing;
        QCOMPARE(none.objects().size(), std::size_t(1)); // it comes back as lines
    }
    // A picture of a large drawing is no larger than a screen needs.
    void aLargePictureHasALimit()
    {
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        builder.add(app::Object{app::Path(clipping::Segment{{0, 0}, {90000, 10}}),
                                {.stroke = app::Colour{}, .width = 1}});
        builder.close();
        const QImage png = QImage::fromData(
            app::copied(builder.take({}), {0})->data(QStringLiteral("image/png")), "PNG");
        QVERIFY(png.width() > 3900 && png.width() <= 4001);
    }
    // Other programs get pixels, and a group that scales them, because Inkscape ignores the size of
    // the unit. Through them, too, a copy comes back, apart from rounding.
    void otherProgramsGetPixels()
    {
        const app::Document document =
            drawing({{10, 20}, {100, 50}, {100, app::Unit::Mm}, {50, app::Unit::Mm}});
        const auto copy = app::copied(document, {0, 2});
        QCOMPARE(copy->formats().size(), 5);
        const QByteArray svg = copy->data(QStringLiteral("image/svg+xml"));
        QCOMPARE(QString::fromUtf8(svg), copy->text());
        QVERIFY2(svg.contains("width=\"377.9527559055118px\""), svg);
        QVERIFY2(svg.contains("viewBox=\"37.79527559055118 75.59055118110236 377.9527559055118 "
                              "188.9763779527559\""),
                 svg);
        QVERIFY2(svg.contains("<g transform=\"scale(3.779527559055118)\">"), svg);
        QVERIFY(!svg.contains("clearcut:window"));
        QMimeData other;
        other.setData(QStringLiteral("image/svg+xml"), svg);
        const app::Objects objects = app::pasted(other, document.page()).drawing.objects();
        QCOMPARE(objects.size(), std::size_t(2));
        QVERIFY(glm::distance(objects[0].path().subpaths()[0].start,
                              document.objects()[0].path().subpaths()[0].start)
                < 1e-12);
        QVERIFY(std::abs(objects[0].style().width - 0.7) < 1e-12);
    }

    // Whatever the size of a unit, bit for bit, also in another drawing with the same unit.
    void ownCopiesComeBackBitForBit_data()
    {
        QTest::addColumn<app::Page>("page");
        using app::Unit;
        QTest::newRow("millimetres") << app::Page{};
        QTest::newRow("pixels") << app::Page{{0, 0}, {300, 200}, {300, Unit::Px}, {200, Unit::Px}};
        QTest::newRow("inches") << app::Page{{-1, 3}, {7, 7}, {7, Unit::Inch}, {7, Unit::Inch}};
        QTest::newRow("odd") << app::Page{{0, 0}, {0.3, 0.1}, {7, Unit::Cm}, {1, Unit::Pt}};
        QTest::newRow("open") << app::Page{
            {0, 0}, {9, 9}, {100, Unit::Percent}, {100, Unit::Percent}};
    }
    void ownCopiesComeBackBitForBit()
    {
        QFETCH(app::Page, page);
        const app::Document document = drawing(page);
        const auto copy = app::copied(document, {0, 1, 2});
        const app::Document back = app::pasted(*copy, page).drawing;
        QCOMPARE(back.objects().size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(back.objects()[i].path() == document.objects()[i].path());
            QVERIFY(back.objects()[i].style() == document.objects()[i].style());
        }
    }

    // Windows, guides and sheets belong to the drawing, not to a copy.
    void onlyObjectsAreCopied()
    {
        app::Document document = drawing({});
        app::Page page = document.page();
        page.guides.list = {app::Guide{}};
        document.apply(
            {.windows = app::ClipWindows{{{.shape = app::RectangleShape{{{0, 0}, {1, 1}}}}}},
             .page = page});
        const auto copy = app::copied(document, {0, 1});
        for (const QString& format : copy->formats())
            QVERIFY(!copy->data(format).contains("clearcut:window")
                    && !copy->data(format).contains("clearcut:guide"));
    }

    // By Inkscape itself: what is pasted in place there has its size and place on paper.
    void inkscapePastesTheRightSize()
    {
        for (const char* program : {"inkscape", "xvfb-run", "dbus-run-session", "gdbus", "xclip"})
            if (QStandardPaths::findExecutable(QString::fromLatin1(program)).isEmpty())
                QSKIP("needs inkscape, xvfb-run, dbus-run-session, gdbus and xclip");
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        builder.add({app::Path(clipping::Segment{{10, 10}, {172, 10}}), {.stroke = app::Colour{}}});
        builder.close();
        const auto copy = app::copied(builder.take({}), {0, 1});
        const QTemporaryDir folder;
        const auto write = [&](const QString& name, const QByteArray& text) {
            QFile file(folder.filePath(name));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        QVERIFY(write("copy.svg", copy->data(QStringLiteral("image/svg+xml"))));
        QVERIFY(write("page.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='210mm' "
                                  "height='297mm' viewBox='0 0 210 297'/>"));
        QProcess paste;
        paste.setWorkingDirectory(folder.path());
        paste.start(QStringLiteral("xvfb-run"),
                    {"-a", "dbus-run-session", "bash",
                     SOURCE_DIR "/tests/app/session/paste_in_inkscape.sh", "copy.svg", "page.svg"});
        QVERIFY(paste.waitForFinished(120'000));
        QVERIFY2(paste.exitCode() == 0, paste.readAllStandardError());
        QFile file(folder.filePath("page.svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray text = file.readAll();
        QBuffer buffer(&text);
        buffer.open(QIODevice::ReadOnly);
        const auto read = app::formats().front().read(buffer);
        QVERIFY2(read, qPrintable(read.error));
        const app::Document& page = read.value->document;
        QCOMPARE(page.objects().size(), std::size_t(1));
        const auto line = page.objects()[0].singleLine();
        const double length = glm::distance(line->a, line->b) * page.page().millimetresPerUnit();
        QVERIFY2(std::abs(length - 162) < 0.01, qPrintable(QString::number(length)));
    }

    void aFileOfEachFormatIsCopied()
    {
        for (const app::Format& format : app::formats()) {
            if (!format.write)
                continue;
            const auto data = app::copiedFile(format.key, "content");
            QVERIFY2(!data->formats().isEmpty(), format.key.data());
            QCOMPARE(data->data(data->formats().front()), QByteArray("content"));
        }
    }
    // The image of a layer is copied with it as a whole; nothing selects an image.
    void imagesAreCopiedWithTheirLayers_data()
    {
        QTest::addColumn<app::ObjectRanges>("objects");
        QTest::addColumn<QStringList>("images"); // the layers that have them
        QTest::newRow("a layer") << app::ObjectRanges{0, 1} << QStringList("own");
        QTest::newRow("half of it") << app::ObjectRanges{0} << QStringList();
        QTest::newRow("without images") << app::ObjectRanges{2} << QStringList();
        QTest::newRow("all") << app::ObjectRanges{0, 1, 2} << QStringList({"photo", "own"});
    }
    void imagesAreCopiedWithTheirLayers()
    {
        QFETCH(app::ObjectRanges, objects);
        QFETCH(QStringList, images);
        app::DocumentBuilder builder;
        builder.open({.name = "photo", .locked = true, .underlay = testUnderlay({1, 2}, 0.3)});
        builder.close();
        builder.open({.name = "own", .underlay = testUnderlay({3, 4})});
        for (const double x : {0.1, 0.2})
            builder.add({app::Path(clipping::Segment{{x, 0}, {x, 9}}), {.stroke = app::Colour{}}});
        builder.close();
        builder.open({.name = "lines"});
        builder.add({app::Path(clipping::Segment{{0, 0}, {5, 9}}), {.stroke = app::Colour{}}});
        builder.open({.name = "hidden", .visible = false, .underlay = testUnderlay({5, 6})});
        builder.close();
        builder.close();
        const app::Document document = builder.take({});
        const auto copy = app::copied(document, objects);
        const app::Document back = app::pasted(*copy, {}).drawing;
        const app::Containers& tree = back.containers();
        QStringList names;
        for (const app::ContainerId id : tree.underlaid()) {
            names << tree[id].name;
            const app::ContainerId own = document.containers().underlaid()[names.last() == u"own"];
            QVERIFY(tree[id].underlay == document.containers()[own].underlay);
        }
        QCOMPARE(names, images);
        QCOMPARE(copy->text().count("<image"), images.size());
    }
    void anotherPagesImagesKeepTheirSizeOnPaper()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='10cm' "
                     "viewBox='0 0 10 10'><clipPath id='c'><path d='M1 2H3V9H1Z'/></clipPath>"
                     "<image x='1' y='2' width='4' height='3' clip-path='url(#c)' "
                     "href='data:image/png;base64,"
                     + bytesOf(testImage(4, 3)).toBase64() + "'/></svg>");
        const app::Pasted pasted = app::pasted(data, {}); // 297 mm and as many units
        QVERIFY(pasted.holdsDrawing());
        const app::Containers& tree = pasted.drawing.containers();
        const app::Underlay& image = *tree[tree.underlaid().at(0)].underlay;
        QVERIFY(glm::distance(image.place({0, 0}), {10, 20}) < 1e-9);
        QVERIFY(glm::distance(image.place({4, 3}), {50, 50}) < 1e-9);
        QVERIFY(glm::distance(image.clip.at(2), {30, 50}) < 1e-9);
    }
    void whatCannotBeKeptIsSaid()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg'><image href='photo.png'/></svg>");
        const app::Pasted none = app::pasted(data, {});
        QVERIFY(!none.holdsDrawing());
        QCOMPARE(none.losses.at(0).what,
                 "image that is neither in the file nor in its folder or below");
        data.setData(QStringLiteral("image/svg+xml"),
                     "<svg xmlns='http://www.w3.org/2000/svg'><g>");
        QVERIFY(!app::pasted(data, {}).fault.isEmpty());
    }

    void otherClipboardContentsAreIgnored()
    {
        QMimeData data;
        data.setText("hello <svg but not really");
        QVERIFY(app::pasted(data, {}).drawing.objects().empty());
        data.setText("hello");
        QVERIFY(app::pasted(data, {}).drawing.objects().empty());
    }
};

} // namespace session_clipboard_test

TEST_CLASS(session_clipboard_test::ClipboardTest, Core)
#include "tests/app/session/clipboard_test.moc"

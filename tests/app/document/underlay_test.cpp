// SPDX-License-Identifier: GPL-3.0-or-later
// Images below layers: values, kept by the tree of layers.
#include "app/document/document.h"
#include "app/document/document_builder.h"

#include <QTest>

#include <algorithm>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace document_underlay_test {

using namespace app;

namespace {

/// A layer with a line; above it one with an image and a line.
Document twoLayers()
{
    DocumentBuilder builder;
    for (const bool hasImage : {false, true}) {
        Container layer{.name = hasImage ? "upper" : "lower"};
        if (hasImage)
            layer.underlay = testUnderlay();
        builder.open(layer);
        builder.addLine({{0, 0}, {1, 1}}, builder.style({}));
        builder.close();
    }
    return builder.take({});
}

Edit without(const Document& document, ContainerId layer)
{
    Edit edit;
    const ObjectRange range = document.containers().rangeOf(layer);
    edit.splices = {{std::uint32_t(range.first), std::uint32_t(range.size()), 0}};
    edit.containers = document.containers().removed(layer);
    return edit;
}

} // namespace

class UnderlayTest : public QObject {
    Q_OBJECT

private slots:
    void knowsKinds_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("fault"); // -1: none
        const QByteArray png = bytesOf(testImage(5, 4)), jpeg = bytesOf(testImage(5, 4), "jpeg");
        QByteArray huge = png; // the head says 100,000 by 100,000
        huge.replace(16, 17, QByteArray::fromHex("000186a0000186a0080200000027309c9f"));
        QTest::newRow("png") << png << -1;
        QTest::newRow("jpeg") << jpeg << -1;
        QByteArray gif = testGif();
        gif.replace(6, 4,
                    QByteArray::fromHex("05000400")); // the picture is smaller than its screen
        QTest::newRow("gif") << gif << -1;
        const qsizetype next = gif.lastIndexOf("!"); // of the second picture
        QTest::newRow("its first picture") << gif.first(next) << -1;
        for (const qsizetype size : {next - 1, next / 2, qsizetype(30), qsizetype(20)})
            QTest::addRow("%d bytes of gif", int(size))
                << gif.first(size) << int(ImageFault::Damaged);
        QTest::newRow("a head of gif") << QByteArray("GIF89a") << int(ImageFault::Damaged);
        const QByteArray big = QByteArray::fromHex("ffffffff");
        gif.replace(6, 4, big).replace(gif.indexOf(QByteArray::fromHex("2c00000000")) + 5, 4, big);
        QTest::newRow("huge gif") << gif << int(ImageFault::TooLarge);
        QTest::newRow("webp") << QByteArray("RIFF\x1a\0\0\0WEBPVP8L", 16)
                              << int(ImageFault::OtherKind);
        QTest::newRow("nothing") << QByteArray() << int(ImageFault::OtherKind);
        QTest::newRow("a head alone") << png.first(12) << int(ImageFault::Damaged);
        QTest::newRow("huge") << huge << int(ImageFault::TooLarge);
        QTest::newRow("many bytes")
            << png + QByteArray(ImageFile::mostBytes, 'x') << int(ImageFault::TooLarge);
    }
    void knowsKinds()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(int, fault);
        const auto made = imageFileOf(bytes);
        const auto* const file = std::get_if<std::shared_ptr<const ImageFile>>(&made);
        QCOMPARE(file ? -1 : int(std::get<ImageFault>(made)), fault);
        if (file) {
            QCOMPARE((*file)->width, 5);
            QCOMPARE((*file)->height, 4);
            QCOMPARE((*file)->bytes, bytes);
        }
    }

    void isCutAtConvexAreas()
    {
        const std::vector<Point> square = cornersOfBox({{0, 0}, {4, 4}});
        QCOMPARE(commonArea(square, square), square);
        QCOMPARE(commonArea(square, cornersOfBox({{1, -1}, {9, 9}})),
                 (std::vector<Point>{{1, 0}, {4, 0}, {4, 4}, {1, 4}}));
        std::vector<Point> reversed = cornersOfBox({{1, 1}, {2, 2}});
        std::ranges::reverse(reversed);
        QCOMPARE(commonArea(square, reversed).size(), 4);
        QVERIFY(commonArea(square, cornersOfBox({{4, 0}, {9, 9}})).empty()); // an edge alone
        Underlay image = testUnderlay();
        QVERIFY(cut(image, cornersOfBox({{-1, -1}, {9, 9}})));
        QVERIFY(image.clip.empty());
        QVERIFY(cut(image, cornersOfBox({{1, 1}, {9, 9}})));
        const std::vector<Point> left{{1, 1}, {4, 1}, {4, 3}, {1, 3}};
        QVERIFY(std::ranges::is_permutation(image.clip, left));
        QVERIFY(!cut(image, cornersOfBox({{7, 7}, {9, 9}})));
    }

    void comesAndGoesWithItsLayer()
    {
        Document document = twoLayers();
        const ContainerId upper = document.containers().childrenOf(0)[1];
        QCOMPARE(seenUnderlays(document).size(), 1);
        QCOMPARE(seenUnderlays(document)[0].below, 1);
        const Document before = document;
        const Edit removal = without(document, upper);
        const Edit back = document.apply(removal);
        QVERIFY(!document.containers().isUnderlaid());
        QVERIFY(seenUnderlays(document).empty());
        document.apply(back);
        QVERIFY(document == before);
        QCOMPARE(seenUnderlays(document).size(), 1);

        Container hidden = document.containers()[upper];
        hidden.visible = false;
        document.apply({.containers = document.containers().with(hidden)});
        QVERIFY(seenUnderlays(document).empty());
        QCOMPARE(document.containers().underlaid(), std::vector{upper});
    }

    void isComparedByWhatItHolds()
    {
        Underlay other = testUnderlay();
        QVERIFY(SharedUnderlay(testUnderlay()) == SharedUnderlay(other)); // of two equal files
        other.opacity = 0.5;
        QVERIFY(SharedUnderlay(testUnderlay()) != SharedUnderlay(other));
        QVERIFY(SharedUnderlay() != SharedUnderlay(other));
        QVERIFY(!(twoLayers() == Document()));
    }

    // What undo keeps alive alone is counted: the file of a removed image, not that of a renamed
    // layer.
    void undoCountsItsBytes()
    {
        Document document = twoLayers();
        const ContainerId upper = document.containers().childrenOf(0)[1];
        const auto bytes = std::size_t(document.containers()[upper].underlay->file->bytes.size());
        Container renamed = document.containers()[upper];
        renamed.name = "other";
        const Edit rename{.containers = document.containers().with(renamed)};
        const Edit back = document.apply(rename);
        const std::size_t ofName = back.bytesNotIn(rename);
        const Edit removal = without(document, upper);
        QVERIFY(document.apply(removal).bytesNotIn(removal) >= bytes);
        Document plain = twoLayers();
        Container bare = plain.containers()[upper];
        bare.underlay = {};
        const Edit loss{.containers = plain.containers().with(bare)};
        QVERIFY(plain.apply(loss).bytesNotIn(loss) >= ofName + bytes);
    }

    void belongsToLayersAlone()
    {
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        builder.open({.kind = Container::Kind::Group});
        builder.addLine({{0, 0}, {1, 1}}, builder.style({}));
        builder.close();
        builder.close();
        Containers::Parts parts = builder.take({}).containers().parts();
        QVERIFY(Containers::of(parts));
        parts.containers[0].underlay = testUnderlay();
        QVERIFY(Containers::of(parts));
        parts.containers[1].underlay = testUnderlay();
        QVERIFY(!Containers::of(parts));
    }
};

} // namespace document_underlay_test

TEST_CLASS(document_underlay_test::UnderlayTest, Core)
#include "tests/app/document/underlay_test.moc"

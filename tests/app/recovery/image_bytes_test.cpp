// SPDX-License-Identifier: GPL-3.0-or-later
// The journal writes an image file once, and restores it.
#include "app/commands/set_containers.h"
#include "app/document/document_builder.h"
#include "app/recovery/change_bytes.h"
#include "app/recovery/document_bytes.h"

#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace recovery_image_bytes_test {

using namespace app;

namespace {

/// Two layers with the same image.
Document drawing()
{
    Underlay image = testUnderlay({1, 2}, 3);
    image.file = testFile(300, 200);
    image.clip = cornersOfBox({{2, 3}, {4, 5}});
    image.opacity = 0.5;
    image.svgId = "i";
    DocumentBuilder builder;
    for (const char* name : {"a", "b"}) {
        builder.open({.name = name, .underlay = image});
        builder.addLine({{0, 0}, {1, 1}}, builder.style({}));
        builder.close();
    }
    return builder.take({});
}

/// How many PNG files there are among the bytes.
qsizetype filesIn(const std::string& bytes)
{
    return QByteArray::fromStdString(bytes).count("\x89PNG");
}

/// The bytes of a step, which is pushed, and read again by a copy of the drawing before.
std::string recorded(EditedDocument& document, Containers containers)
{
    Document before = document.now();
    SetContainers command(document, std::move(containers), "step");
    command.redo();
    ByteWriter out;
    writeChange(out, command, document.now());
    ByteReader in(out.bytes());
    const auto change = readChange(in, before);
    if (!change)
        return {};
    before.apply(change->edit);
    return before == document.now() ? out.bytes() : std::string();
}

} // namespace

class ImageBytesTest : public QObject {
    Q_OBJECT

private slots:
    void aBaseHoldsAFileOnce()
    {
        const Document document = drawing();
        ByteWriter out;
        ObjectBytes objects;
        writeDocument(out, document, objects);
        QCOMPARE(filesIn(out.bytes()), 1);
        ByteReader in(out.bytes());
        ObjectReader reader;
        const auto again = readDocument(in, reader);
        QVERIFY(again && *again == document);
    }

    void aStepHoldsOnlyANewFile()
    {
        EditedDocument document(drawing());
        const Containers tree = document.now().containers();
        Container layer = tree[tree.underlaid()[1]];
        layer.name = "renamed";
        const std::string renaming = recorded(document, tree.with(layer));
        QVERIFY(!renaming.empty());
        QCOMPARE(filesIn(renaming), 0);
        layer.underlay = {};
        const std::string removal = recorded(document, document.now().containers().with(layer));
        QVERIFY(!removal.empty());
        QCOMPARE(filesIn(removal), 0);
        Underlay other = testUnderlay();
        other.file = testFile(310, 200);
        layer.underlay = other;
        const std::string placing = recorded(document, document.now().containers().with(layer));
        QCOMPARE(filesIn(placing), 1);
    }

    void damagedBytesAreRefused()
    {
        ByteWriter out;
        KnownImages known;
        writeUnderlay(out, SharedUnderlay(testUnderlay()), known);
        const std::string whole = out.bytes();
        for (std::size_t size = 0; size < whole.size(); ++size) {
            KnownImages none;
            ByteReader in(std::string_view(whole).substr(0, size));
            QVERIFY(!readUnderlay(in, none));
            QVERIFY(!in.ok());
        }
    }
};

} // namespace recovery_image_bytes_test

TEST_CLASS(recovery_image_bytes_test::ImageBytesTest, Core)
#include "tests/app/recovery/image_bytes_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Images that are dropped and pasted lie below the drawing, as one step each.
#include "app/session/copy_selection.h"
#include "app/session/image_steps.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace session_image_steps_test {

using namespace app;

namespace {

Document onPage()
{
    Page page;
    page.min = {10, 20};
    page.size = {100, 200};
    return newDrawing(page);
}

struct Stage {
    Stage() { session.load({onPage(), {}}); }
    const Containers& tree() const { return session.now().containers(); }
    QString put(const QString& name, const QByteArray& bytes) const
    {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size()
                   ? file.fileName()
                   : QString();
    }

    QTemporaryDir folder;
    Session session;
    ImagePlacing placing{session};
};

} // namespace

class ImageStepsTest : public QObject {
    Q_OBJECT

private slots:
    void liesBelowAllElseOnThePage()
    {
        Stage stage;
        placeImage(stage.session, testFile(40, 30), "photo");
        const ContainerId layer = stage.tree().childrenOf(0).front();
        QCOMPARE(stage.tree().underlaid(), std::vector{layer});
        QCOMPARE(stage.tree()[layer].name, "photo");
        QVERIFY(stage.tree()[layer].locked);
        const auto corners = outlineOf(*stage.tree()[layer].underlay);
        QCOMPARE(corners[0], Point(10, 82.5)); // as wide as the page, in its middle
        QCOMPARE(corners[2], Point(110, 157.5));
        QCOMPARE(stage.session.history.count(), 1);
        removeImage(stage.session, layer);
        QVERIFY(!stage.tree().isUnderlaid());
        QVERIFY(stage.tree().contains(layer));
        stage.session.history.undo();
        stage.session.history.undo();
        QVERIFY(stage.session.now() == onPage());
    }

    void filesAreReadOneAfterTheOther()
    {
        Stage stage;
        QSignalSpy refused(&stage.session, &Session::refused);
        stage.placing.place(stage.put("first.png", bytesOf(testImage(5, 5))));
        stage.placing.place(stage.put("bad.png", bytesOf(testImage(50, 50)).first(60)));
        stage.placing.place(stage.put("text.png", "no image"));
        stage.placing.place(stage.folder.filePath("missing.jpg"));
        stage.placing.place(stage.put("last.jpg", bytesOf(testImage(5, 5), "jpeg")));
        QTRY_COMPARE(stage.session.history.count(), 2);
        QCOMPARE(refused.count(), 3);
        QCOMPARE(refused[0][0].toString(), "The image was not placed: it is damaged.");
        QCOMPARE(refused[1][0].toString(),
                 "The image was not placed: it is neither PNG, JPEG nor GIF, or cannot be read.");
        QCOMPARE(stage.tree()[stage.tree().childrenOf(0)[0]].name, "last");
        QCOMPARE(stage.tree()[stage.tree().childrenOf(0)[1]].name, "first");
    }

    void anotherProgramsImageIsTaken()
    {
        Stage stage;
        QMimeData none, picture, file;
        none.setText("text");
        picture.setImageData(testImage(5, 5));
        file.setData("image/png", bytesOf(testImage(6, 6)));
        QVERIFY(!offersImage(none) && offersImage(picture) && offersImage(file));
        stage.placing.place(picture);
        stage.placing.place(file);
        QTRY_COMPARE(stage.session.history.count(), 2);
        QCOMPARE(stage.tree()[stage.tree().childrenOf(0)[0]].underlay->file->width, 6);
        QCOMPARE(stage.tree()[stage.tree().childrenOf(0)[1]].underlay->file->width, 5);
    }

    // What was meant for one drawing does not come into another.
    void anotherDrawingGetsNone()
    {
        Stage stage;
        stage.placing.place(stage.put("first.png", bytesOf(testImage(900, 900))));
        stage.session.load({onPage(), {}});
        stage.placing.place(stage.put("last.png", bytesOf(testImage(5, 5))));
        QTRY_COMPARE(stage.session.history.count(), 1);
        QCOMPARE(stage.tree()[stage.tree().underlaid()[0]].name, "last");
        QCOMPARE(stage.tree().underlaid().size(), std::size_t(1));
    }

    // Else they would be lost when the file is opened again.
    void theLimitOfImagesIsTold()
    {
        Stage stage;
        const auto file = testFile(40, 30);
        Containers tree = stage.tree();
        for (int i = 0; i < 499; ++i)
            tree = *tree.inserted({.name = "i", .underlay = Underlay{.file = file}}, 0, 0, {0, 0});
        stage.session.document.apply({.containers = tree});
        QSignalSpy refused(&stage.session, &Session::refused);
        placeImage(stage.session, file, "last");
        QCOMPARE(stage.tree().underlaid().size(), std::size_t(500));
        placeImage(stage.session, file, "too many");
        QCOMPARE(stage.tree().underlaid().size(), std::size_t(500));
        QCOMPARE(
            refused.value(0).value(0).toString(),
            "No image was placed. A file can hold 500 images with 200 million pixels and 256 MB "
            "in all. Remove an image first.");
        paste(stage.session, stage.session.now(), PastePlace::InPlace);
        QCOMPARE(refused.count(), 2);
    }
    void theLimitOfPixelsIsTold()
    {
        Stage stage;
        const auto large = [] {
            return std::make_shared<const ImageFile>(
                ImageFile{.bytes = "x", .width = 10'000, .height = 9'000});
        };
        const auto first = large();
        for (const auto& file : {first, large(), first})
            placeImage(stage.session, file, "i");
        QCOMPARE(stage.session.history.count(), 3);
        QSignalSpy refused(&stage.session, &Session::refused);
        placeImage(stage.session, large(), "i");
        QCOMPARE(refused.count(), 1);
    }

    void theLimitOfLayersIsTold()
    {
        Stage stage;
        Containers tree = stage.tree();
        while (tree.size() < Containers::mostLayers)
            tree = *tree.inserted({.name = "layer"}, 0, 0, {0, 0});
        stage.session.document.apply({.containers = tree});
        QSignalSpy refused(&stage.session, &Session::refused);
        placeImage(stage.session, testFile(), {});
        QCOMPARE(refused.count(), 1);
        QCOMPARE(stage.session.history.count(), 0);
    }
};

} // namespace session_image_steps_test

TEST_CLASS(session_image_steps_test::ImageStepsTest, Gui)
#include "tests/app/session/image_steps_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"
#include "app/scene/bounds.h"
#include "app/session/clipboard.h"
#include "app/session/copy_selection.h"

#include <QBuffer>
#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/app/document/test_image.h"
#include "tests/test_class.h"

namespace session_copy_selection_test {

using namespace app;

// Documents that never had an object have no styles either.
class CopySelectionTest : public QObject {
    Q_OBJECT

    static Document fileWithoutShapes()
    {
        QBuffer file;
        file.setData("<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'/>");
        file.open(QIODevice::ReadOnly);
        return formats().front().read(file).value->document;
    }
    static Document windowsAlone()
    {
        Document document;
        document.apply({.windows = ClipWindows{{{.name = "A"}, {.name = "B"}}, Keep::Inside}});
        return document;
    }
    /// Lines in so many styles, in turn.
    static Document lines(int count, int styles)
    {
        DocumentBuilder builder;
        builder.open({.name = "Lines"});
        for (int i = 0; i < count; ++i)
            builder.add(Object{Path(clipping::Segment{{double(i), 0}, {double(i), 5}}),
                               {.stroke = Colour{}, .width = 0.1 * (1 + i % styles)}});
        builder.close();
        return builder.take({});
    }

private slots:
    void copiesArriveInADrawingWithoutObjects_data()
    {
        QTest::addColumn<Document>("into");
        QTest::newRow("a new drawing") << newDrawing();
        QTest::newRow("the usual document") << Document();
        QTest::newRow("a file without shapes") << fileWithoutShapes();
        QTest::newRow("clip windows alone") << windowsAlone();
    }
    void copiesArriveInADrawingWithoutObjects()
    {
        QFETCH(Document, into);
        for (const int count : {1, 10, 64, 65, 70, 300})
            for (const int styles : {1, 7}) {
                Session session;
                session.load({into, {}});
                const Document from = lines(count, styles);
                const auto data = copied(from, ObjectRanges(ObjectRange{0, std::size_t(count)}));
                const Document drawing = pasted(*data, from.page()).drawing;
                paste(session, drawing, PastePlace::InPlace);
                QVERIFY(session.now().objects() == drawing.objects());
                QVERIFY(session.now().objects() == from.objects());
                QCOMPARE(session.selection().size(), std::size_t(count));
                paste(session, drawing, PastePlace::Offset);
                duplicateInPlace(session);
                QCOMPARE(session.now().objects().size(), std::size_t(3 * count));
                for (std::size_t i = 0; i < session.now().objects().size(); ++i)
                    QVERIFY(session.now().objects()[i].style()
                            == from.objects()[i % std::size_t(count)].style());
                session.history.setIndex(0);
                QVERIFY(session.now() == into);
                session.history.redo();
                QVERIFY(session.now().objects() == from.objects());
            }
    }
    void whatWouldLieOutOfSightComesIntoIt()
    {
        const Document far = lines(3, 1); // 2 × 5, at the origin
        const auto placed = [&](const std::optional<clipping::Window>& seen, PastePlace place) {
            Session session;
            session.load({newDrawing(), {}});
            paste(session, far, place, seen);
            return *boundsOf(session.scene.lines());
        };
        const clipping::Window away{{1000, 2000}, {1100, 2100}};
        const auto shown = placed(away, PastePlace::Offset);
        QCOMPARE((shown.min + shown.max) * 0.5, Point(1050, 2050));
        for (const auto& [seen, place] :
             {std::pair(std::optional(away), PastePlace::InPlace),
              std::pair(std::optional<clipping::Window>(), PastePlace::Offset),
              std::pair(std::optional(clipping::Window{{0, 0}, {50, 50}}), PastePlace::Offset)})
            QVERIFY(placed(seen, place).max.x < 20);
    }
    // An image that is copied with all of a drawing.
    static Document onImage()
    {
        DocumentBuilder builder;
        builder.open({.name = "photo", .locked = true, .underlay = testUnderlay({1, 2})});
        builder.close();
        builder.open({.name = "lines"});
        builder.add({Path(clipping::Segment{{0, 0}, {5, 9}}), {.stroke = Colour{}}});
        builder.close();
        return builder.take({});
    }
    void imagesComeOnLayersOfTheirOwn()
    {
        Session session;
        session.load({lines(2, 1), {}});
        const Document before = session.now();
        const auto data = copied(onImage(), {0});
        const Document drawing = pasted(*data, before.page()).drawing;
        paste(session, drawing, PastePlace::Offset);
        const Containers& tree = session.now().containers();
        QCOMPARE(tree.underlaid().size(), std::size_t(1));
        const ContainerId image = tree.underlaid().front();
        QCOMPARE(tree.parentOf(image), session.pen.layer);
        QCOMPARE(tree.rangeOf(image), (ObjectRange{2, 2})); // above those before, below the copy
        QCOMPARE(tree[image].name, "photo");
        QVERIFY(tree[image].locked);
        QCOMPARE(tree[image].underlay->place.to, Point(6, 7)); // 5 mm on, as the line
        QCOMPARE(session.now().objects()[2].singleLine()->a, Point(5, 5));
        QCOMPARE(session.history.count(), 1);
        session.history.undo();
        QVERIFY(session.now() == before);
        session.history.redo();
        paste(session, drawing, PastePlace::InPlace);
        QCOMPARE(session.now().containers().underlaid().size(), std::size_t(2));
        paste(session, drawing, PastePlace::InPlace); // that image is there already
        QCOMPARE(session.now().containers().underlaid().size(), std::size_t(2));
        QCOMPARE(session.now().objects().size(), std::size_t(5));
    }
    void imagesLieBelowTheGroupThatIsEntered()
    {
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        builder.open({.kind = Container::Kind::Group});
        const ContainerId group = builder.open({.kind = Container::Kind::Group});
        builder.add({Path(clipping::Segment{{0, 0}, {5, 9}}), {.stroke = Colour{}}});
        for (int i = 0; i < 3; ++i)
            builder.close();
        Session session;
        session.load({builder.take({}), {}});
        session.entered.enter(group);
        paste(session, onImage(), PastePlace::InPlace);
        const Containers& tree = session.now().containers();
        QCOMPARE(tree.rangeOf(group), (ObjectRange{0, 2}));
        QCOMPARE(tree.underlaid().size(), std::size_t(1));
        QCOMPARE(tree.inOrder()[1], tree.underlaid()[0]);
        QCOMPARE(tree.parentOf(tree.underlaid()[0]), tree.childrenOf(0)[0]);
    }
    void imagesAloneAreOneStep()
    {
        Session session;
        session.load({lines(2, 1), {}});
        const Document before = session.now();
        Document image = onImage();
        image.apply({.splices = {{0, 1, 0}}, .containers = image.containers().spliced(0, 1, 0, 0)});
        paste(session, image, PastePlace::InPlace);
        paste(session, image, PastePlace::InPlace);
        QCOMPARE(session.now().containers().underlaid().size(), std::size_t(2));
        QCOMPARE(session.history.count(), 2);
        session.history.setIndex(0);
        QVERIFY(session.now() == before);
    }
    void theLimitOfLayersIsTold()
    {
        Session session;
        session.load({newDrawing(), {}});
        Containers tree = session.now().containers();
        while (tree.size() < Containers::mostLayers)
            tree = *tree.inserted({.name = "layer"}, 0, 0, {0, 0});
        session.document.apply({.containers = tree});
        QSignalSpy refused(&session, &Session::refused);
        paste(session, onImage(), PastePlace::InPlace);
        QCOMPARE(refused.count(), 1);
        QVERIFY(session.now().objects().empty());
    }
    void anotherProgramsDrawingArrives()
    {
        QMimeData data;
        data.setText("<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='50mm' "
                     "viewBox='0 0 50 50'><g stroke='red'><path d='M1 1h5'/><g><path d='M1 2h5' "
                     "stroke='blue'/><path d='M1 3h5'/></g></g></svg>");
        Session session;
        session.load({Document(), {}});
        paste(session, pasted(data, session.now().page()).drawing, PastePlace::InPlace);
        const Objects& objects = session.now().objects();
        QCOMPARE(objects.size(), std::size_t(3));
        QVERIFY((objects[0].style().stroke == Colour{255, 0, 0}));
        QVERIFY((objects[1].style().stroke == Colour{0, 0, 255}));
        QVERIFY((objects[2].style().stroke == Colour{255, 0, 0}));
    }
};

} // namespace session_copy_selection_test

TEST_CLASS(session_copy_selection_test::CopySelectionTest, Core)
#include "tests/app/session/copy_selection_test.moc"

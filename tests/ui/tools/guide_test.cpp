// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/guide_drag.h"

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_guide_test {

// Guides, dragged from the rulers and on the page.
class GuideTest : public QObject {
    Q_OBJECT

    struct Page : Hand {
        Page() : Hand({shape({corner()})}) { canvas.setTool("select"); }

        /// From a ruler to a place of the drawing.
        void pull(int axis, app::Point to, Qt::KeyboardModifiers modifiers = {})
        {
            auto* ruler = t.window->findChild<QWidget*>(axis == 0 ? "leftRuler" : "topRuler");
            QTest::mousePress(ruler, Qt::LeftButton, {}, ruler->rect().center());
            const QPoint end = ruler->mapFromGlobal(surface().mapToGlobal(at(to)));
            QMouseEvent event(QEvent::MouseMove, end, ruler->mapToGlobal(end), Qt::NoButton,
                              Qt::LeftButton, modifiers);
            QApplication::sendEvent(ruler, &event);
            QTest::mouseRelease(ruler, Qt::LeftButton, modifiers, end);
        }
        std::vector<app::Guide> guides() const { return session.now().page().guides.list; }
        app::Point beside() { return canvas.view().toDrawing({-30, -30}); }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aDragFromARulerAddsAGuideInOneStep()
    {
        Page page;
        page.canvas.setTool("line"); // with any tool
        page.pull(0, {50, 40});
        page.pull(1, {50, 40});
        QCOMPARE(page.guides().size(), std::size_t(2));
        QCOMPARE(page.guides()[0].axis, 0);
        QVERIFY(page.isNear({page.guides()[0].at, 0}, {50, 0}));
        QCOMPARE(page.guides()[1].axis, 1);
        QVERIFY(page.isNear({0, page.guides()[1].at}, {0, 40}));
        QCOMPARE(page.session.history.count(), 2);
        QCOMPARE(page.canvas.tool(), std::string_view("line"));
        page.canvas.undo();
        QCOMPARE(page.guides().size(), std::size_t(1));
    }
    void aGuideSnapsToTheDrawingUnlessCtrlIsHeld()
    {
        Page page;
        page.canvas.setSnapping(app::SnapTo::All);
        page.pull(0, {100.5, 20.4}); // near the corner at 100, 20
        QCOMPARE(page.guides()[0].at, 100.0);
        page.pull(0, {140.5, 20.4}, Qt::ControlModifier);
        QVERIFY(page.isNear({page.guides()[1].at, 0}, {140.5, 0}));
    }
    void aNewGuideTakesATypedPosition()
    {
        Page page;
        page.pull(1, {50, 40});
        Page::type("12+30.5\n");
        QCOMPARE(page.guides()[0].at, 42.5);
        QVERIFY(page.canvas.toolHint().contains("y 42.50"));
        Page::type("1\n"); // again, as long as it is chosen
        QCOMPARE(page.guides()[0].at, 1.0);
    }
    void everyNewGuideTakesItsOwnPosition()
    {
        Page page;
        page.pull(0, {50, 40});
        Page::type("120\n");
        page.pull(0, {60, 40});
        Page::type("130\n");
        page.pull(1, {60, 40});
        Page::type("24\n");
        page.pull(1, {60, 50});
        Page::type("28.5\n");
        QCOMPARE(page.guides(), (std::vector<app::Guide>{{0, 120}, {0, 130}, {1, 24}, {1, 28.5}}));
    }
    void aGuideIsDraggedClickedAndDeleted()
    {
        Page page;
        page.pull(0, {50, 40});
        Page::type("50\n");
        page.click({150, 70}); // nothing is chosen any more
        QVERIFY(!page.session.guide);
        page.drag({50, 70}, {70, 60});
        QVERIFY(page.isNear({page.guides()[0].at, 0}, {70, 0}));
        page.click({150, 70});
        page.click({page.guides()[0].at, 90});
        QCOMPARE(page.session.guide, std::optional<std::size_t>(0));
        Page::key(Qt::Key_Delete);
        QVERIFY(page.guides().empty());
        QCOMPARE(page.session.now().objects().size(), std::size_t(1));
        page.canvas.undo();
        QCOMPARE(page.guides().size(), std::size_t(1));
    }
    void aGuideDroppedBesideTheDrawingIsRemoved()
    {
        Page page;
        page.pull(0, page.beside()); // was never there
        QVERIFY(page.guides().empty());
        QCOMPARE(page.session.history.count(), 0);
        page.pull(0, {50, 40});
        page.drag({page.guides()[0].at, 70}, page.beside());
        QVERIFY(page.guides().empty());
    }
    void aChosenGuideLeavesOtherGesturesAlone()
    {
        Page page;
        page.session.select({0});
        page.pull(0, {50, 40}); // is chosen now, and the object stays selected
        Page::type("50\n");
        Page::key(Qt::Key_O); // rotates
        Page::type("90\n");
        QCOMPARE(page.guides()[0].at, 50.0);
        QCOMPARE(page.session.history.count(), 3);
        QVERIFY(page.path().start != corner().start);
    }
    void deleteMeansTheChosenGuide()
    {
        Page page;
        page.session.select({0});
        page.pull(0, {50, 40});
        Page::key(Qt::Key_Delete);
        QVERIFY(page.guides().empty());
        QCOMPARE(page.session.now().objects().size(), std::size_t(1));
    }
    void selectingObjectsDeselectsTheGuide()
    {
        Page page;
        page.pull(0, {50, 40});
        page.t.action("select-all")->trigger();
        QVERIFY(!page.session.guide);
        Page::key(Qt::Key_Delete);
        QCOMPARE(page.guides().size(), std::size_t(1));
        QVERIFY(page.session.now().objects().empty());
    }
    void undoneGuidesAreNotChosen()
    {
        Page page;
        page.pull(0, {50, 40});
        page.pull(0, {70, 40});
        page.canvas.undo();
        QVERIFY(!page.session.guide);
    }
    void escEndsADragFromARuler()
    {
        Page page;
        auto* ruler = page.t.window->findChild<QWidget*>("topRuler");
        QTest::mousePress(ruler, Qt::LeftButton, {}, ruler->rect().center());
        Page::key(Qt::Key_Escape);
        QTest::mouseRelease(ruler, Qt::LeftButton, {}, QPoint(50, 200));
        QVERIFY(page.guides().empty());
        QCOMPARE(page.canvas.tool(), std::string_view("select"));
    }
    void hiddenGuidesAreNotInTheWay()
    {
        Page page;
        page.pull(0, {50, 40});
        page.click({150, 70});
        page.t.action("guides")->trigger();
        page.canvas.setSnapping(app::SnapTo::All);
        page.drag({50, 70}, {70, 60});
        QCOMPARE(page.session.history.count(), 1);
        QVERIFY(!page.session.guide);
        page.pull(0, {60, 40}); // shows them again
        QVERIFY(page.session.display().guides);
        page.t.action("remove-guides")->trigger();
        QVERIFY(page.guides().empty());
    }
    void objectsAndPointsSnapToGuides()
    {
        Page page;
        page.pull(0, {50, 40});
        Page::type("130\n");
        page.canvas.setSnapping(app::SnapTo::All);
        page.canvas.setTool("line");
        page.click({130.4, 60});
        page.click({150, 70}, Qt::ControlModifier);
        Page::key(Qt::Key_Escape);
        QCOMPARE(page.paths(1).front().start.x, 130.0);
    }
};

} // namespace tools_guide_test

TEST_CLASS(tools_guide_test::GuideTest, Widgets)
#include "tests/ui/tools/guide_test.moc"

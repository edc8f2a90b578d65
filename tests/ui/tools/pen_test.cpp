// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QSignalSpy>
#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_pen_test {

// The Bézier pen, with mouse and keys.
class PenTest : public QObject {
    Q_OBJECT

    struct PenHand : Hand {
        PenHand() : Hand({})
        {
            canvas.setTool("pen");
            auto display = session.display();
            display.grid.shown = true; // so that the mouse is exact
            session.setDisplay(display);
            canvas.setSnapping(app::SnapTo::usual());
        }
        std::size_t count() { return session.now().objects().size(); }
        std::vector<app::PathSegment> segments() { return path().segments; }
        void at(app::Point p, app::Point to, Qt::KeyboardModifiers modifiers = {})
        {
            move(p, {});
            drag(p, to, modifiers);
        }
        void at(app::Point p)
        {
            move(p, {});
            click(p);
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void clicksMakeCornersAndDragsSmoothNodes()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.at({60, 50}, {80, 30});
        hand.at({120, 50});
        hand.at({160, 50});
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.path().start, app::Point(20, 50));
        QVERIFY(!hand.path().closed);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 50}, {40, 70}, true},
                                                {{120, 50}, {80, 30}, {120, 50}, true},
                                                {{160, 50}}}));
        QCOMPARE(hand.session.history.undoText(), QString("Draw curve"));
    }
    void altBreaksTheHandles()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.move({60, 50}, {});
        hand.press({60, 50});
        hand.move({80, 30}, Qt::LeftButton);
        hand.move({80, 70}, Qt::LeftButton, Qt::AltModifier);
        hand.release({80, 70}, Qt::AltModifier);
        hand.at({120, 50});
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 50}, {40, 70}, true},
                                                {{120, 50}, {80, 70}, {120, 50}, true}}));
    }
    void theKeySKeepsTheLengthOfTheOtherHandle()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.move({60, 50}, {});
        hand.press({60, 50});
        hand.move({70, 50}, Qt::LeftButton); // both handles are 10 long
        Hand::key(Qt::Key_S);
        QCOMPARE(hand.canvas.tool(), std::string_view("pen")); // not the star
        QVERIFY(hand.canvas.toolHint().startsWith("Smooth"));
        hand.move({60, 20}, Qt::LeftButton);
        hand.release({60, 20});
        hand.at({120, 50}, {130, 50}); // symmetric again
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 50}, {60, 60}, true},
                                                {{120, 50}, {60, 20}, {110, 50}, true}}));
        Hand::key(Qt::Key_S); // without a drag it is the star
        QCOMPARE(hand.canvas.tool(), std::string_view("star"));
    }
    void aSecondSMakesTheNodeSymmetricAgain()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.move({60, 50}, {});
        hand.press({60, 50});
        hand.move({70, 50}, Qt::LeftButton);
        Hand::key(Qt::Key_S);
        Hand::key(Qt::Key_S);
        hand.move({60, 20}, Qt::LeftButton);
        hand.release({60, 20});
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.segments()[0].control2, app::Point(60, 80));
    }
    void aClickOnTheLastNodeMakesItACorner()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.at({60, 50}, {80, 30});
        hand.at({60, 50});
        QTest::qWait(QApplication::doubleClickInterval() + 50);
        hand.at({120, 50});
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.segments().size(), std::size_t(2));
        QVERIFY(!hand.segments()[1].curved);
    }
    void aClickOnTheStartCloses()
    {
        PenHand hand;
        hand.at({20, 50}, {20, 30});
        hand.at({60, 50}, {60, 70});
        const auto* hint = hand.t.window->statusBar()->findChild<QLabel*>();
        hand.move({20, 50}, {});
        QCOMPARE(hint->text(), "Click to close the path.");
        hand.at({20, 50});
        QVERIFY(hint->text() != "Click to close the path.");
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.path().closed);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 30}, {60, 30}, true},
                                                {{20, 50}, {60, 70}, {20, 70}, true}}));
        QVERIFY(!hand.canvas.pendingObject());
    }
    void aDragFromTheStartClosesWithHandles()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.at({60, 50});
        hand.at({40, 80});
        hand.at({20, 50}, {20, 30});
        QVERIFY(hand.count() == 1 && hand.path().closed);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{
                     {{60, 50}}, {{40, 80}}, {{20, 50}, {40, 80}, {20, 70}, true}}));
    }
    void numbersPlaceNodesAndHandles()
    {
        PenHand hand;
        hand.canvas.setSnapping(app::SnapTo::Nothing);
        hand.type("20,50\n40,0\n");
        hand.press({61, 51});
        hand.move({90, 40}, Qt::LeftButton);
        hand.type("20<90\n");
        hand.release({90, 40});
        hand.type("#120,50\n");
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.segments().size(), std::size_t(2));
        QVERIFY(glm::distance(hand.segments()[1].control1, {60, 30}) < 1e-9);
        QCOMPARE(hand.segments()[0].to, app::Point(60, 50));
    }
    void undoTakesBackANodeAndRedoPutsItBack()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.at({60, 50}, {80, 30});
        hand.at({120, 50}, {140, 50});
        QCOMPARE(hand.t.action("undo")->text(), "&Undo Place node");
        hand.canvas.undo();
        hand.canvas.redo();
        hand.canvas.undo();
        Hand::key(Qt::Key_Backspace);
        hand.canvas.redo();
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.segments(),
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 50}, {40, 70}, true}}));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void anotherToolKeepsIt()
    {
        PenHand hand;
        hand.at({20, 50});
        hand.at({60, 50}, {80, 30});
        hand.canvas.setTool("select");
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void whatIsDrawnIsPendingWithItsHandles()
    {
        PenHand hand;
        QSignalSpy steps(&hand.canvas, &ui::Canvas::stepsChanged);
        hand.at({20, 50});
        hand.at({60, 50}, {80, 30});
        QVERIFY(hand.canvas.pendingObject());
        const auto before = steps.count();
        hand.move({100, 50}, {});
        QCOMPARE(steps.count(), before); // the journal has the handles already
        QCOMPARE(hand.canvas.pendingObject()->object.path.subpaths().front().segments,
                 (std::vector<app::PathSegment>{{{60, 50}, {20, 50}, {40, 70}, true}}));
    }
};

} // namespace tools_pen_test

TEST_CLASS(tools_pen_test::PenTest, Widgets)
#include "tests/ui/tools/pen_test.moc"

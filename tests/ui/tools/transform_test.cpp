// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"

#include <QLineEdit>
#include <QSignalSpy>

#include <glm/geometric.hpp>

#include <numbers>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_transform_test {

// Moving, rotating and scaling the selection, with mouse and keys only.
class TransformTest : public QObject {
    Q_OBJECT

    /// A canvas with a line from (40, 50) to (80, 50), which is selected, and one that is not.
    struct Hand : Stage {
        Hand() : Stage(ui::Backend::Raster, {line({40, 50}, {80, 50}), line({10, 90}, {30, 90})})
        {
            app::Edit noWindow;
            noWindow.windows = app::ClipWindows();
            session.document.apply(noWindow);
            auto display = session.display();
            display.unit = app::Unit::User;
            session.setDisplay(display);
            canvas->setTool("select");
            click({45, 50});
            move({60, 70});
        }
        static QWidget* focused() { return QApplication::focusWidget(); }
        static void type(const char* text)
        {
            for (const char* c = text; *c; ++c)
                *c == '\t'   ? QTest::keyClick(focused(), Qt::Key_Tab)
                : *c == '\n' ? QTest::keyClick(focused(), Qt::Key_Return)
                             : QTest::keyClick(focused(), *c);
        }
        clipping::Segment at(std::size_t object)
        {
            return *session.now().objects()[object].singleLine();
        }
        std::size_t count() const { return session.now().objects().size(); }
        bool is(std::size_t object, const app::Point& a, const app::Point& b)
        {
            return glm::distance(at(object).a, a) < 1e-9 && glm::distance(at(object).b, b) < 1e-9;
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void selectionIsMovedByNumbers()
    {
        Hand hand;
        const app::Variant before = hand.session.variant();
        hand.type("g10,-5\n");
        QVERIFY(hand.is(0, {50, 45}, {90, 45}));
        hand.type("gx7\n");
        QVERIFY(hand.is(0, {57, 45}, {97, 45}));
        hand.type("g20\t90\n");
        QVERIFY(hand.is(0, {57, 25}, {97, 25}));
        QCOMPARE(hand.session.variant(), before);
        QVERIFY(hand.is(1, {10, 90}, {30, 90}));
    }
    void selectionIsRotatedAndScaledAboutItsMiddle()
    {
        Hand hand;
        hand.type("o90\n");
        QVERIFY(hand.is(0, {60, 70}, {60, 30}));
        hand.type("k50%\n");
        QVERIFY(hand.is(0, {60, 60}, {60, 40}));
        hand.type("ky3\n");
        QVERIFY(hand.is(0, {60, 80}, {60, 20}));
        QCOMPARE(hand.session.history.count(), 3);
    }
    void pointerTransformsWithoutAButton()
    {
        Hand hand;
        hand.type("g");
        hand.move({70, 65});
        QVERIFY(hand.is(0, {40, 50}, {80, 50})); // not before the click
        hand.click({70, 65});
        QVERIFY(near(hand.at(0).a, {50, 45}));
        hand.move({90, 45});
        hand.type("o");
        hand.move({70, 25}); // a quarter turn about (70, 45)
        hand.type("\n");
        QVERIFY(near(hand.at(0).a, {70, 65}, 1));
    }
    void rotationAndScalingSnapByThePointThatIsGrabbed()
    {
        Hand hand; // the selected line from (40, 50) to (80, 50), and one that ends at (30, 90)
        hand.canvas->setSnapping(app::SnapTo::Nothing.with("ends"));
        hand.move({78.5, 51}); // grabs the end (80, 50)
        hand.type("o");
        hand.move({29.5, 90});
        hand.type("\n");
        // Its end now lies on the ray from the middle (60, 50) to (30, 90).
        QVERIFY(hand.is(0, app::Point(60, 50) - app::Point(-12, 16),
                        app::Point(60, 50) + app::Point(-12, 16)));
        hand.move({48.5, 66.5});
        hand.type("k");
        hand.move({29.5, 90});
        hand.type("\n");
        QVERIFY(glm::distance(hand.at(0).b, app::Point(30, 90)) < 1e-9);
    }
    void ctrlSuspendsSnappingOfRotation()
    {
        Hand hand;
        hand.canvas->setSnapping(app::SnapTo::Nothing.with("ends"));
        hand.move({80, 50});
        hand.type("o");
        hand.move({28.5, 91}, Qt::NoButton, Qt::ControlModifier);
        hand.click({28.5, 91}, Qt::ControlModifier);
        const app::Point way = hand.at(0).b - app::Point(60, 50);
        QVERIFY(std::abs(way.x * 40 + way.y * 30) > 1);
    }
    void skewSnapsAndShiftSkewsInSteps()
    {
        Hand hand;
        hand.canvas->setSnapping(app::SnapTo::Nothing.with("ends"));
        hand.click({20, 90}, Qt::ShiftModifier); // both: the box from (10, 50) to (80, 90)
        hand.move({80, 50});
        hand.type("j");
        hand.move({85.5, 47}, Qt::NoButton, Qt::ShiftModifier); // 15.4°
        hand.click({85.5, 47}, Qt::ShiftModifier);
        const double lean = std::tan(std::numbers::pi / 12) * 20;
        QVERIFY(std::abs(hand.at(0).b.x - (80 + lean)) < 1e-9);
    }
    void escLeavesEverythingAsItWas()
    {
        Hand hand;
        hand.type("g");
        hand.move({90, 20});
        hand.key(Qt::Key_Escape);
        QVERIFY(hand.is(0, {40, 50}, {80, 50}));
        QCOMPARE(hand.session.history.count(), 0);
        QCOMPARE(hand.session.selection().size(), std::size_t(1));
    }
    void typingAfterwardsChangesWhatWasDone()
    {
        Hand hand;
        hand.type("o90\n");
        hand.type("180\n");
        QVERIFY(hand.is(0, {80, 50}, {40, 50}));
        QCOMPARE(hand.session.history.count(), 1);
        hand.type("0\n"); // as if nothing had been done
        QVERIFY(hand.is(0, {40, 50}, {80, 50}));
        QCOMPARE(hand.session.history.index(), 0);
    }
    void digitsChooseTheAlgorithmAgainAfterTheNextAction()
    {
        Hand hand;
        hand.type("o90\n");
        hand.click({20, 90});
        hand.key(Qt::Key_3);
        QVERIFY(!qobject_cast<QLineEdit*>(Hand::focused()));
        QVERIFY(hand.is(0, {60, 70}, {60, 30}));
    }
    void dragTakesNumbersToo()
    {
        Hand hand;
        const app::Variant before = hand.session.variant();
        hand.press({45, 50});
        hand.move({65, 50}, Qt::LeftButton);
        hand.type("33\n");
        hand.release({65, 50});
        QVERIFY(hand.is(0, {73, 50}, {113, 50}));
        QCOMPARE(hand.session.variant(), before);
        QCOMPARE(hand.session.history.count(), 1);
    }
    void copiesAreRepeatedAndDivided()
    {
        Hand hand;
        hand.type("gc0,8\n");
        QCOMPARE(hand.count(), std::size_t(3));
        QVERIFY(hand.is(2, {40, 58}, {80, 58}));
        hand.type("4x\n");
        QCOMPARE(hand.count(), std::size_t(6));
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(hand.is(2 + i, {40, 58 + 8 * double(i)}, {80, 58 + 8 * double(i)}));
        hand.type("2/\n");
        QCOMPARE(hand.count(), std::size_t(4));
        QVERIFY(hand.is(2, {40, 54}, {80, 54}) && hand.is(3, {40, 58}, {80, 58}));
        hand.canvas->undo();
        QCOMPARE(hand.count(), std::size_t(2));
    }
    void starIsOneLineRotated()
    {
        Hand hand;
        hand.type("oc30\n5x\n");
        QCOMPARE(hand.count(), std::size_t(7));
        for (int i = 1; i <= 5; ++i) {
            const double angle = i * std::numbers::pi / 6;
            const app::Point arm(20 * std::cos(angle), -20 * std::sin(angle)), middle(60, 50);
            QVERIFY(hand.is(std::size_t(1 + i), middle - arm, middle + arm));
        }
    }
    void pivotIsMovedAndTurnedAbout()
    {
        Hand hand;
        hand.click({20, 90}, Qt::ShiftModifier); // both lines: from (10, 50) to (80, 90)
        hand.drag({45, 70}, {80, 50});           // the middle of the box to the end of a line
        hand.move({60, 70});
        hand.type("o90\n");
        QVERIFY(hand.is(0, {80, 90}, {80, 50}));
    }
    void pivotIsPutUnderThePointerByAKey()
    {
        Hand hand;
        hand.type("o");
        hand.move({80.4, 50});
        hand.type("p180\n");
        QVERIFY(hand.is(0, {120, 50}, {80, 50}));
    }
    void rotationHandleTurns()
    {
        Hand hand;
        hand.drag({30, 30}, {95, 60});
        const app::Point handle(60, 50 - 14); // 28 pixels above, at a zoom of 2
        hand.press(handle);
        hand.move({70, 40}, Qt::LeftButton);
        hand.type("-90\n");
        hand.release({70, 40});
        QVERIFY(hand.is(0, {60, 30}, {60, 70}));
    }
    void boxHandleTakesTheSize()
    {
        Hand hand;
        hand.click({20, 90}, Qt::ShiftModifier); // both lines: from (10, 50) to (80, 90)
        hand.press({80, 90});
        hand.move({90, 95}, Qt::LeftButton);
        hand.type("140\t20\n");
        hand.release({90, 95});
        QVERIFY(hand.is(0, {70, 50}, {150, 50}) && hand.is(1, {10, 70}, {50, 70}));
    }
    void digitDoesNotUndoAnotherStep()
    {
        Hand hand;
        hand.type("g10,0\n");
        hand.canvas->undo();
        hand.session.history.push(
            new app::RemoveObjects(hand.session.document, app::ObjectRanges{1})); // as many steps
        hand.key(Qt::Key_5);
        QVERIFY(!qobject_cast<QLineEdit*>(Hand::focused()));
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.is(0, {40, 50}, {80, 50}));
    }
    void correctionEndsWithItsField()
    {
        Hand hand;
        hand.type("g10,0\n");
        hand.type("5"); // the step is open
        QTest::keyClick(Hand::focused(), Qt::Key_Escape);
        QVERIFY(hand.is(0, {50, 50}, {90, 50}));
        hand.type("5");
        hand.canvas->undo(); // cancels the correction
        QVERIFY(hand.is(0, {50, 50}, {90, 50}));
        QVERIFY(!qobject_cast<QLineEdit*>(Hand::focused()));
        hand.key(Qt::Key_Return); // opens it again
        QVERIFY(qobject_cast<QLineEdit*>(Hand::focused()));
        QTest::keyClick(Hand::focused(), Qt::Key_Escape);
        QVERIFY(hand.is(0, {50, 50}, {90, 50}));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void pointerIsFreeAfterADrag()
    {
        Hand hand;
        hand.drag({45, 50}, {65, 50});
        QSignalSpy moved(hand.canvas.get(), &ui::Canvas::pointerMoved);
        hand.move({20, 20});
        const auto at = moved.last()[0].value<std::optional<app::Point>>();
        QVERIFY(at && near(*at, {20, 20}));
    }
    void whatIsRemovedDuringAGestureStaysRemoved()
    {
        for (const char* keys : {"g", "o"}) {
            Hand hand;
            hand.type(keys);
            hand.move({70, 65});
            hand.session.history.push(
                new app::RemoveObjects(hand.session.document, hand.session.selection()));
            hand.type("30\n");
            QCOMPARE(hand.count(), std::size_t(1));
            QCOMPARE(hand.session.history.count(), 1);
        }
        Hand hand;
        hand.click({20, 90}, Qt::ShiftModifier);
        hand.press({80, 90});
        hand.move({90, 95}, Qt::LeftButton);
        hand.session.history.push(
            new app::RemoveObjects(hand.session.document, hand.session.selection()));
        hand.release({95, 95});
        QCOMPARE(hand.count(), std::size_t(0));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void whatWasJustDrawnIsTransformedWithoutSelectingIt()
    {
        Hand hand; // the line that is selected is left alone
        hand.canvas->setTool("line");
        hand.type("10,20\n30,0\n");
        hand.key(Qt::Key_Return);
        hand.type("g0,7\n");
        QCOMPARE(hand.count(), std::size_t(3));
        QVERIFY(hand.is(2, {10, 27}, {40, 27}));
        QVERIFY(hand.is(0, {40, 50}, {80, 50}));
    }
    void nothingSelectedIsSaid()
    {
        Hand hand;
        hand.session.select({});
        QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.type("o");
        QCOMPARE(refused.count(), 1);
    }
};

} // namespace tools_transform_test

TEST_CLASS(tools_transform_test::TransformTest, Widgets)
#include "tests/ui/tools/transform_test.moc"

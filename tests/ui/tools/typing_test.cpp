// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/direction.h"
#include "app/view/ruler.h"

#include <QLineEdit>

#include <glm/geometric.hpp>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_typing_test {

// Numbers typed during a gesture, with mouse and keys only.
class TypingTest : public QObject {
    Q_OBJECT

    /// A canvas with a tool; what is typed goes to the widget that has the keyboard.
    struct Hand : Stage {
        explicit Hand(const char* tool) : Stage(ui::Backend::Raster, {})
        {
            auto display = session.display();
            display.unit = app::Unit::User;
            session.setDisplay(display);
            canvas->setTool(tool);
            canvas->setSnapping(app::SnapTo::Nothing);
        }
        static QWidget* focused() { return QApplication::focusWidget(); }
        static void type(const char* text)
        {
            for (const char* c = text; *c; ++c)
                *c == '\t'   ? QTest::keyClick(focused(), Qt::Key_Tab)
                : *c == '\n' ? QTest::keyClick(focused(), Qt::Key_Return)
                             : QTest::keyClick(focused(), *c);
        }
        std::size_t count() const { return session.now().objects().size(); }
        clipping::Segment lastLine()
        {
            const auto& lines = session.scene.lines();
            return lines[lines.size() - 1];
        }
        clipping::Window lastBox()
        {
            const auto& lines = session.scene.lines();
            const std::size_t first = lines.firstLineOf(count() - 1);
            clipping::Window box{lines[first].a, lines[first].a};
            for (std::size_t i = first; i < lines.size(); ++i)
                box = {glm::min(box.min, lines[i].a), glm::max(box.max, lines[i].a)};
            return box;
        }
    };
    static bool same(const app::Point& a, const app::Point& b)
    {
        return glm::distance(a, b) < 1e-9;
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void lineTakesALengthInThePointersDirection()
    {
        Hand hand("line");
        hand.click({20, 30});
        hand.move({120, 30});
        const app::Variant before = hand.session.variant();
        hand.type("3450\n");
        QCOMPARE(hand.count(), std::size_t(1));
        const auto line = hand.lastLine();
        QCOMPARE(line.b, line.a + app::Point(3450, 0));
        QCOMPARE(hand.session.variant(), before);
    }
    void tabLocksTheLengthAndGoesOnToTheAngle()
    {
        Hand hand("line");
        hand.click({20, 90});
        hand.move({120, 30});
        const app::Variant before = hand.session.variant();
        hand.type("3450\t90");
        hand.move({7, 20});
        hand.type("\n");
        const auto line = hand.lastLine();
        QCOMPARE(line.b, line.a + app::Point(0, -3450));
        QCOMPARE(hand.session.variant(), before);
    }
    void lockedLengthStaysWhileThePointerSteersTheAngle()
    {
        Hand hand("line");
        hand.click({20, 90});
        hand.move({120, 30});
        hand.type("40\t");
        hand.click({100, 90});
        const auto line = hand.lastLine();
        QVERIFY(std::abs(glm::distance(line.a, line.b) - 40) < 1e-9);
        QVERIFY(std::abs(line.b.y - line.a.y) < 1);
    }
    void chainIsDrawnWithoutTheMouse()
    {
        Hand hand("line");
        hand.move({100, 50});
        hand.type("10,20\n"); // the first point is absolute
        hand.type("30,0\n");
        hand.type("#40,50\n");
        hand.type("5<90\n");
        QCOMPARE(hand.count(), std::size_t(3));
        const auto& lines = hand.session.scene.lines();
        QVERIFY(same(lines[0].a, {10, 20}) && same(lines[0].b, {40, 20}));
        QVERIFY(same(lines[1].a, {40, 20}) && same(lines[1].b, {40, 50}));
        QVERIFY(same(lines[2].b, {40, 45}));
        hand.canvas->undo(); // takes one line back, and goes on from there
        QCOMPARE(hand.count(), std::size_t(2));
        hand.type("1,1\n");
        QVERIFY(same(hand.lastLine().a, {40, 50}) && same(hand.lastLine().b, {41, 51}));
    }
    void aChainEndsWhereItBegan()
    {
        Hand hand("line");
        for (const app::Point& at : {app::Point(20, 20), {80, 20}, {80, 60}, {21, 20}, {120, 90}})
            hand.click(at);
        QCOMPARE(hand.count(), std::size_t(3)); // the last click begins another one
        QCOMPARE(hand.lastLine().b, hand.session.scene.lines()[0].a);
        hand.click({120, 40});
        QCOMPARE(hand.count(), std::size_t(4));
        QVERIFY(hand.lastLine().a != hand.session.scene.lines()[0].a);
    }
    void aChainGoesOnIfThatIsChosen()
    {
        Hand hand("line");
        hand.canvas->keepNumbers("line", {1, 0});
        for (const app::Point& at : {app::Point(20, 20), {80, 20}, {80, 60}, {20, 20}, {120, 90}})
            hand.click(at);
        QCOMPARE(hand.count(), std::size_t(4));
    }
    // By clicks and by numbers.
    void linesStandAloneIfThatIsChosen()
    {
        Hand hand("line");
        hand.canvas->keepNumbers("line", {0, 1});
        for (const app::Point& at : {app::Point(20, 20), {80, 20}, {80, 60}, {20, 60}, {20, 30}})
            hand.click(at);
        QCOMPARE(hand.count(), std::size_t(2));
        const auto& lines = hand.session.scene.lines();
        QVERIFY(lines[1].a != lines[0].b);
        hand.type("30\n");
        QCOMPARE(hand.count(), std::size_t(3));
        hand.click({100, 80});
        hand.click({150, 80});
        QCOMPARE(hand.count(), std::size_t(4));
        QVERIFY(hand.lastLine().a != lines[2].b);
    }
    void typingAfterwardsChangesWhatWasDrawn()
    {
        Hand hand("line");
        hand.drag({20, 20}, {120, 20});
        const app::Point from = hand.lastLine().a;
        hand.move({50, 70});
        hand.type("35\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.lastLine().b, from + app::Point(35, 0));
        hand.type("12\n");
        QCOMPARE(hand.lastLine().b, from + app::Point(12, 0));
        QCOMPARE(hand.session.history.count(), 1);
        hand.type("99");
        QTest::keyClick(Hand::focused(), Qt::Key_Escape); // the field
        hand.key(Qt::Key_Escape);                         // the gesture
        QCOMPARE(hand.lastLine().b, from + app::Point(12, 0));
        hand.canvas->undo();
        QCOMPARE(hand.count(), std::size_t(0));
    }
    void polylineTakesCornersByNumbers()
    {
        Hand hand("polyline");
        hand.move({100, 50});
        hand.type("0,0\n100,0\n0,50\n<180\t20\n");
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(1));
        const auto& lines = hand.session.scene.lines();
        QCOMPARE(lines.size(), std::size_t(3));
        QVERIFY(same(lines[1].b, {100, 50}) && same(lines[2].b, {80, 50}));
    }
    void rectangleTakesWidthAndHeight()
    {
        Hand hand("rectangle");
        hand.click({20, 30});
        hand.move({60, 80});
        hand.type("25\t12.5\n");
        QCOMPARE(hand.count(), std::size_t(1));
        const auto box = hand.lastBox();
        QVERIFY(same(box.max - box.min, {25, 12.5}));
        hand.type("7\n"); // the width of what was just drawn
        QVERIFY(std::abs(hand.lastBox().max.x - hand.lastBox().min.x - 7) < 1e-9);
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void sidesGoRightAndDownUnlessTheyAreDraggedElsewhere()
    {
        Hand hand("rectangle");
        hand.move({20, 10}); // left of and above the first corner
        hand.type("60,40\n25\t12.5\n");
        QVERIFY(same(hand.lastBox().min, {60, 40}) && same(hand.lastBox().max, {85, 52.5}));
        hand.type("#60,40\n");
        hand.move({30, 15}); // it is dragged there
        hand.type("25\t12.5\n");
        QVERIFY(same(hand.lastBox().min, {35, 27.5}) && same(hand.lastBox().max, {60, 40}));
        hand.type("#60,40\n-25\t12.5\n");
        QVERIFY(same(hand.lastBox().min, {35, 40}) && same(hand.lastBox().max, {60, 52.5}));
        QCOMPARE(hand.count(), std::size_t(3));
    }
    void oneSideAloneIsASquare()
    {
        Hand hand("ellipse");
        hand.move({20, 10});
        hand.type("60,40\n25\n");
        QVERIFY(same(hand.lastBox().min, {60, 40}) && same(hand.lastBox().max, {85, 65}));
        hand.type("12\n"); // a correction of the width is one
        QVERIFY(same(hand.lastBox().max - hand.lastBox().min, {12, 25}));
        hand.type("#60,40\n\t8\n");
        QVERIFY(same(hand.lastBox().max - hand.lastBox().min, {8, 8}));
        hand.type("#60,40\n");
        hand.move({80, 70}); // the pointer says how high it is
        hand.type("5\n");
        const app::Point size = hand.lastBox().max - hand.lastBox().min;
        QVERIFY(same({size.x, 5}, {5, 5}) && size.y > 20);
        QCOMPARE(hand.count(), std::size_t(3));
    }
    void enterMakesAnotherOfTheSameSize()
    {
        Hand hand("rectangle");
        hand.move({20, 10});
        hand.type("60,40\n");
        hand.key(Qt::Key_Return); // there is none yet
        QCOMPARE(hand.count(), std::size_t(0));
        hand.type("25\t12.5\n#10,20\n");
        QVERIFY(hand.canvas->toolHint().contains("25"));
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(same(hand.lastBox().min, {10, 20}) && same(hand.lastBox().max, {35, 32.5}));
        hand.canvas->setTool("rectangle"); // chosen anew
        hand.click({70, 60});
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(3));
        QVERIFY(same(hand.lastBox().max - hand.lastBox().min, {25, 12.5}));
        hand.click({70, 20});
        hand.move({90, 50});
        QVERIFY(!hand.canvas->toolHint().contains("again"));
        hand.click({90, 50});
        QVERIFY(!same(hand.lastBox().max - hand.lastBox().min, {25, 12.5}));
    }
    void rectangleIsDrawnByTwoClicks()
    {
        Hand hand("rectangle");
        hand.click({20, 30});
        hand.move({60, 80});
        hand.click({60, 80});
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(near(hand.lastBox().min, {20, 30}) && near(hand.lastBox().max, {60, 80}));
        hand.click({70, 90});
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void numberTypedAfterwardsKeepsTheCentre()
    {
        Hand hand("rectangle");
        hand.click({60, 60});
        hand.move({80, 90});
        hand.click({80, 90}, Qt::AltModifier);
        const auto centre = hand.lastBox().min + hand.lastBox().max;
        hand.move({10, 20}); // Alt is up
        hand.type("8\t6\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(same(hand.lastBox().min + hand.lastBox().max, centre));
        QVERIFY(same(hand.lastBox().max - hand.lastBox().min, {8, 6}));
    }
    void clickEndsTheCorrectionAndBeginsTheNextGesture()
    {
        Hand hand("line");
        hand.drag({20, 20}, {120, 20});
        const auto drawn = hand.lastLine();
        hand.move({50, 70});
        hand.type("35");
        hand.click({50, 70});
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.lastLine(), drawn);
        hand.move({90, 70});
        hand.click({90, 70});
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(near(hand.lastLine().a, {50, 70}) && near(hand.lastLine().b, {90, 70}));
    }
    void toolChosenAgainBeginsAnew()
    {
        Hand hand("rectangle");
        hand.move({20, 30});
        hand.type("#10,10\n20\t30\n");
        hand.canvas->setTool("rectangle");
        hand.type("5,6\n7\t8\n"); // not the corner of the first one
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(same(hand.lastBox().min, {5, 6}) && same(hand.lastBox().max, {12, 14}));
    }
    void halfOfAFirstPointIsForgottenWithItsField()
    {
        Hand hand("rectangle");
        hand.move({20, 30});
        hand.type("7");
        hand.click({20, 30}); // the canvas gets the keyboard
        hand.click({60, 80});
        QVERIFY(near(hand.lastBox().min, {20, 30}));
        hand.type("#7");
        hand.canvas->setTool("ellipse");
        hand.click({30, 30});
        hand.click({60, 80});
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(near(hand.lastBox().min, {30, 30}));
    }
    void lockedCoordinateOfAFirstPointHoldsUntilEsc()
    {
        Hand hand("line");
        hand.move({20, 30});
        hand.type("7\t");
        hand.click({20, 30});
        hand.click({60, 80});
        QCOMPARE(hand.lastLine().a.x, 7);
        QVERIFY(near(hand.lastLine().a, {7, 30}));
        hand.canvas->setTool("line"); // otherwise a number would change that line
        hand.type("7\t");
        QTest::keyClick(Hand::focused(), Qt::Key_Escape);
        hand.key(Qt::Key_Escape);
        hand.click({40, 30});
        hand.click({60, 80});
        QVERIFY(near(hand.lastLine().a, {40, 30}));
    }
    void lengthOfZeroIsRefusedAndTheGestureGoesOn()
    {
        for (const char* typed : {"0\n", "0\t", "0,0\n", "0<45\n"}) {
            Hand hand("line");
            hand.click({20, 30});
            hand.move({60, 30});
            hand.type(typed);
            auto* field = qobject_cast<QLineEdit*>(Hand::focused());
            QVERIFY2(field, typed);
            QVERIFY(!field->text().isEmpty());
            QCOMPARE(hand.count(), std::size_t(0));
            field->clear();
            hand.type("5\n");
            QCOMPARE(hand.lastLine().b, hand.lastLine().a + app::Point(5, 0));
        }
    }
    void nonsenseIsRefusedWithOneSentenceAndChangesNothing()
    {
        Hand hand("line");
        hand.click({20, 30});
        hand.move({60, 80});
        hand.type("1abc\n");
        QCOMPARE(hand.count(), std::size_t(0));
        auto* field = qobject_cast<QLineEdit*>(Hand::focused());
        QVERIFY(field);
        QCOMPARE(field->text(), "1abc");
        field->clear();
        hand.type("5\n");
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void backspaceGivesTheFieldBack()
    {
        Hand hand("line");
        hand.click({20, 30});
        hand.move({60, 30});
        hand.type("5");
        QVERIFY(qobject_cast<QLineEdit*>(Hand::focused()));
        QTest::keyClick(Hand::focused(), Qt::Key_Backspace);
        QVERIFY(qobject_cast<QLineEdit*>(Hand::focused()));
        QTest::keyClick(Hand::focused(), Qt::Key_Backspace);
        QVERIFY(!qobject_cast<QLineEdit*>(Hand::focused()));
        hand.click({90, 30});
        QVERIFY(near(hand.lastLine().b, {90, 30}));
    }
    void numberAfterAnEndedChainChangesItsLastLine()
    {
        Hand hand("line");
        hand.click({20, 30});
        hand.click({60, 30});
        hand.move({60, 80});
        hand.type("25\n"); // the next line, because the chain goes on
        QCOMPARE(hand.count(), std::size_t(2));
        hand.key(Qt::Key_Return);
        const app::Point from = hand.lastLine().a;
        hand.type("40\n");
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(std::abs(glm::distance(hand.lastLine().b, from) - 40) < 1e-9);
        hand.type("10<0\n");
        QVERIFY(same(hand.lastLine().b, from + app::Point(10, 0)));
        QCOMPARE(hand.session.history.count(), 2);
    }
    void pointAfterAnEndedChainBeginsTheNext()
    {
        for (const char* tool : {"line", "polyline"}) {
            Hand hand(tool);
            hand.type("#10,20\n30,0\n\n");
            QCOMPARE(hand.count(), std::size_t(1));
            const auto drawn = hand.lastLine();
            hand.type("50,60\n8,0\n\n");
            QCOMPARE(hand.count(), std::size_t(2));
            QVERIFY(same(hand.lastLine().a, {50, 60}) && same(hand.lastLine().b, {58, 60}));
            QCOMPARE(hand.session.scene.lines()[0], drawn);
            hand.type("@2,3\n8,0\n\n"); // from the last point
            QVERIFY(same(hand.lastLine().a, {60, 63}));
        }
    }
    void atSignCountsFromTheLastPointOfAnyTool()
    {
        Hand hand("line");
        hand.type("@10,20\n5,0\n\n"); // nothing was drawn: from the origin
        QVERIFY(same(hand.lastLine().a, {10, 20}));
        hand.canvas->setTool("rectangle");
        hand.type("@1,2\n20\t30\n");
        QVERIFY(same(hand.lastBox().min, {16, 22}) && same(hand.lastBox().max, {36, 52}));
        hand.canvas->setTool("line");
        hand.type("@1,1\n@5,0\n\n");
        QVERIFY(same(hand.lastLine().a, {37, 53}) && same(hand.lastLine().b, {42, 53}));
        hand.session.load({});
        hand.canvas->setTool("line");
        hand.type("@10,20\n5,0\n\n");
        const app::Point origin = app::originOf(hand.session.now().page(), app::Unit::User);
        QVERIFY(same(hand.lastLine().a, origin + app::Point(10, 20)));
    }
    void directionAloneIsHeldAndTheGestureGoesOn()
    {
        Hand hand("line");
        hand.click({20, 90});
        hand.move({120, 90});
        hand.type("<45\n");
        QCOMPARE(hand.count(), std::size_t(0));
        hand.type("20\n");
        QCOMPARE(hand.count(), std::size_t(1));
        const auto line = hand.lastLine();
        QVERIFY(same(line.b, line.a + app::Point(20, -20) / std::sqrt(2.0)));
        hand.type("<90\n");
        const app::Point from = line.b;
        hand.click({from.x + 30, from.y - 12});
        QCOMPARE(hand.count(), std::size_t(2));
        QCOMPARE(hand.lastLine().b.x, from.x);
        hand.key(Qt::Key_Return);
        hand.type("<0\n"); // a correction knows the length
        QCOMPARE(hand.lastLine().b.y, from.y);
        QCOMPARE(hand.count(), std::size_t(2));
    }
    void lineFromItsMiddle()
    {
        Hand hand("line");
        hand.drag({100, 50}, {140, 50}, Qt::LeftButton, Qt::AltModifier);
        QVERIFY(near(hand.lastLine().a, {60, 50}) && near(hand.lastLine().b, {140, 50}));
        hand.type("60\n"); // the whole length
        const auto line = hand.lastLine();
        QVERIFY(std::abs(glm::distance(line.a, line.b) - 60) < 1e-9);
        QVERIFY(near((line.a + line.b) * 0.5, {100, 50}));
    }
    void numberAfterAPolylineChangesItsLastSegment()
    {
        for (const char* tool : {"polyline", "pen"}) {
            Hand hand(tool);
            const app::Variant before = hand.session.variant();
            hand.click({20, 30});
            hand.click({60, 30});
            hand.click({60, 80});
            hand.key(Qt::Key_Return);
            const app::Point corner = hand.lastLine().a;
            hand.type("35<0\n");
            QCOMPARE(hand.count(), std::size_t(1));
            QCOMPARE(hand.session.scene.lines().size(), std::size_t(2));
            QVERIFY(same(hand.lastLine().b, corner + app::Point(35, 0)));
            hand.type("12\n");
            QVERIFY(same(hand.lastLine().b, corner + app::Point(12, 0)));
            QCOMPARE(hand.session.history.count(), 1);
            hand.type("99");
            hand.click({100, 10}); // ends the correction, and begins the next path
            QVERIFY(same(hand.lastLine().b, corner + app::Point(12, 0)));
            hand.click({120, 10});
            hand.key(Qt::Key_Return);
            QCOMPARE(hand.count(), std::size_t(2));
            QVERIFY(near(hand.lastLine().a, {100, 10}) && near(hand.lastLine().b, {120, 10}));
            QCOMPARE(hand.session.variant(), before);
        }
    }
    void handlesOfTheLastNodeMoveWithIt()
    {
        Hand hand("pen");
        hand.drag({20, 50}, {30, 40});
        hand.drag({80, 50}, {90, 60});
        hand.key(Qt::Key_Return);
        const auto before = hand.session.now().objects()[0].path().subpaths()[0];
        hand.type("100<0\n");
        const auto after = hand.session.now().objects()[0].path().subpaths()[0];
        const app::Point by = after.segments[0].to - before.segments[0].to;
        QVERIFY(same(after.segments[0].to, before.start + app::Point(100, 0)));
        QVERIFY(same(after.segments[0].control2 - before.segments[0].control2, by));
        QCOMPARE(after.segments[0].control1, before.segments[0].control1);
    }
    void closedPathIsNotCorrected()
    {
        Hand hand("polyline");
        hand.click({20, 30});
        hand.click({60, 30});
        hand.click({60, 80});
        hand.click({20, 30});
        QCOMPARE(hand.count(), std::size_t(1));
        hand.type("35\t40\n"); // the first point of the next path
        hand.type("5,0\n\n");
        QCOMPARE(hand.count(), std::size_t(2));
        QVERIFY(same(hand.lastLine().a, {35, 40}));
    }
    void digitsOfOtherToolsStillChooseTheAlgorithm()
    {
        Hand hand("select");
        hand.key(Qt::Key_3);
        QVERIFY(!qobject_cast<QLineEdit*>(Hand::focused()));
    }
};

} // namespace tools_typing_test

TEST_CLASS(tools_typing_test::TypingTest, Widgets)
#include "tests/ui/tools/typing_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"

#include <QAbstractButton>
#include <QDialog>
#include <QPushButton>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_pivot_test {

// The cross about which the selection is turned, with mouse and keys only.
class PivotTest : public QObject {
    Q_OBJECT

    static app::Subpath box() { return {{120, 20}, {{{160, 20}}, {{160, 60}}, {{120, 60}}}, true}; }
    static app::Subpath line() { return {{60, 40}, {{{90, 40}}}, false}; }
    static bool near(const app::Point& a, const app::Point& b)
    {
        return glm::distance(a, b) < 1e-9;
    }
    /// The cross that waits beside the rotation handle, in the drawing.
    static app::Point waiting(Hand& hand, const app::Point& top)
    {
        return top + app::Point(24, -28) / hand.canvas.view().zoom;
    }
    /// Puts the cross exactly at a corner, to which it snaps.
    static void dragCross(Hand& hand, const app::Point& from, const app::Point& to)
    {
        hand.canvas.setSnapping(app::SnapTo::All);
        hand.drag(from, to);
        hand.canvas.setSnapping(app::SnapTo::Nothing);
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void flipsAndQuarterTurnsUseTheMovedCross()
    {
        Hand hand({shape({box()})});
        hand.click({120, 30});
        dragCross(hand, {140, 40}, {120, 60});
        QVERIFY(near(hand.session.pivot.at(), {120, 60}));
        Hand::key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(near(hand.path().start, {120, 20}));
        QVERIFY(near(hand.path().segments[0].to, {80, 20}));
        QVERIFY(near(hand.session.pivot.at(), {120, 60})); // it stays
        Hand::key(Qt::Key_V, Qt::ShiftModifier);
        QVERIFY(near(hand.path().segments[0].to, {80, 100}));
        Hand::key(Qt::Key_O, Qt::ShiftModifier); // 90° left about (120, 60)
        QVERIFY(near(hand.path().segments[0].to, {160, 100}));
        QCOMPARE(hand.session.history.count(), 3);
    }
    void withoutAMoveTheMiddleStays()
    {
        Hand hand({shape({box()})});
        hand.click({120, 30});
        Hand::key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(near(hand.path().start, {160, 20}));
        QVERIFY(near(hand.path().segments[0].to, {120, 20}));
    }
    void theCrossOfALineWaitsBesideTheRotationHandle()
    {
        Hand hand({shape({line()})});
        hand.click({70, 40});
        dragCross(hand, waiting(hand, {75, 40}), {60, 40});
        QVERIFY(near(hand.session.pivot.at(), {60, 40}));
        QCOMPARE(hand.session.history.count(), 0);
        Hand::key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(near(hand.path().start, {60, 40}) && near(hand.path().segments[0].to, {30, 40}));
    }
    void itCoversNoHandleAndNoLine()
    {
        Hand hand({shape({line()}), shape({{{150, 70}, {{{153, 70}}, {{153, 72}}}, true}})});
        hand.click({70, 40});
        hand.drag({75, 40}, {75, 50}); // by its middle
        QVERIFY(hand.isNear(hand.path().start, {60, 50}));
        hand.drag({90, 50}, {95, 50}); // by its end
        QVERIFY(hand.isNear(hand.path().segments[0].to, {95, 50}));
        hand.click({151, 70}); // a small object
        hand.drag({151, 70}, {141, 70});
        QVERIFY(hand.isNear(hand.paths(1).front().start, {140, 70}));
        dragCross(hand, waiting(hand, {141.5, 70}), {140, 70});
        QVERIFY(hand.isNear(hand.session.pivot.at(), {140, 70}));
    }
    void repeatsAroundThePointWhereTheCrossIs()
    {
        Hand hand({shape({line()})});
        hand.click({70, 40});
        dragCross(hand, waiting(hand, {75, 40}), {60, 40});
        Hand::key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(QApplication::activeModalWidget());
        QWidget* dialog = QApplication::activeModalWidget();
        for (auto* button : dialog->findChildren<QAbstractButton*>())
            if (button->accessibleName().endsWith("Around a point"))
                QTest::mouseClick(button, Qt::LeftButton);
        const auto field = [&](const QString& name) -> QDoubleSpinBox* {
            for (auto* one : dialog->findChildren<ui::LengthField*>())
                if (one->accessibleName() == name)
                    return one;
            return nullptr;
        };
        QCOMPARE(field("Centre X")->value(), 60.0);
        QCOMPARE(field("Centre Y")->value(), 40.0);
        for (auto* count : dialog->findChildren<QSpinBox*>())
            if (count->isVisible()) {
                count->setFocus();
                count->selectAll();
                QTest::keyClicks(count, "4");
            }
        for (auto* button : dialog->findChildren<QPushButton*>())
            if (button->isDefault())
                QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(!QApplication::activeModalWidget());
        QCOMPARE(hand.session.now().objects().size(), std::size_t(4));
        const std::array ends{app::Point(90, 40), app::Point(60, 10), app::Point(30, 40),
                              app::Point(60, 70)};
        for (std::size_t i = 0; i < ends.size(); ++i) {
            QVERIFY(near(hand.paths(i).front().start, {60, 40}));
            QVERIFY(near(hand.paths(i).front().segments[0].to, ends[i]));
        }
        QCOMPARE(hand.session.history.count(), 1);
    }
};

} // namespace tools_pivot_test

TEST_CLASS(tools_pivot_test::PivotTest, Widgets)
#include "tests/ui/tools/pivot_test.moc"

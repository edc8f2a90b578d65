// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look.h"

#include <QSignalSpy>

#include <glm/geometric.hpp>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_resize_test {

// The handles of the selection's box: they snap by their own place, and numbers change the last
// resizing.
class ResizeTest : public QObject {
    Q_OBJECT

    /// Two lines in the box from (50, 30) to (80, 60), which is selected, and one elsewhere.
    struct Hand : Stage {
        explicit Hand(const char* kind, app::Point end = {100, 70})
            : Stage(ui::Backend::Raster,
                    {line({50, 30}, {80, 30}), line({50, 60}, {70, 60}), line(end, {180, 80.3})})
        {
            app::Edit noWindow;
            noWindow.windows = app::ClipWindows();
            session.document.apply(noWindow);
            auto display = session.display();
            display.unit = app::Unit::User;
            session.setDisplay(display);
            canvas->setSnapping(app::SnapTo::Nothing.with(kind));
            drag({45, 25}, {85, 65});
        }
        static void type(const char* text)
        {
            for (const char* c = text; *c; ++c)
                *c == '\t'   ? QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab)
                : *c == '\n' ? QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return)
                             : QTest::keyClick(QApplication::focusWidget(), *c);
        }
        clipping::Window box() const { return *session.selectionBounds(); }
        bool is(const clipping::Window& expected, double most = 1e-9) const
        {
            return near(box(), expected, most);
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aCornerSnapsByItsOwnPlaceWhereverItWasGrabbed()
    {
        Hand hand("ends");
        QVERIFY(hand.is({{50, 30}, {80, 60}}));
        hand.drag({81.5, 61}, {100, 70.5}); // (98.5, 69.5), within 8 pixels
        QVERIFY(hand.is({{50, 30}, {100, 70}}));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void ctrlSuspendsSnapping()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {99, 69}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(hand.is({{50, 30}, {99, 69}}, 0.3) && !hand.is({{50, 30}, {100, 70}}, 0.3));
    }
    void aSideSnapsAcrossItself()
    {
        Hand hand("ends");
        hand.drag({80, 45}, {98.5, 69});
        QVERIFY(hand.is({{50, 30}, {100, 60}}));
    }
    void aCornerIsAlignedWithOtherObjects()
    {
        Hand hand("alignment");
        hand.drag({80, 60}, {98.5, 90});
        QCOMPARE(hand.box().max.x, 100.0);
        QVERIFY(std::abs(hand.box().max.y - 90) < 0.3);
    }
    void inProportionASidePassesThroughThePlace()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {99, 71}, Qt::LeftButton, Qt::ShiftModifier);
        const auto size = hand.box().max - hand.box().min;
        QVERIFY(std::abs(size.x - size.y) < 1e-9);
        QVERIFY(std::abs(size.x - 50) < 1e-9 || std::abs(size.y - 40) < 1e-9);
    }
    void theMiddleStaysWithAlt()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {98.5, 70.5}, Qt::LeftButton, Qt::AltModifier);
        QVERIFY(hand.is({{30, 20}, {100, 70}}));
    }
    void theMarkerIsShownWhileItIsDragged()
    {
        Hand hand("ends");
        const QColor ground = ui::lookOf(hand.canvas->palette()).guideGround;
        const auto shown = [&] {
            const QImage picture = hand.picture();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (picture.pixelColor(x, y) == ground)
                        return true;
            return false;
        };
        hand.press({80, 60});
        hand.move({90, 62}, Qt::LeftButton);
        QVERIFY(!shown());
        hand.move({98.5, 69.5}, Qt::LeftButton);
        QVERIFY(shown()); // the name of the place
        hand.release({98.5, 69.5});
        QVERIFY(!shown());
    }
    void numbersChangeTheLastResizing()
    {
        Hand hand("ends");
        const app::Variant before = hand.session.variant();
        hand.drag({80, 60}, {90, 90});
        hand.type("40\t25\n");
        QVERIFY(hand.is({{50, 30}, {90, 55}}));
        hand.type("30\n"); // the height stays
        QVERIFY(hand.is({{50, 30}, {80, 55}}));
        QCOMPARE(hand.session.history.count(), 1);
        QCOMPARE(hand.session.variant(), before);
        hand.type("99");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(hand.is({{50, 30}, {80, 55}}));
        hand.canvas->undo();
        QVERIFY(hand.is({{50, 30}, {80, 60}}));
    }
    void numbersKeepWhatShiftAndAltMeant()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {95, 75}, Qt::LeftButton, Qt::ShiftModifier);
        hand.move({20, 20});
        hand.type("150%\n");
        QVERIFY(hand.is({{50, 30}, {95, 75}}));
        hand.canvas->undo();
        hand.drag({80, 45}, {95, 45}, Qt::LeftButton, Qt::AltModifier);
        hand.move({20, 20});
        hand.type("50\n");
        QVERIFY(hand.is({{40, 30}, {90, 60}}));
    }
    void theNextActionEndsTheCorrection()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {90, 90});
        hand.click({20, 20});
        hand.type("40");
        QVERIFY(hand.session.selection().empty());
        QCOMPARE(hand.session.history.index(), 1);
    }
    void nothingIsFlattened()
    {
        Hand hand("ends", {50, 90}); // its end is at the left side
        const QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.drag({80, 45}, {50.5, 90});
        QCOMPARE(refused.size(), 1);
        QVERIFY(hand.is({{50, 30}, {80, 60}}));
        QCOMPARE(hand.session.history.count(), 0);
    }
};

} // namespace tools_resize_test

TEST_CLASS(tools_resize_test::ResizeTest, Widgets)
#include "tests/ui/tools/resize_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/session/selection_frame.h"
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

    static void type(const char* text)
    {
        for (const char* c = text; *c; ++c)
            *c == '\t'   ? QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab)
            : *c == '\n' ? QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return)
                         : QTest::keyClick(QApplication::focusWidget(), *c);
    }

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
        clipping::Window box() const { return *session.selectionBounds(); }
        bool is(const clipping::Window& expected, double most = 1e-9) const
        {
            return near(box(), expected, most);
        }
    };

    /// A rectangle of 60 by 30, turned by 0.5, which is selected.
    struct TurnedHand : Stage {
        TurnedHand() : Stage(ui::Backend::Raster, {line({180, 80}, {180, 95})})
        {
            session.changeDisplay([](app::Display& display) { display.unit = app::Unit::User; });
            const app::Recipe recipe = app::RectangleRecipe{{60, 35}, {60, 30}, 0, 0.5};
            const app::Subpath outline = *app::outlineOf(recipe);
            app::DocumentBuilder builder;
            builder.open({.name = "Drawing"});
            app::Object turned{app::Path(std::span(&outline, 1)),
                               {.stroke = app::Colour{}, .width = 1}};
            turned.particulars.recipe = recipe;
            builder.add(turned);
            builder.add({app::Path(clipping::Segment{{180, 80}, {180, 95}}),
                         {.stroke = app::Colour{}, .width = 1}});
            builder.close();
            session.load({builder.take(session.now().page()), {}});
            canvas->setSnapping(app::SnapTo::Nothing);
            session.select({0});
        }
        app::WindowFrame frame() const { return *app::selectionFrame(session); }
        app::Point at(app::Handle handle) const
        {
            return app::outOfFrame(frame(), app::placeOf(handle, frame().box));
        }
        bool hasSides(const app::Point& sides) const
        {
            return glm::distance(frame().box.max - frame().box.min, sides) < 0.6;
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
        type("40\t25\n");
        QVERIFY(hand.is({{50, 30}, {90, 55}}));
        type("30\n"); // the height stays
        QVERIFY(hand.is({{50, 30}, {80, 55}}));
        QCOMPARE(hand.session.history.count(), 1);
        QCOMPARE(hand.session.variant(), before);
        type("99");
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
        type("150%\n");
        QVERIFY(hand.is({{50, 30}, {95, 75}}));
        hand.canvas->undo();
        hand.drag({80, 45}, {95, 45}, Qt::LeftButton, Qt::AltModifier);
        hand.move({20, 20});
        type("50\n");
        QVERIFY(hand.is({{40, 30}, {90, 60}}));
    }
    void theNextActionEndsTheCorrection()
    {
        Hand hand("ends");
        hand.drag({80, 60}, {90, 90});
        hand.click({20, 20});
        type("40");
        QVERIFY(hand.session.selection().empty());
        QCOMPARE(hand.session.history.index(), 1);
    }
    void aTurnedRectangleKeepsItsShapeAndItsTurn()
    {
        TurnedHand hand;
        const app::WindowFrame before = hand.frame();
        hand.drag(hand.at({1, 0}), hand.at({1, 0}) + app::turnedBy({20, 7}, before.angle));
        app::WindowFrame after = hand.frame(); // a side follows across itself only
        QCOMPARE(after.angle, before.angle);
        QVERIFY(hand.hasSides({80, 30}));
        QVERIFY(glm::distance(cornersOf(after)[0], cornersOf(before)[0]) < 1e-9);
        const app::Point fixed = hand.at({1, 1});
        hand.drag(hand.at({-1, -1}), hand.at({-1, -1}) + app::turnedBy({10, 5}, before.angle));
        QVERIFY(hand.hasSides({70, 25}));
        QVERIFY(glm::distance(hand.at({1, 1}), fixed) < 1e-9);
        QCOMPARE(hand.session.history.count(), 2);
        hand.canvas->undo();
        hand.canvas->undo();
        QCOMPARE(hand.frame(), before);
    }
    void aTurnedRectangleTakesNumbersOfItsOwnSides()
    {
        TurnedHand hand;
        hand.drag(hand.at({1, 1}), hand.at({1, 1}) + app::turnedBy({20, 20}, hand.frame().angle));
        type("40\t25\n");
        QVERIFY(hand.hasSides({40, 25}));
        hand.drag(hand.at({1, 1}), hand.at({1, 1}) + app::turnedBy({20, 12.5}, hand.frame().angle),
                  Qt::LeftButton, Qt::ShiftModifier);
        type("200%\n");
        QVERIFY(hand.hasSides({80, 50}));
    }
    void theSideOfATurnedRectanglePassesThroughThePlace()
    {
        TurnedHand hand;
        hand.canvas->setSnapping(app::SnapTo::Nothing.with("ends"));
        const app::Point end{180, 80};
        hand.drag(hand.at({1, 0}), end + app::Point(1, -0.5));
        const app::WindowFrame after = hand.frame();
        QVERIFY(std::abs(intoFrame(after, end).x - after.box.max.x) < 1e-9);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/document/recipe.h"

#include <QLabel>
#include <QLineEdit>
#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_shapes_test {

// Polygons, stars, rounded rectangles and freehand lines, with mouse and keys.
class ShapesTest : public QObject {
    Q_OBJECT

    struct ShapeHand : Hand {
        explicit ShapeHand(const char* tool) : Hand({}) { canvas.setTool(tool); }
        std::size_t count() { return session.now().objects().size(); }
        const app::Recipe& recipe(std::size_t object = 0)
        {
            return session.now().objects()[object].particulars().recipe;
        }
        std::size_t corners(std::size_t object = 0)
        {
            return paths(object).front().segments.size() + 1;
        }
        void stroke(const std::function<app::Point(double)>& curve)
        {
            press(curve(0));
            for (int i = 1; i <= 150; ++i)
                move(curve(i / 150.0), Qt::LeftButton);
            release(curve(1));
        }
    };
    static bool same(const app::Point& a, const app::Point& b)
    {
        return glm::distance(a, b) < 1e-9;
    }
    static app::Point wave(double t) { return {20 + 160 * t, 50 + 30 * std::sin(12 * t)}; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void polygonFromItsCentre()
    {
        ShapeHand hand("polygon");
        hand.drag({100, 50}, {130, 50});
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.corners(), std::size_t(6));
        QVERIFY(hand.path().closed && hand.isNear(hand.path().start, {130, 50}));
        QCOMPARE(hand.session.history.undoText(), QString("Draw polygon"));
        const auto* recipe = std::get_if<app::StarRecipe>(&hand.recipe());
        QVERIFY(recipe && recipe->points == 6 && hand.isNear(recipe->centre, {100, 50}));
    }
    void drawingDeselectsUntilItIsUndone()
    {
        ShapeHand hand("polygon");
        hand.drag({50, 50}, {60, 50});
        hand.session.select({0});
        hand.drag({100, 50}, {130, 50});
        QVERIFY(hand.session.selection().empty());
        hand.canvas.undo();
        QCOMPARE(hand.session.selection(), (app::ObjectRanges{0}));
    }
    void cornersAreTypedAndKept()
    {
        ShapeHand hand("polygon");
        hand.move({10, 10}, {});
        hand.type("100,50\n30");
        Hand::key(Qt::Key_Tab);
        hand.type("90");
        Hand::key(Qt::Key_Tab);
        hand.type("5\n");
        QCOMPARE(hand.corners(), std::size_t(5));
        QVERIFY(same(hand.path().start, {100, 20}));
        hand.type("12\n"); // the radius of what was just drawn
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.corners(), std::size_t(5));
        QVERIFY(same(hand.path().start, {100, 38}));
        hand.canvas.setTool("line");
        hand.canvas.setTool("polygon");
        hand.drag({50, 50}, {60, 50});
        QCOMPARE(hand.corners(1), std::size_t(5));
    }
    void arrowsChangeTheCorners()
    {
        ShapeHand hand("polygon");
        hand.click({100, 50});
        hand.move({130, 50}, {});
        Hand::key(Qt::Key_Up);
        Hand::key(Qt::Key_Up);
        Hand::key(Qt::Key_Down);
        hand.click({130, 50});
        QCOMPARE(hand.corners(), std::size_t(7));
        hand.click({50, 50});
        hand.move({60, 50}, {});
        for (int i = 0; i < 9; ++i)
            Hand::key(Qt::Key_Down);
        hand.click({60, 50});
        QCOMPARE(hand.corners(1), std::size_t(3));
    }
    void altLeadsToTheMiddleOfASide()
    {
        ShapeHand hand("polygon");
        hand.click({100, 50});
        hand.move({130, 50}, {}, Qt::AltModifier);
        hand.type("20");
        Hand::key(Qt::Key_Tab);
        hand.type("0\n");
        const app::Subpath path = hand.path();
        const app::Point side = (path.start + path.segments.back().to) * 0.5;
        QVERIFY(std::abs(side.x - std::get<app::StarRecipe>(hand.recipe()).centre.x - 20) < 1e-9);
    }
    void nonsenseIsRefusedAndTheGestureGoesOn()
    {
        for (const char* corners : {"2\n", "4.5\n", "1001\n", "abc\n"}) {
            ShapeHand hand("polygon");
            hand.click({100, 50});
            hand.move({130, 50}, {});
            for (int i = 0; i < 2; ++i)
                Hand::key(Qt::Key_Tab);
            hand.type(corners);
            QVERIFY2(hand.count() == 0, corners);
            auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
            QVERIFY(field);
            field->clear();
            hand.type("4\n");
            QCOMPARE(hand.corners(), std::size_t(4));
        }
    }
    void starHasAnInnerRadius()
    {
        for (const char* inner : {"40\n", "0.4\n", "40%\n"}) {
            ShapeHand hand("star");
            hand.move({10, 10}, {});
            hand.type("100,50\n30");
            for (const char* number : {"90", "7"}) {
                Hand::key(Qt::Key_Tab);
                hand.type(number);
            }
            Hand::key(Qt::Key_Tab);
            hand.type(inner);
            QCOMPARE(hand.count(), std::size_t(1));
            QCOMPARE(hand.corners(), std::size_t(14));
            QVERIFY(same(hand.path().start, {100, 20}));
            QVERIFY(std::abs(glm::distance(hand.path().segments[0].to, {100, 50}) - 12) < 1e-9);
        }
    }
    void shiftTurnsInSteps()
    {
        for (const char* tool : {"polygon", "star"}) {
            ShapeHand hand(tool);
            hand.drag({100, 50}, {130, 48}, Qt::ShiftModifier);
            const auto recipe = std::get<app::StarRecipe>(hand.recipe());
            QVERIFY(std::abs(recipe.turn) < 1e-9);
        }
    }
    void roundedCornersAreTypedAndKept()
    {
        ShapeHand hand("rectangle");
        hand.move({90, 90}, {});
        hand.type("20,20\n60");
        for (const char* number : {"40", "5"}) {
            Hand::key(Qt::Key_Tab);
            hand.type(number);
        }
        hand.type("\n");
        QCOMPARE(hand.count(), std::size_t(1));
        const app::Subpath path = hand.path();
        QCOMPARE(path.segments.size(), std::size_t(8));
        QVERIFY(same(path.start, {25, 20}) && same(path.segments[1].to, {80, 25}));
        QVERIFY(hand.recipe() == app::Recipe(app::RectangleRecipe{{20, 20}, {60, 40}, 5}));
        hand.type("60");
        for (int i = 0; i < 2; ++i)
            Hand::key(Qt::Key_Tab);
        hand.type("0\n"); // sharp again
        QCOMPARE(hand.corners(), std::size_t(4));
        QCOMPARE(hand.count(), std::size_t(1));
    }
    void theRadiusIsAtMostHalfASide()
    {
        ShapeHand hand("rectangle");
        hand.click({20, 20});
        hand.move({80, 40}, {});
        for (int i = 0; i < 2; ++i)
            Hand::key(Qt::Key_Tab);
        hand.type("99\n");
        const auto recipe = std::get<app::RectangleRecipe>(hand.recipe());
        QCOMPARE(recipe.radius, recipe.size.y / 2);
        const auto* hint = hand.t.window->statusBar()->findChild<QLabel*>();
        QVERIFY2(hint->text().contains("is kept"), qPrintable(hint->text()));
        QCOMPARE(hand.path().segments.size(), std::size_t(6)); // no sides of length 0
    }
    void freehandIsSmoothAndItsToleranceIsTypedAfterwards()
    {
        ShapeHand hand("pencil");
        hand.stroke(wave);
        QCOMPARE(hand.count(), std::size_t(1));
        const std::size_t nodes = hand.path().segments.size();
        QVERIFY(nodes <= 12);
        QVERIFY(hand.isNear(hand.path().start, wave(0)));
        QVERIFY(hand.isNear(hand.path().segments.back().to, wave(1)));
        hand.type("15\n");
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 1);
        QVERIFY(hand.path().segments.size() < nodes);
        hand.stroke(wave); // with the same tolerance
        QCOMPARE(hand.paths(1).front().segments.size(), hand.path().segments.size());
        hand.canvas.undo();
        hand.type("0\n");
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget())); // refused
    }
    void aVeryLongFreehandLineEndsAtOnce()
    {
        constexpr int points = 300'000;
        ShapeHand hand("pencil");
        const auto at = [](int i) {
            return app::Point(100 + 80 * std::cos(i * 0.01), 50 + 40 * std::sin(i * 0.0137));
        };
        hand.press(at(0));
        for (int i = 1; i < points; ++i)
            hand.move(at(i), Qt::LeftButton);
        QElapsedTimer clock;
        clock.start();
        hand.canvas.grab();
        const qint64 painting = clock.restart();
        hand.release(at(points));
        qInfo("%d points: painted in %lld ms, ended in %lld ms", points, painting, clock.elapsed());
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.path().segments.size() < points / 10);
        QString said;
        QObject::connect(&hand.session, &app::Session::refused, &hand.canvas,
                         [&said](const QString& sentence) { said = sentence; });
        hand.type("15\n"); // too long to be smoothed again; for the next line
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 1);
        QVERIFY2(said.contains(app::countText(100'000)), qPrintable(said));
    }
};

} // namespace tools_shapes_test

TEST_CLASS(tools_shapes_test::ShapesTest, Widgets)
#include "tests/ui/tools/shapes_test.moc"

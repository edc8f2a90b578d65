// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows are drawn, moved, resized and rotated by the tool Clip window, with the mouse and by
// numbers.
#include "app/document/window_shape.h"
#include "app/view/frame_handles.h"
#include "ui/bars/option_bar.h"
#include "ui/canvas/window_capsule.h"

#include <QAbstractButton>

#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_window_drawing_test {

namespace {

const app::RectangleShape hall{{{20, 20}, {80, 60}}};

/// A drawing of 200 by 100 with one clip window.
struct Drawer : Hand {
    explicit Drawer(const app::WindowShape& shape = hall) : Hand({::shape({corner()})})
    {
        session.document.apply({.windows = app::ClipWindows{{{.name = "Hall", .shape = shape}}}});
        key(Qt::Key_W);
    }
    const std::vector<app::ClipWindow>& list() { return session.now().windows().list; }
    const app::WindowShape& last() { return list().back().shape; }
    app::StarRecipe lastStar()
    {
        return std::get<app::StarRecipe>(std::get<app::PathShape>(last()).recipe);
    }
    app::RectangleShape first() { return std::get<app::RectangleShape>(list()[0].shape); }
    app::Point firstSize() { return first().box.max - first().box.min; }
    /// Clicks a button of the tool's options.
    void choose(const char* group, int button)
    {
        const auto buttons = t.window->findChild<QWidget*>(group)->findChildren<QAbstractButton*>();
        QTest::mouseClick(buttons[button], Qt::LeftButton);
    }
    /// Presses, and moves on with the button down.
    void pull(app::Point from, app::Point to, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&surface(), Qt::LeftButton, modifiers, at(from));
        move((from + to) * 0.5, Qt::LeftButton, modifiers);
        move(to, Qt::LeftButton, modifiers);
    }
    bool isNearBox(const clipping::Window& a, const clipping::Window& b)
    {
        const double pixels = 2 / canvas.view().zoom; // of the press, the release, the drawing
        return glm::distance(a.min, b.min) < pixels && glm::distance(a.max, b.max) < pixels;
    }
};

bool same(const app::Point& a, const app::Point& b) { return glm::distance(a, b) < 1e-9; }

} // namespace

class WindowDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void theOptionsOfTheToolReplaceThoseOfTheStroke()
    {
        Drawer d;
        auto* shapes = d.t.window->findChild<QWidget*>("window-shapes");
        auto* style = d.t.window->findChild<ui::OptionBar*>()->findChild<QWidget*>("style");
        QTRY_VERIFY(shapes->isVisible() && !style->isVisible());
        d.key(Qt::Key_L);
        QTRY_VERIFY(!shapes->isVisible() && style->isVisible());
    }
    void aDragBesideTheWindowsAddsOne()
    {
        Drawer d;
        d.drag({100, 20}, {150, 60});
        QCOMPARE(d.list().size(), 2u);
        QVERIFY(d.isNearBox(app::boxOf(d.last()), {{100, 20}, {150, 60}}));
        QVERIFY(d.first() == hall);
        QCOMPARE(d.session.windowNumber(), std::optional<std::size_t>(1));
        QCOMPARE(d.session.history.undoText(), "Draw clip window");
        d.drag({120, 40}, {130, 50}); // inside the new one: it moves
        QCOMPARE(d.list().size(), 2u);
        QVERIFY(d.isNearBox(app::boxOf(d.last()), {{110, 30}, {160, 70}}));
        d.key(Qt::Key_Z, Qt::ControlModifier);
        d.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(d.list().size(), 1u);
        QCOMPARE(d.session.windowNumber(), std::optional<std::size_t>(0));
    }
    void everyShapeIsDrawn()
    {
        Drawer d;
        d.choose("window-shapes", 1);
        d.drag({100, 20}, {150, 60}, Qt::ShiftModifier);
        const auto circle = std::get<app::EllipseRecipe>(std::get<app::PathShape>(d.last()).recipe);
        QVERIFY(std::abs(circle.radii.x - circle.radii.y) < 1e-9
                && std::abs(circle.radii.x - 25) < 0.5);
        d.choose("window-shapes", 2);
        d.drag({180, 30}, {180, 45});
        QCOMPARE(d.lastStar().points, 6);
        QCOMPARE(d.lastStar().inner, 0.0);
        d.choose("window-shapes", 3);
        d.drag({180, 80}, {180, 65});
        QVERIFY(d.lastStar().inner > 0 && d.isNear(d.lastStar().centre, {180, 80}));
        QCOMPARE(d.list().size(), 4u);
    }
    void cornersAreSetByUpAndDownAndByNumber()
    {
        Drawer d;
        d.choose("window-shapes", 2);
        d.pull({140, 50}, {160, 50});
        d.key(Qt::Key_Up);
        d.key(Qt::Key_Up);
        d.release({160, 50});
        QCOMPARE(d.lastStar().points, 8);
        d.pull({100, 90}, {110, 90});
        d.type("5\t90\t3\n");
        d.release({110, 90});
        QCOMPARE(d.list().size(), 3u);
        QCOMPARE(d.lastStar().points, 3);
        QVERIFY(std::abs(d.lastStar().outer - 5) < 1e-9);
    }
    void aPolygonIsDrawnCornerByCorner()
    {
        Drawer d;
        d.choose("window-shapes", 4);
        for (const app::Point& p : {app::Point(100, 20), {150, 20}, {125, 40}, {150, 60}})
            d.click(p);
        QCOMPARE(d.list().size(), 1u);
        QCOMPARE(d.session.windows().list.size(), 2u); // it is shown, and cuts
        d.key(Qt::Key_Z, Qt::ControlModifier);         // one corner back
        d.click({150, 70});
        d.click({100, 20}); // the first corner
        QCOMPARE(d.list().size(), 2u);
        const auto polygon = std::get<app::PathShape>(d.last());
        const auto ring = polygon.path.subpaths().front();
        QVERIFY(ring.closed);
        QCOMPARE(ring.segments.size(), 3u);
        QVERIFY(d.isNear(ring.segments.back().to, {150, 70}));
        QCOMPARE(d.session.history.count(), 1);
        for (const app::Point& p : {app::Point(170, 20), {190, 20}, {180, 40}})
            d.click(p);
        d.key(Qt::Key_Return);
        QCOMPARE(d.list().size(), 3u);
        d.click({170, 60});
        d.click({190, 60});
        d.key(Qt::Key_Return); // two corners enclose nothing
        QCOMPARE(d.list().size(), 3u);
        QVERIFY(d.t.window->message().contains("at least three corners"));
        QCOMPARE(d.session.windowNumber(), std::optional<std::size_t>(2));
    }
    void aHoleBeginsInsideAWindow()
    {
        Drawer d;
        const auto visible = [&] {
            return visibleIn(d.session.scene.lines(), d.session.region(), d.session.variant());
        };
        QCOMPARE(visible(), 1u); // the line from (20, 20) to (100, 20)
        d.drag({15, 15}, {85, 30});
        QTest::keyClick(&d.surface(), '-');
        QCOMPARE(d.list().size(), 2u);
        QCOMPARE(d.list()[1].operation, app::WindowOperation::CutOut);
        QCOMPARE(visible(), 0u);
        d.drag({50, 40}, {60, 50}, Qt::AltModifier); // begins in the hall, from its middle
        QCOMPARE(d.list().size(), 3u);
        QVERIFY(d.isNearBox(app::boxOf(d.last()), {{40, 30}, {60, 50}}));
        d.drag({55, 45}, {65, 50}); // without Alt it moves
        QCOMPARE(d.list().size(), 3u);
        QVERIFY(d.isNearBox(app::boxOf(d.last()), {{50, 35}, {70, 55}}));
    }
    void whenAltIsLetGoItIsDrawnFromItsCorner()
    {
        Drawer d;
        QTest::mousePress(&d.surface(), Qt::LeftButton, Qt::AltModifier, d.at({50, 40}));
        d.move({55, 45}, Qt::LeftButton, Qt::AltModifier);
        d.move({60, 50}, Qt::LeftButton);
        d.release({60, 50});
        QCOMPARE(d.list().size(), 2u);
        QVERIFY(d.isNearBox(app::boxOf(d.last()), {{50, 40}, {60, 50}}));
        d.type("\n40\t10\n"); // Enter opens the numbers: a digit would choose the algorithm
        const clipping::Window box = app::boxOf(d.last());
        QVERIFY(same(box.max - box.min, {40, 10}));
        QTest::keyClick(&d.surface(), '=');
        QCOMPARE(d.list()[1].operation, app::WindowOperation::Replace);
        QCOMPARE(d.session.region().steps.size(), 1u);
        d.drag({100, 20}, {150, 60}); // the next one adds
        QCOMPARE(d.session.region().steps.size(), 2u);
        QCOMPARE(d.list()[0].name, "Hall");
    }
    void aClickBesideTheWindowsDoesNothing()
    {
        Drawer d;
        d.click({120, 50});
        d.move({140, 70}, Qt::NoButton);
        QCOMPARE(d.session.windows().list.size(), 1u);
        d.click({140, 70});
        QCOMPARE(d.session.history.count(), 0);
    }
    void escGivesUp()
    {
        Drawer d;
        d.pull({100, 20}, {150, 60});
        QCOMPARE(d.session.windows().list.size(), 2u);
        d.key(Qt::Key_Escape);
        d.release({150, 60});
        QCOMPARE(d.session.windows().list.size(), 1u);
        QCOMPARE(d.session.windowNumber(), std::optional<std::size_t>(0));
        QCOMPARE(d.session.history.count(), 0);
    }
    void aWindowIsDrawnByNumbers()
    {
        Drawer d;
        d.pull({100, 20}, {130, 50});
        d.type("12.5\t30\n");
        d.release({130, 50});
        const clipping::Window box = app::boxOf(d.last());
        QVERIFY(same(box.max - box.min, {12.5, 30}));
        const auto* before = d.session.display().variant.algorithm;
        d.type("\n20\n"); // until something else happens, Enter opens the numbers
        QVERIFY(same(app::boxOf(d.last()).max - app::boxOf(d.last()).min, {20, 30}));
        QCOMPARE(d.session.display().variant.algorithm, before);
        d.key(Qt::Key_Z, Qt::ControlModifier);
        d.type("\n2"); // now Enter opens nothing, and the digit chooses the algorithm
        QVERIFY(d.session.display().variant.algorithm != before);
    }
    void aWindowBeginsAtATypedPoint()
    {
        Drawer d;
        d.move({10, 90}, Qt::NoButton);
        d.type("#100,30\n12.5\t30\n");
        QCOMPARE(d.list().size(), std::size_t(2));
        const clipping::Window box = app::boxOf(d.last());
        QVERIFY(same(box.min, {100, 30}) && same(box.max, {112.5, 60}));
        d.type("#10,70\n20\t10\n"); // not a number of the one before
        QCOMPARE(d.list().size(), std::size_t(3));
        QVERIFY(same(app::boxOf(d.last()).min, {10, 70}));
    }
    void enterIsForTheCapsuleOfTheChosenWindow()
    {
        Drawer d;
        QTRY_VERIFY(d.canvas.findChild<ui::WindowCapsule*>()->isVisible());
        d.surface().setFocus();
        d.key(Qt::Key_Return);
        QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("capsule-width"));
        d.type("33\n");
        QCOMPARE(d.firstSize().x, 33.0);
    }
    void aMoveTakesNumbers()
    {
        Drawer d;
        d.pull({50, 40}, {60, 43});
        d.type("10,5\n");
        d.release({60, 43});
        QVERIFY(same(d.first().box.min, hall.box.min + app::Point(10, 5)));
        QVERIFY(same(d.firstSize(), {60, 40}));
        QCOMPARE(d.session.history.count(), 1);
    }
    void aHandleTakesWidthAndHeight()
    {
        Drawer d;
        d.pull({80, 60}, {90, 75});
        d.type("50\t25\n");
        d.release({90, 75});
        QVERIFY(d.first() == (app::RectangleShape{{{20, 20}, {70, 45}}}));
        d.pull({70, 32.5}, {75, 32.5}); // the right side
        d.type("62.5\n");
        d.release({75, 32.5});
        QVERIFY(d.first() == (app::RectangleShape{{{20, 20}, {82.5, 45}}}));
    }
    void aRotatedWindowIsMeasuredAlongItsSides()
    {
        Drawer d;
        const double above = app::rotationHandleAbove / d.canvas.view().zoom;
        d.pull({50, 20 - above}, {60, 20 - above});
        d.type("30\n");
        d.release({60, 20 - above});
        QVERIFY(std::abs(d.first().angle + M_PI / 6) < 1e-12); // counterclockwise
        const app::Point corner = app::cornersOf(d.first())[2],
                         fixed = app::cornersOf(d.first())[0];
        d.pull(corner, corner + app::Point(5, 3));
        d.type("70\t30\n");
        d.release(corner + app::Point(5, 3));
        QVERIFY(same(d.firstSize(), {70, 30}));
        QVERIFY(same(app::cornersOf(d.first())[0], fixed));
        QVERIFY(std::abs(d.first().angle + M_PI / 6) < 1e-12);
    }
    void aRotatedWindowSnapsByItsCorners()
    {
        app::RectangleShape turned = hall;
        turned.angle = M_PI / 4;
        Drawer d(turned);
        d.canvas.setSnapping(app::SnapTo::Nothing.with("window"));
        auto windows = d.session.now().windows();
        windows.list.push_back({.shape = app::RectangleShape{{{120, 30}, {180, 95}}}});
        d.session.document.apply({.windows = windows});
        const app::Point right = app::cornersOf(turned)[1]; // the rightmost is [1] or [2]
        const app::Point corner =
            right.x > app::cornersOf(turned)[2].x ? right : app::cornersOf(turned)[2];
        const app::Point by = app::Point(120, 30) - corner;
        d.drag({50, 40}, app::Point(50, 40) + by + app::Point(0.6, 0.4));
        const auto now = app::cornersOf(d.first());
        QVERIFY(std::ranges::any_of(
            now, [](const app::Point& p) { return same(p, app::Point(120, 30)); }));
    }
};

} // namespace tools_window_drawing_test

TEST_CLASS(tools_window_drawing_test::WindowDrawingTest, Widgets)
#include "tests/ui/tools/window_drawing_test.moc"

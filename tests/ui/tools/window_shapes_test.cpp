// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows of several shapes under the mouse and in their panel.
#include "app/document/recipe_outline.h"
#include "app/document/window_outline.h"
#include "app/document/window_shape.h"
#include "app/view/frame_handles.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QToolButton>

#include "tests/ui/tools/hand.h"

namespace {

app::PathShape circle()
{
    const app::EllipseRecipe recipe{{140, 50}, {30, 30}};
    const auto outline = app::outlineOf(app::Recipe(recipe));
    return {app::Path({&*outline, 1}), app::FillRule::NonZero, recipe};
}

struct Windows : Hand {
    Windows() : Hand({shape({corner()})})
    {
        session.document.apply(
            {.windows = app::ClipWindows{
                 {{.name = "Hall", .shape = app::RectangleShape{{{20, 30}, {80, 70}}}},
                  {.name = "Dome",
                   .shape = circle(),
                   .operation = app::WindowOperation::CutOut}}}});
        key(Qt::Key_W);
        list = t.window->findChild<QListView*>("clip-windows");
    }
    const app::ClipWindow& window(std::size_t i) { return session.now().windows().list[i]; }
    QPoint row(int i, int x)
    {
        return {x, list->visualRect(list->model()->index(i, 0)).center().y()};
    }
    void clickRow(int i, int x = 120)
    {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, row(i, x));
    }
    QListView* list;
};

} // namespace

class WindowShapesTest : public QObject {
    Q_OBJECT

private slots:
    void aClickChoosesAWindowAndADragMovesIt()
    {
        Windows w;
        QTRY_COMPARE(w.list->currentIndex().row(), 0);
        w.click({140, 50});
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(1));
        QTRY_COMPARE(w.list->currentIndex().row(), 1);
        QCOMPARE(w.session.history.count(), 0);
        w.drag({140, 50}, {150, 55});
        QCOMPARE(w.session.history.count(), 1);
        const auto moved = std::get<app::PathShape>(w.window(1).shape);
        const auto ellipse = std::get<app::EllipseRecipe>(moved.recipe);
        QVERIFY(w.isNear(ellipse.centre, {150, 55}) && ellipse.radii == app::Point(30, 30));
        QVERIFY(w.window(0).shape == app::WindowShape(app::RectangleShape{{{20, 30}, {80, 70}}}));
        w.drag({115, 25}, {120, 30}); // in the circle's box, but outside it: a window is drawn
        QVERIFY(std::holds_alternative<app::RectangleShape>(w.window(1).shape));
        QCOMPARE(w.window(1).name, "Dome");
    }
    void theHandleAboveRotates()
    {
        Windows w;
        const app::Point middle(50, 50);
        const double above = app::rotationHandleAbove / w.canvas.view().zoom;
        w.drag({50, 30 - above}, {50 + 20 + above, 50});
        QCOMPARE(w.session.history.undoText(), "Rotate clip window");
        const auto turned = std::get<app::RectangleShape>(w.window(0).shape);
        QVERIFY(std::abs(turned.angle - M_PI / 2) < 0.02);
        const auto box = app::boxOf(turned);
        QVERIFY(glm::distance((box.min + box.max) * 0.5, middle) < 1e-9);
        // The rotated window has handles of its own: the right side is at the bottom now.
        w.drag({50, 80}, {50, 90});
        const auto longer = std::get<app::RectangleShape>(w.window(0).shape);
        QVERIFY(std::abs(longer.box.max.x - longer.box.min.x - 70) < 1.5);
        QCOMPARE(longer.angle, turned.angle);
        w.key(Qt::Key_Z, Qt::ControlModifier);
        w.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w.window(0).shape == app::WindowShape(app::RectangleShape{{{20, 30}, {80, 70}}}));
    }
    void whatIsVisibleFollowsTheShapes()
    {
        Windows w; // the corner runs (20, 20), (100, 20), (100, 80)
        const auto visible = [&] {
            return w.session.scene.clip(w.session.region(), w.session.variant()).visible;
        };
        QCOMPARE(visible(), 0u);
        w.session.select({0});
        w.drag({50, 50}, {50, 30}); // the hall now covers a part of the first line
        QCOMPARE(visible(), 1u);
        w.clickRow(1);
        QTRY_COMPARE(w.list->currentIndex().row(), 1);
        QTest::keyClick(w.list, Qt::Key_Delete);
        QCOMPARE(w.session.now().windows().list.size(), 1u);
    }
    void theListHidesRenamesAndReorders()
    {
        Windows w;
        w.clickRow(0, 16); // the eye
        QVERIFY(!w.window(0).visible);
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(1));
        w.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(w.window(0).visible);
        w.clickRow(1);
        w.list->setFocus();
        QTest::keyClick(w.list, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(w.window(0).name, "Dome");
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(0));
        w.clickRow(0);
        QTRY_COMPARE(w.list->currentIndex().row(), 0);
        QTest::mouseDClick(w.list->viewport(), Qt::LeftButton, {}, w.row(0, 120));
        QTRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        QTest::keyClicks(QApplication::focusWidget(), "Kuppel");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(w.window(0).name, "Kuppel");
    }
    void aWindowOfTheSelectionIsAdded()
    {
        Windows w;
        w.session.select({0});
        auto* add = w.t.window->findChild<QToolButton*>("add-window");
        QCOMPARE(add->menu()->actions().size(), 6); // four kinds, a separator, the selection
        emit add->menu()->aboutToShow();
        add->menu()->actions().back()->trigger();
        QCOMPARE(w.session.now().windows().list.size(), 3u);
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(2));
        const auto corner = std::get<app::PathShape>(w.window(2).shape);
        QVERIFY(corner.path == w.session.now().objects()[0].path());
    }
};

QTEST_MAIN(WindowShapesTest)
#include "window_shapes_test.moc"

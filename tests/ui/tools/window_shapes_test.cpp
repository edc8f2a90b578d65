// SPDX-License-Identifier: GPL-3.0-or-later
// Clip windows of several shapes under the mouse and in their panel.
#include "app/document/recipe_outline.h"
#include "app/document/window_outline.h"
#include "app/document/window_shape.h"
#include "app/formats/coordinates.h"
#include "app/session/window_steps.h"
#include "app/view/frame_handles.h"
#include "ui/docks/window_model.h"
#include "ui/docks/window_panel.h"
#include "ui/widgets/length_field.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QToolButton>

#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_window_shapes_test {

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
    /// Drags a row by its dots to the place of another.
    void dragRow(int from, int to)
    {
        const QPoint end = row(to, 6) + QPoint(0, to > from ? 8 : to < from ? -8 : 4);
        QTest::mousePress(list->viewport(), Qt::LeftButton, {}, row(from, 6));
        for (const QPoint& p : {(row(from, 6) + end) / 2, end}) {
            QMouseEvent event(QEvent::MouseMove, p, list->viewport()->mapToGlobal(p), Qt::NoButton,
                              Qt::LeftButton, {});
            QApplication::sendEvent(list->viewport(), &event);
        }
        QTest::mouseRelease(list->viewport(), Qt::LeftButton, {}, end);
    }
    QListView* list;
};

} // namespace

class WindowShapesTest : public QObject {
    Q_OBJECT

private slots:
    void deleteRemovesTheChosenWindow()
    {
        Windows windows;
        windows.clickRow(1);
        windows.canvas.setFocus();
        windows.key(Qt::Key_Delete);
        QCOMPARE(windows.session.now().windows().list.size(), std::size_t(1));
        QCOMPARE(windows.window(0).name, QStringLiteral("Hall"));
        // With Select, the objects are meant; none is selected.
        windows.key(Qt::Key_V);
        windows.session.select({});
        QVERIFY(!windows.t.action("delete")->isEnabled());
        windows.key(Qt::Key_Delete);
        QCOMPARE(windows.session.now().windows().list.size(), std::size_t(1));
    }
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
        w.drag({115, 12}, {118, 22}); // beside all windows: one more is drawn
        QCOMPARE(w.session.now().windows().list.size(), 3u);
        QVERIFY(std::holds_alternative<app::RectangleShape>(w.window(2).shape));
        QVERIFY(std::holds_alternative<app::PathShape>(w.window(1).shape));
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(2));
    }
    void aWindowOfAnotherShapeIsResizedByItsHandles()
    {
        Windows w;
        w.clickRow(1);
        w.drag({170, 50}, {180, 50});
        const auto wider = std::get<app::PathShape>(w.window(1).shape);
        QVERIFY(w.isNear(app::boxOf(wider).max, {180, 80}));
        QVERIFY(w.isNear(app::boxOf(wider).min, {110, 20}));
        w.drag({114, 24}, {118, 26}); // in the corner of its frame: one more is drawn
        QCOMPARE(w.session.now().windows().list.size(), 3u);
        QVERIFY(w.window(1).shape == app::WindowShape(wider));
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
            return visibleIn(w.session.scene.lines(), w.session.region(), w.session.variant());
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
    void aRowIsDraggedAsSoonAsThePointerIsFarEnough()
    {
        Windows w;
        const int usual = QApplication::startDragDistance();
        for (const int far : {1, 0}) { // a pixel less is a click
            const QPoint from = w.row(0, 6) + QPoint(0, 6), to = w.row(1, 6) + QPoint(0, 6);
            QApplication::setStartDragDistance(to.y() - from.y() + far);
            QTest::mousePress(w.list->viewport(), Qt::LeftButton, {}, from);
            QMouseEvent event(QEvent::MouseMove, to, w.list->viewport()->mapToGlobal(to),
                              Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(w.list->viewport(), &event);
            QTest::mouseRelease(w.list->viewport(), Qt::LeftButton, {}, to);
            QCOMPARE(w.window(0).name, far ? "Hall" : "Dome");
        }
        QApplication::setStartDragDistance(usual);
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
        w.key(Qt::Key_Z, Qt::ControlModifier);
        w.dragRow(0, 1);
        QCOMPARE(w.window(0).name, "Dome");
        QCOMPARE(w.session.history.undoText(), "Reorder clip windows");
        QTRY_COMPARE(w.list->currentIndex().row(), 1); // the dragged row stays the current one
        w.dragRow(1, 1);
        QCOMPARE(w.window(1).name, "Hall"); // it was dropped where it was
        w.clickRow(0);
        QTRY_COMPARE(w.list->currentIndex().row(), 0);
        QTest::mouseDClick(w.list->viewport(), Qt::LeftButton, {}, w.row(0, 120));
        QTRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        QTest::keyClicks(QApplication::focusWidget(), "Kuppel");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(w.window(0).name, "Kuppel");
    }
    void thePanelSaysWhatTheWindowsMakeTogether()
    {
        Windows w;
        auto* panel = w.t.window->findChild<ui::WindowPanel*>();
        const auto says = [&](const char* text) {
            return panel->title() == QString::fromUtf8(text);
        };
        QVERIFY(says("Hall − Dome"));
        const auto sides = panel->findChild<QWidget*>("keep")->findChildren<QAbstractButton*>();
        QTest::mouseClick(sides[1], Qt::LeftButton);
        QCOMPARE(w.session.now().windows().keep, app::Keep::Outside);
        w.clickRow(0, 16); // the eye
        QVERIFY(says("all but everything − Dome"));
    }
    void aClickOnTheSignChoosesWhatAWindowDoes()
    {
        Windows w;
        w.clickRow(1, 40); // the sign
        auto* menu = w.t.window->findChild<QMenu*>("window-operations");
        QVERIFY(menu && menu->isVisible());
        QVERIFY(menu->actions()[1]->isChecked()); // "Dome" cuts out
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(menu->actions()[2]).center());
        QCOMPARE(w.window(1).operation, app::WindowOperation::Intersect);
        QCOMPARE(w.session.history.undoText(), QStringLiteral("Intersect with Dome"));
    }
    void whatIsReplacedSaysSo()
    {
        Windows w;
        w.clickRow(0, 40); // the sign of the first
        auto* menu = w.t.window->findChild<QMenu*>("window-operations");
        for (const QAction* action : menu->actions())
            QCOMPARE(action->isEnabled(), menu->actions().indexOf(action) < 2);
        QCOMPARE(menu->actions()[3]->toolTip(), "No clip window is above Hall.");
        delete menu;
        w.clickRow(1, 40);
        menu = w.t.window->findChild<QMenu*>("window-operations");
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(menu->actions()[3]).center());
        QCOMPARE(w.window(1).operation, app::WindowOperation::Replace);
        QCOMPARE(w.session.history.undoText(), QStringLiteral("Replace with Dome"));
        const QModelIndex hall = w.list->model()->index(0, 0);
        QCOMPARE(hall.data(ui::WindowModel::CountsRole).toBool(), false);
        QCOMPARE(hall.data(Qt::ToolTipRole).toString(),
                 QStringLiteral("without effect: Dome replaces it"));
        QCOMPARE(w.list->model()->index(1, 0).data(ui::WindowModel::CountsRole).toBool(), true);
        w.session.history.undo();
        QCOMPARE(hall.data(ui::WindowModel::CountsRole).toBool(), true);
    }
    // None is offered: a file may bring one.
    void theColourOfAWindowIsShown()
    {
        Windows w;
        app::changeWindow(w.session, 0, {}, [](app::ClipWindow& window) {
            window.colour = app::Colour{0, 128, 128};
        });
        w.canvas.settle();
        const QImage picture = w.surface().grab().toImage();
        const QPoint edge = w.at({20, 42}); // on its left side, between two handles
        bool teal = false;
        for (int x = -3; x <= 3; ++x) {
            const QColor pixel = picture.pixelColor(edge + QPoint(x, 0));
            teal |= pixel.red() < 100 && pixel.green() > 100 && pixel.blue() > 100;
        }
        QVERIFY(teal);
    }
    void anAngleIsTyped()
    {
        Windows w;
        const auto fields =
            w.t.window->findChild<ui::WindowPanel*>()->findChildren<ui::LengthField*>();
        auto* angle = *std::ranges::find(fields, "Angle", &QWidget::accessibleName);
        angle->setFocus();
        angle->selectAll();
        QTest::keyClicks(angle, "30");
        QTest::keyClick(angle, Qt::Key_Return);
        const auto turned = std::get<app::RectangleShape>(w.window(0).shape);
        QVERIFY(std::abs(turned.angle + M_PI / 6) < 1e-12);
        QCOMPARE(w.session.history.undoText(), "Rotate clip window");
    }
    void numbersCorrectADrawnWindow()
    {
        Windows w;
        w.key(Qt::Key_W);
        w.drag({88, 2}, {108, 18});
        const int steps = w.session.history.index();
        const std::size_t drawn = w.session.now().windows().list.size() - 1;
        const auto size = [&] {
            const auto box = std::get<app::RectangleShape>(w.window(drawn).shape).box;
            return box.max - box.min;
        };
        const double height = size().y;
        w.type("\n50\n");
        QVERIFY(glm::distance(size(), app::Point(50, height)) < 1e-9);
        w.type("\n44\t30\n"); // again, both numbers
        QVERIFY(glm::distance(size(), app::Point(44, 30)) < 1e-9);
        QCOMPARE(w.session.history.index(), steps);
        w.type("\n9");
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        w.key(Qt::Key_Escape); // gives up the correction
        w.key(Qt::Key_Escape);
        QVERIFY(glm::distance(size(), app::Point(44, 30)) < 1e-9);
        QCOMPARE(w.session.windowNumber(), std::optional(drawn));
        w.key(Qt::Key_Right); // something else: Enter opens nothing
        const auto* before = w.session.display().variant.algorithm;
        w.type("\n2");
        QVERIFY(w.session.display().variant.algorithm != before);
        QVERIFY(glm::distance(size(), app::Point(44, 30)) < 1e-9);
    }
    void aWindowIsLaidInsideTheMargin()
    {
        Windows w;
        w.t.action("window-inside-margin")->trigger();
        auto* dialog = w.t.window->findChild<QDialog*>("margin-dialog");
        QVERIFY(dialog && dialog->isVisible());
        auto* margin = dialog->findChild<ui::LengthField*>();
        margin->selectAll();
        QTest::keyClicks(margin, "15");
        QTest::keyClick(margin, Qt::Key_Return);
        if (dialog->isVisible()) // Enter in the field may leave it to the button
            QTest::keyClick(dialog, Qt::Key_Return);
        QCOMPARE(w.session.now().windows().list.size(), 3u);
        QVERIFY(w.window(2).shape == app::WindowShape(app::RectangleShape{{{15, 15}, {185, 85}}}));
    }
    void fourMarginsMayDiffer()
    {
        Windows w;
        w.t.action("window-inside-margin")->trigger();
        auto* dialog = w.t.window->findChild<QDialog*>("margin-dialog");
        QTest::mouseClick(dialog->findChild<QCheckBox*>(), Qt::LeftButton, {}, {8, 8});
        const char* margins[]{"1", "2", "3", "4"}; // left, top, right, bottom
        for (int i = 0; i < 4; ++i) {
            auto* field = dialog->findChildren<ui::LengthField*>()[i];
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, margins[i]);
            QFocusEvent leaves(QEvent::FocusOut, Qt::TabFocusReason); // no focus without a screen
            QApplication::sendEvent(field, &leaves);
        }
        dialog->accept();
        const auto box = std::get<app::RectangleShape>(w.window(2).shape).box;
        QCOMPARE(app::rectangleText(box), "1,2,197,96");
    }
    void marginsThatLeaveNothingStayInTheDialog()
    {
        Windows w;
        w.t.action("window-inside-margin")->trigger();
        auto* dialog = w.t.window->findChild<QDialog*>("margin-dialog");
        auto* margin = dialog->findChild<ui::LengthField*>();
        margin->selectAll();
        QTest::keyClicks(margin, "150");
        QTest::keyClick(margin, Qt::Key_Return);
        dialog->accept();
        QVERIFY(dialog->isVisible());
        QVERIFY(std::ranges::any_of(dialog->findChildren<QLabel*>(), [](const QLabel* label) {
            return label->text() == "The margins leave nothing of the page. Type smaller ones.";
        }));
        QCOMPARE(w.session.now().windows().list.size(), 2u);
    }
    void aWindowOfTheSelectionIsAdded()
    {
        Windows w;
        w.session.select({0});
        auto* add = w.t.window->findChild<QToolButton*>("add-window");
        // Four shapes, three places, the page inside a margin, the selection; two separators.
        QCOMPARE(add->menu()->actions().size(), 11);
        emit add->menu()->aboutToShow();
        add->menu()->actions().back()->trigger();
        QCOMPARE(w.session.now().windows().list.size(), 3u);
        QCOMPARE(w.session.windowNumber(), std::optional<std::size_t>(2));
        const auto corner = std::get<app::PathShape>(w.window(2).shape);
        QVERIFY(corner.path == w.session.now().objects()[0].path());
    }
};

} // namespace tools_window_shapes_test

TEST_CLASS(tools_window_shapes_test::WindowShapesTest, Widgets)
#include "tests/ui/tools/window_shapes_test.moc"

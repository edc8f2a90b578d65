// SPDX-License-Identifier: GPL-3.0-or-later
// Panes side by side share the view and the gesture; each has its own algorithm.
#include "app/session/comparing.h"

#include <QMenu>
#include <QSignalSpy>

#include "tests/app/document/sheet_edits.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/pane_stage.h"

namespace canvas_panes_test {

class PanesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { ui::applyTheme(*qApp, ui::Theme::Light); }

    void panesOfEqualSizeShowTheSame()
    {
        const std::size_t all = clipping::algorithms().size() + 1; // Panes::showAll
        for (const std::size_t count : {std::size_t(2), std::size_t(4), all}) {
            PaneStage stage(1);
            stage.canvas->resize(1001, 803);
            stage.show(count);
            QCOMPARE(stage.count(), count);
            const QRect window = stage.orange(1);
            QVERIFY(window.width() > 40);
            for (std::size_t i = 0; i < count; ++i) {
                QVERIFY(stage.pane(i).isVisible());
                QCOMPARE(stage.pane(i).size(), stage.pane(0).size());
                QCOMPARE(stage.pane(i).size(),
                         QSize(int(stage.canvas->view().size.x), int(stage.canvas->view().size.y)));
                if (i > 0) // the active one has handles, and a label, as well
                    QCOMPARE(stage.orange(i), window);
            }
        }
    }
    // During the gesture, not only at its end.
    void panesFollowAnyGesture_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<int>("button");
        QTest::newRow("pan") << "select" << int(Qt::MiddleButton);
        QTest::newRow("hand") << "hand" << int(Qt::LeftButton);
        QTest::newRow("window") << "window" << int(Qt::LeftButton);
    }
    void panesFollowAnyGesture()
    {
        QFETCH(QString, tool);
        QFETCH(int, button);
        PaneStage stage(4);
        stage.canvas->setTool(tool.toStdString());
        const auto hold = Qt::MouseButton(button);
        const QRect before = stage.orange(1);
        const QPointF from = stage.at({100, 50}), by(17, 11);
        stage.send(2, QEvent::MouseMove, from, Qt::NoButton);
        stage.send(2, QEvent::MouseButtonPress, from, hold);
        stage.send(2, QEvent::MouseMove, from + by / 2, hold);
        stage.send(2, QEvent::MouseMove, from + by, hold);
        QCOMPARE(stage.canvas->panes().active(), std::size_t(2));
        QCOMPARE(stage.session.history.count(), 0);
        QCOMPARE(stage.orange(0).center(),
                 before.center() + by.toPoint()); // it may be highlighted, and thicker then
        QCOMPARE(stage.orange(1), stage.orange(0));
        QCOMPARE(stage.orange(3), stage.orange(0));
        stage.send(2, QEvent::MouseButtonRelease, from + by, hold);
        stage.send(2, QEvent::MouseMove, {2, 2}, Qt::NoButton);
        for (const std::size_t i : {0, 1, 3})
            QCOMPARE(stage.orange(i), before.translated(by.toPoint()));
        QCOMPARE(stage.session.history.count(), tool == "window" ? 1 : 0);
        stage.session.history.undo();
        if (tool == "window")
            QCOMPARE(stage.orange(0), before);
    }
    void panesZoomTogether()
    {
        PaneStage stage(4);
        const QRect before = stage.orange(1);
        const QPointF at = stage.at({100, 50});
        QWheelEvent event(at, stage.pane(3).mapToGlobal(at), {}, {0, -120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&stage.pane(3), &event);
        const QRect after = stage.orange(1);
        QVERIFY(after.width() < before.width() - 5);
        QCOMPARE(stage.orange(2), after);
        QCOMPARE(stage.orange(3), after);
        QCOMPARE(stage.canvas->panes().active(), std::size_t(0)); // the wheel chooses nothing
    }
    void aPaneShowsTheSameAsASingleCanvas()
    {
        for (const std::size_t count : {4, 12}) {
            PaneStage stage(count);
            Stage single(ui::Backend::Raster, steepLines());
            single.canvas->resize(stage.pane(0).size() + QSize(20, 20));
            for (std::size_t i = 0; i < count; ++i) {
                if (stage.canvas->panes().choices()[i].form == published)
                    continue; // panes mark the lines that it loses
                stage.canvas->activatePane(i);
                app::Display display = single.session.display();
                display.variant.algorithm = stage.canvas->panes().choices()[i].algorithm;
                single.session.setDisplay(display);
                single.canvas->fitPage();
                QCOMPARE(single.canvas->view(), stage.canvas->view());
                QCOMPARE(stage.shot(i), single.picture().convertToFormat(stage.shot(i).format()));
            }
        }
    }
    void eachPaneClipsWithItsOwnAlgorithm()
    {
        PaneStage stage(4);
        QCOMPARE(stage.canvas->panes().choices()[2], row("kwc", published));
        const auto dark = [&](std::size_t i) {
            int pixels = 0;
            const QImage image = stage.shot(i);
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    pixels += image.pixelColor(x, y).blueF() > 0.7
                              && image.pixelColor(x, y).redF() < 0.35;
            return pixels;
        };
        QVERIFY(dark(2) < dark(1) / 4);
        QCOMPARE(dark(1), dark(3));
    }
    void theActivePaneHasTheSessionsAlgorithm()
    {
        PaneStage stage(4);
        QSignalSpy frames(stage.canvas.get(), &ui::Canvas::frameShown);
        const auto at = stage.at({5, 5});
        QTest::mouseClick(&stage.pane(1), Qt::LeftButton, {}, at);
        QCOMPARE(stage.canvas->panes().active(), std::size_t(1));
        QCOMPARE(stage.chosen(), row("cs"));
        QCOMPARE(stage.canvas->focusProxy(), &stage.pane(1));
        app::Display display = stage.session.display();
        display.variant.algorithm = clipping::findAlgorithm("skala");
        stage.session.setDisplay(display);
        QCOMPARE(stage.canvas->panes().choices()[1], row("skala"));
        QCOMPARE(stage.canvas->panes().active(), std::size_t(1));
        frames.clear();
        stage.canvas->settle();
        QVERIFY(!frames.isEmpty());
        for (const auto& frame : frames) // the active pane's frames and no others
            QCOMPARE(frame[0].value<app::FrameTimes>().choice, std::optional(row("skala")));
        QTest::keyClick(&stage.pane(1), Qt::Key_Backtab);
        QTest::keyClick(&stage.pane(1), Qt::Key_Tab); // the keyboard reaches every pane as well
        QVERIFY(stage.canvas->panes().chosen() == stage.chosen());
    }
    void onlyTheActivePaneHasHandles()
    {
        PaneStage stage(2);
        stage.canvas->setTool("window");
        const QRect one = stage.orange(0), other = stage.orange(1);
        QVERIFY(one.height() > other.height() + 6);
        stage.canvas->activatePane(1);
        QCOMPARE(stage.orange(0), other);
        QCOMPARE(stage.orange(1), one);
    }
    void theDrawingIsEditedFromAnyPane()
    {
        PaneStage stage(4);
        stage.canvas->setTool("line");
        const std::size_t before = stage.session.now().objects().size();
        const QPointF a = stage.at({20, 20}), b = stage.at({150, 70});
        stage.send(3, QEvent::MouseButtonPress, a, Qt::LeftButton);
        stage.send(3, QEvent::MouseMove, (a + b) / 2, Qt::LeftButton);
        stage.send(3, QEvent::MouseMove, b, Qt::LeftButton);
        stage.send(3, QEvent::MouseButtonRelease, b, Qt::LeftButton);
        QCOMPARE(stage.session.now().objects().size(), before + 1);
        QCOMPARE(stage.session.history.count(), 1);
        stage.session.history.undo();
        QCOMPARE(stage.session.now().objects().size(), before);
    }
    // Space held in one pane, dragged in another: the focus goes along.
    void spacePansInAnyPane()
    {
        PaneStage stage(2);
        QTest::keyPress(&stage.pane(0), Qt::Key_Space);
        const app::Point start = stage.canvas->view().centre;
        const QPointF from = stage.at({100, 50});
        stage.send(1, QEvent::MouseButtonPress, from, Qt::LeftButton);
        stage.send(1, QEvent::MouseMove, from + QPointF(20, 0), Qt::LeftButton);
        QVERIFY(stage.canvas->view().centre.x < start.x - 1);
        stage.send(1, QEvent::MouseButtonRelease, from + QPointF(20, 0), Qt::LeftButton);
        QTest::keyRelease(&stage.pane(1), Qt::Key_Space);
        QVERIFY(stage.session.history.count() == 0);
    }
    void panesCanCloseDuringAGesture()
    {
        PaneStage stage(4);
        stage.canvas->setTool("window");
        const auto window = stage.session.window();
        const QPointF from = stage.at({100, 50});
        stage.send(3, QEvent::MouseButtonPress, from, Qt::LeftButton);
        stage.send(3, QEvent::MouseMove, from + QPointF(30, 10), Qt::LeftButton);
        app::Panes panes = stage.canvas->panes();
        panes.close(3);
        stage.canvas->setPanes(panes);
        QCOMPARE(stage.count(), std::size_t(3));
        stage.send(2, QEvent::MouseMove, from + QPointF(60, 10), Qt::LeftButton);
        stage.send(2, QEvent::MouseButtonRelease, from, Qt::LeftButton);
        QCOMPARE(stage.session.window(), window);
        QCOMPARE(stage.session.history.count(), 0);
        QCOMPARE(stage.canvas->focusProxy(), &stage.pane(stage.canvas->panes().active()));
        QVERIFY(stage.canvas->focusProxy()->hasFocus());
    }
    void theVisiblePartStaysVisible()
    {
        PaneStage stage(1);
        stage.canvas->setZoom(2.5); // fitted to nothing
        const app::View before = stage.canvas->view();
        stage.show(4);
        const auto seen = stage.canvas->view().visible();
        QVERIFY(near(stage.canvas->view().centre, before.centre, 1e-9));
        QVERIFY(seen.min.x <= before.visible().min.x + 1e-9);
        QVERIFY(seen.min.y <= before.visible().min.y + 1e-9);
        stage.show(1);
        QVERIFY(near(stage.canvas->view().visible(), before.visible(), 1e-6));
    }
    void headingsCloseChooseAndShowOnlyOnePane()
    {
        PaneStage stage(4);
        QTest::mouseClick(&stage.heading(2), Qt::LeftButton);
        QCOMPARE(stage.chosen(), row("kwc", published));
        stage.heading(1).openMenu();
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        for (QAction* action : menu->actions())
            if (action->text() == "Cyrus-Beck")
                action->trigger();
        menu->close();
        QCOMPARE(stage.canvas->panes().active(), std::size_t(1));
        QCOMPARE(stage.chosen(), row("cb"));
        emit stage.heading(1).closeWanted();
        QCOMPARE(stage.count(), std::size_t(3));
        QTest::mouseDClick(&stage.heading(2), Qt::LeftButton);
        QCOMPARE(stage.count(), std::size_t(1));
        QCOMPARE(stage.chosen(), row("md"));
    }
    // In magenta and counted, also during a gesture; a single pane shows none of it.
    void differencesFromExactAreMarked()
    {
        PaneStage stage(4);
        const auto magenta = [&](std::size_t i) {
            int pixels = 0;
            const QImage image = stage.shot(i);
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x) {
                    const QColor c = image.pixelColor(x, y);
                    pixels += c.red() > 120 && c.green() < 60 && c.blue() > 100 && c.blue() < 170;
                }
            return pixels;
        };
        const int all = magenta(2);
        QVERIFY(all > 500);
        for (const std::size_t i : {0, 1, 3})
            QCOMPARE(magenta(i), 0);
        stage.canvas->setTool("window");
        const QPointF corner = stage.at(stage.session.window().max);
        stage.send(0, QEvent::MouseButtonPress, corner, Qt::LeftButton);
        stage.send(0, QEvent::MouseMove, corner - QPointF(20, 0), Qt::LeftButton);
        stage.send(0, QEvent::MouseMove, corner - QPointF(60, 0), Qt::LeftButton);
        const int fewer = magenta(2);
        QVERIFY(fewer < all - 100 && fewer > 100);
        QTest::keyClick(&stage.pane(0), Qt::Key_Escape);
        QCOMPARE(magenta(2), all);
        app::useVariant(stage.session, row("kwc", published)); // or one pane shows what cut before
        stage.show(1);
        QCOMPARE(stage.chosen(), row("kwc", published));
        QCOMPARE(magenta(0), 0);
    }
    /// Another algorithm clips in its place: what it would lose of the page is no loss here.
    void aPaneWithAnotherAlgorithmInItsPlaceHasNoDifferences()
    {
        PaneStage stage(4);
        const auto difference = [&](std::size_t i) { // of a pane's picture from that of `exact`
            const QImage exact = stage.shot(0), image = stage.shot(i);
            const int height = image.height() - 60; // above the label in the corner
            int pixels = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < image.width(); ++x)
                    pixels += image.pixel(x, y) != exact.pixel(x, y);
            return pixels;
        };
        stage.canvas->setTool("hand"); // no handles, which only the active pane has
        QVERIFY(difference(2) > 500);
        setWindows(stage.session, {concaveWindow("Star", {{20, 5}, {180, 60}})},
                   app::Keep::Outside); // which depends on all windows
        QCOMPARE(difference(2), 0);
        QVERIFY(stage.heading(2).toolTip().contains("rectangles only"));
        QVERIFY(stage.heading(2).remark().contains("instead"));
    }
    /// Beside others an algorithm clips where it can, and says where it does not.
    void aPaneLeavesAloneWhatItCannotClip()
    {
        PaneStage stage(4);
        const app::ClipWindow box{.name = "Box",
                                  .shape = app::RectangleShape{{{20, 20}, {60, 60}}}};
        const app::ClipWindow star = concaveWindow("Star", {{100, 5}, {180, 95}});
        const auto kept = [&](std::size_t i, QPointF from, QPointF to) { // pixels, not ghosted
            const QImage image = stage.shot(i);
            const QRect area(stage.at({from.x(), from.y()}), stage.at({to.x(), to.y()}));
            int pixels = 0;
            for (int y = area.top(); y < area.bottom(); ++y)
                for (int x = area.left(); x < area.right(); ++x)
                    pixels += image.pixelColor(x, y).red() < 100;
            return pixels;
        };
        setWindows(stage.session, {box, star});
        QVERIFY(kept(0, {25, 25}, {55, 55}) > 20);
        QCOMPARE(kept(1, {25, 25}, {55, 55}), kept(0, {25, 25}, {55, 55}));
        QVERIFY(kept(0, {120, 15}, {140, 40}) > 20);
        QCOMPARE(kept(1, {120, 15}, {140, 40}), 0);
        QTRY_COMPARE(stage.heading(1).remark(), "agrees in Box");
        QCOMPARE(stage.heading(2).remark(), "in Box only"); // it loses lines there
        QCOMPARE(stage.heading(0).remark(), "Exact");
        QVERIFY(stage.heading(1).toolTip().contains("does not clip Star: rectangles only\n"));
        QVERIFY(stage.heading(1).toolTip().endsWith("that of the other windows."));
        setWindows(stage.session, {star});
        QCOMPARE(stage.heading(1).remark(), "rectangles only");
        QCOMPARE(kept(1, {120, 15}, {140, 40}), 0);
        stage.canvas->activatePane(1);
        stage.show(1); // alone it shows the drawing as it is cut
        QVERIFY(kept(0, {120, 15}, {140, 40}) > 20);
        setWindows(stage.session, {box});
        QVERIFY(stage.heading(0).toolTip().isEmpty()
                || !stage.heading(0).toolTip().contains("rectangles"));
    }
    void headingsShowTheirTimes()
    {
        PaneStage stage(4);
        std::vector<app::Shape> shapes;
        for (int i = 0; i < 5000; ++i)
            shapes.push_back(line({i % 200, i % 97}, {i % 200 + 3, i % 97 + 2}));
        ::splice(stage.session.document, 0, 0, std::move(shapes));
        stage.canvas->settle();
        QTRY_VERIFY(stage.heading(0).time().endsWith("ms"));
        QTRY_VERIFY(stage.heading(3).time().endsWith("ms"));
        stage.heading(3).note({.clipMs = 2, .total = 5000, .painting = true, .lateMs = 1240});
        QTRY_COMPARE(stage.heading(3).time(), QString("1.2 s late"));
        stage.heading(3).note({.clipMs = 2, .total = 5000});
        QTRY_VERIFY(stage.heading(3).time().endsWith("ms"));
        ::splice(stage.session.document, 0, 5000, {});
        stage.canvas->settle();
        QTRY_COMPARE(stage.heading(3).time(), QString()); // too few lines to time
    }
    void fewerPanesAreShownWithoutRoom()
    {
        PaneStage stage(4);
        stage.canvas->activatePane(2);
        stage.canvas->resize(380, 500);
        QVERIFY(stage.canvas->paneSurface(0) && stage.canvas->paneSurface(2));
        QVERIFY(!stage.canvas->paneSurface(1) && !stage.canvas->paneSurface(3));
        QCOMPARE(stage.chosen(), row("kwc", published));
        stage.canvas->resize(820, 620);
        QVERIFY(stage.canvas->paneSurface(1) && stage.canvas->paneSurface(3));
    }
};

} // namespace canvas_panes_test

TEST_CLASS(canvas_panes_test::PanesTest, Widgets)
#include "tests/ui/canvas/panes_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"

#include "tests/app/document/sheet_edits.h"
#include "tests/ui/canvas/stage.h"

// The behaviour that both canvases share, tested with real events. Both tests call these.

namespace cases {

inline void theKeptPartIsShownAndTheRestGhosted(ui::Backend backend)
{
    Stage stage(backend);
    QCOMPARE(stage.colourAt({100, 50}), QColor(0, 0, 200));
    const QColor ghost = stage.colourAt({30, 50});
    QVERIFY2(ghost.red() > 150 && ghost.red() < 200 && ghost.blue() > 230,
             qPrintable(ghost.name()));
    QCOMPARE(stage.colourAt({30, 10}), QColor(Qt::white));
    app::Display display = stage.session.display();
    ui::setKeep(stage.session, app::Keep::Outside);
    stage.session.setDisplay(display);
    QCOMPARE(stage.colourAt({30, 50}), QColor(0, 0, 200));
    display.removed = app::RemovedPart::Hidden;
    stage.session.setDisplay(display);
    QCOMPARE(stage.colourAt({100, 50}), QColor(Qt::white));
    display.removed = app::RemovedPart::Shown;
    stage.session.setDisplay(display);
    QCOMPARE(stage.colourAt({100, 50}), QColor(0, 0, 200));
    QCOMPARE(stage.colourAt({30, 50}), QColor(0, 0, 200));
}

inline void everyFrameClipsEverything(ui::Backend backend)
{
    Stage stage(backend, {line({10, 50}, {190, 50}), line({5, 5}, {6, 6})});
    std::vector<app::FrameTimes> frames;
    QObject::connect(stage.canvas.get(), &ui::Canvas::frameShown,
                     [&](const app::FrameTimes& t) { frames.push_back(t); });
    stage.picture();
    QVERIFY(!frames.empty());
    QCOMPARE(frames.back().total, std::size_t(2));
    QCOMPARE(frames.back().visible, std::size_t(1));
    QVERIFY(frames.back().clipMs > 0);
    ::setWindow(stage.session.document, {{0, 0}, {200, 100}});
    stage.picture();
    QCOMPARE(frames.back().visible, std::size_t(2));
}

inline void theWheelZoomsAroundThePointerAndBack(ui::Backend backend)
{
    Stage stage(backend);
    const app::View start = stage.canvas->view();
    const app::Point pointer(300, 222), under = start.toDrawing(pointer);
    stage.wheel({300, 222}, {0, 120});
    QCOMPARE(stage.canvas->view().zoom, start.zoom * 1.2);
    QVERIFY(near(stage.canvas->view().toDrawing(pointer), under, 1e-9));
    stage.wheel({300, 222}, {0, 240});
    stage.wheel({300, 222}, {0, -360});
    QVERIFY(stage.canvas->view() == start);
}

inline void wheelsAndTouchpadsPan(ui::Backend backend)
{
    Stage stage(backend);
    const app::View start = stage.canvas->view();
    stage.wheel({300, 222}, {0, 120}, Qt::ShiftModifier);
    QVERIFY(near(start.centre - stage.canvas->view().centre, {24, 0}, 1e-9)); // 48 pixels at 200 %
    stage.wheel({300, 222}, {0, -120}, Qt::ShiftModifier);
    stage.wheel({300, 222}, {14, -6}, {}, {14, -6}, Qt::ScrollUpdate);
    QVERIFY(near(start.centre - stage.canvas->view().centre, {7, -3}, 1e-9));
    QCOMPARE(stage.canvas->view().zoom, start.zoom);
    stage.wheel({300, 222}, {0, 30}, Qt::ControlModifier, {0, 30}, Qt::ScrollUpdate);
    QVERIFY(stage.canvas->view().zoom > start.zoom);
    const QPointF at(100, 100);
    const auto* pad = QPointingDevice::primaryPointingDevice();
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, pad, 2, at, at, at, 0.5, {});
    const double before = stage.canvas->view().zoom;
    QApplication::sendEvent(&stage.surface(), &pinch);
    QVERIFY(std::abs(stage.canvas->view().zoom - before * 1.5) < 1e-9);
}

inline void buttonsAndSpacePan(ui::Backend backend)
{
    Stage stage(backend);
    const app::Point start = stage.canvas->view().centre;
    stage.drag({100, 50}, {120, 60}, Qt::MiddleButton);
    QVERIFY(near(stage.canvas->view().centre, start - app::Point(20, 10)));
    QTest::keyPress(&stage.surface(), Qt::Key_Space);
    stage.drag({100, 50}, {80, 40});
    QTest::keyRelease(&stage.surface(), Qt::Key_Space);
    QVERIFY(near(stage.canvas->view().centre, start));
    stage.canvas->setTool("hand");
    stage.drag({100, 50}, {110, 50});
    QVERIFY(near(stage.canvas->view().centre, start - app::Point(10, 0)));
    QVERIFY(stage.session.history.count() == 0);
    QTest::mouseDClick(&stage.surface(), Qt::MiddleButton, {}, {400, 300});
    QVERIFY(near(stage.canvas->view().centre, {100, 50}, 1e-9));
}

inline void keysNavigate(ui::Backend backend)
{
    Stage stage(backend);
    stage.canvas->setZoom(1);
    QTest::qWait(750); // a separate entry of the view history
    stage.key(Qt::Key_Plus, Qt::ControlModifier);
    QVERIFY(stage.canvas->zoom() > 1.1);
    stage.key(Qt::Key_Minus, Qt::ControlModifier);
    QVERIFY(std::abs(stage.canvas->zoom() - 1) < 1e-9);
    stage.key(Qt::Key_Equal, Qt::ControlModifier);
    stage.key(Qt::Key_0, Qt::ControlModifier);
    QVERIFY(std::abs(stage.canvas->zoom() - 1) < 1e-9);
    const app::View before = stage.canvas->view();
    QTest::qWait(750);
    stage.key(Qt::Key_Exclam, Qt::ShiftModifier);
    const app::View fitted = stage.canvas->view();
    QVERIFY(fitted.zoom > 3);
    stage.key(Qt::Key_Dollar, Qt::ShiftModifier); // the page is wider than what is drawn
    QVERIFY(stage.canvas->view().zoom < fitted.zoom && stage.canvas->view().zoom > 3);
    stage.key(Qt::Key_1, Qt::ShiftModifier);
    QVERIFY(stage.canvas->view() == fitted);
    stage.key(Qt::Key_QuoteLeft);
    QVERIFY(stage.canvas->view() == before);
    stage.key(Qt::Key_AsciiTilde, Qt::ShiftModifier);
    QVERIFY(stage.canvas->view() == fitted);
    stage.key(Qt::Key_3, Qt::ShiftModifier);
    QVERIFY(near(stage.canvas->view().centre, {100, 50})
            && stage.canvas->view().zoom > fitted.zoom);
    stage.session.select({0});
    stage.key(Qt::Key_At, Qt::ShiftModifier);
    QVERIFY(near(stage.canvas->view().centre, {100, 50}));
    stage.session.select({});
    const app::View still = stage.canvas->view();
    stage.key(Qt::Key_Right);
    QVERIFY(stage.canvas->view().centre.x > still.centre.x);
    for (const auto& [pressed, tool] :
         {std::pair{Qt::Key_L, "line"}, {Qt::Key_W, "window"}, {Qt::Key_V, "select"}}) {
        stage.key(pressed);
        QCOMPARE(stage.canvas->tool(), std::string_view(tool));
    }
}

inline void theClipWindowIsDrawnMovedAndResized(ui::Backend backend)
{
    Stage stage(backend);
    stage.key(Qt::Key_W);
    const auto window = [&] { return stage.session.window(); };
    stage.drag({20, 90}, {170, 95}); // starts outside: one window more, which is chosen
    QVERIFY(near(window(), {{20, 90}, {170, 95}}));
    stage.drag({180, 10}, {160, 85}, Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(std::abs((window().max.x - window().min.x) - (window().max.y - window().min.y)) < 1e-9);
    QCOMPARE(stage.session.history.count(), 2);
    QCOMPARE(stage.session.now().windows().list.size(), 3u);
    stage.session.document.apply({.windows = app::ClipWindows{
                                      {{.shape = app::RectangleShape{{{50, 20}, {150, 80}}}}}}});
    stage.drag({100, 40}, {110, 35}); // the inside: moves it
    QVERIFY(near(window(), {{60, 15}, {160, 75}}));
    stage.drag({160, 75}, {180, 90}, Qt::LeftButton, Qt::ControlModifier); // a corner
    QVERIFY(near(window(), {{60, 15}, {180, 90}}));
    QCOMPARE(stage.session.history.count(), 4);
    const auto before = window();
    stage.press({180, 90});
    stage.move({195, 95}, Qt::LeftButton);
    stage.key(Qt::Key_Escape);
    stage.release({195, 95});
    QVERIFY(window() == before);
    QCOMPARE(stage.session.history.count(), 4);
    stage.key(Qt::Key_Right);
    stage.key(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(stage.session.history.count(), 5);
    const double millimetre = 96 / 25.4;
    QVERIFY(near(window().min, before.min + app::Point(11 * millimetre, 0), 1e-9));
    stage.session.history.undo();
    QVERIFY(window() == before);
}

inline void theClipFollowsTheGesture(ui::Backend backend)
{
    Stage stage(backend);
    stage.key(Qt::Key_W);
    stage.press({50, 35}); // the middle of the left side is at y 50, the outline is taken here
    stage.move({70, 35}, Qt::LeftButton);
    // It is outside now. (At y 50 there is the guide that shows what is aligned.)
    QVERIFY(stage.colourAt({57, 51}).red() > 150);
    QCOMPARE(stage.session.history.count(), 0);
    stage.release({70, 35});
    QCOMPARE(stage.session.history.count(), 1);
}

/// Published KWC loses a line that leans by less than one unit.
inline void differencesAreColouredAndFollowTheGesture(ui::Backend backend)
{
    Stage stage(backend, {line({100, 10}, {100.5, 90}), line({60, 30}, {90, 60})});
    const auto isMarked = [&](app::Point p) {
        const QColor pixel = stage.colourAt(p);
        const QColor marked = ui::lookOf(QApplication::palette()).differs;
        return std::abs(pixel.red() - marked.red()) + std::abs(pixel.green() - marked.green())
                   + std::abs(pixel.blue() - marked.blue())
               < 40;
    };
    QVERIFY(!isMarked({100.25, 50}));
    stage.session.differences.ask(app::Comparison{*app::findVariant("kwc:published")});
    QTRY_VERIFY(stage.session.differences.upToDate());
    QVERIFY(isMarked({100.25, 50}));
    QVERIFY(!isMarked({75, 45}));     // both see this one
    QVERIFY(!isMarked({100.45, 85})); // outside the window
    stage.key(Qt::Key_W);
    stage.press({75, 80}); // the lower side
    stage.move({75, 70}, Qt::LeftButton);
    QTRY_VERIFY(stage.session.differences.upToDate());
    QVERIFY(isMarked({100.25, 50}));
    QVERIFY(!isMarked({100.4, 75})); // now it is outside
    stage.move({75, 95}, Qt::LeftButton);
    QTRY_VERIFY(stage.session.differences.upToDate());
    QVERIFY(isMarked({100.45, 85}));
    QCOMPARE(stage.session.history.count(), 0);
    stage.release({75, 95});
    stage.session.differences.ask(std::nullopt);
    QVERIFY(!isMarked({100.25, 50}));
}

} // namespace cases

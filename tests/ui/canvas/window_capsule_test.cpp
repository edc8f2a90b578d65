// SPDX-License-Identifier: GPL-3.0-or-later
// The controls beside the chosen clip window.
#include "app/commands/set_page_parts.h"
#include "app/document/window_operations.h"
#include "app/session/window_steps.h"
#include "ui/canvas/window_capsule.h"
#include "ui/widgets/length_field.h"

#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_window_capsule_test {

namespace {

constexpr int untilItListens = 300; // milliseconds

struct CapsuleStage : Stage {
    CapsuleStage() : Stage(ui::Backend::Raster)
    {
        canvas->setTool("window");
        canvas->settle();
    }
    ui::WindowCapsule& capsule() { return *canvas->findChild<ui::WindowCapsule*>(); }
    template <class Part>
    Part& part(const char* name)
    {
        return *canvas->findChild<Part*>(QLatin1StringView(name));
    }
    void clickPart(const char* group, int index)
    {
        QTest::qWait(untilItListens);
        const auto buttons = part<QWidget>(group).findChildren<QToolButton*>();
        QTest::mouseClick(buttons[index], Qt::LeftButton);
    }
    const app::ClipWindow& window() { return session.windows().list[*session.windowNumber()]; }
    /// Puts another window above the first one, which can do more than add then.
    void insertAbove()
    {
        app::ClipWindows windows = session.windows();
        windows.list.insert(windows.list.begin(), {.shape = app::RectangleShape{{{2, 2}, {9, 9}}}});
        session.history.push(new app::SetWindows(session.document, windows, {}));
    }
    void addAbove()
    {
        insertAbove();
        session.chooseWindow(1);
    }
    clipping::Window box() { return *session.clipWindow(); }
    QRect place() { return {surface().mapFrom(canvas.get(), capsule().pos()), capsule().size()}; }
};

} // namespace

class WindowCapsuleTest : public QObject {
    Q_OBJECT

private slots:
    void itIsBesideTheChosenWindow()
    {
        CapsuleStage stage;
        QVERIFY(stage.capsule().isVisible());
        QCOMPARE(stage.capsule().accessibleName(), QStringLiteral("Rectangle, clip window"));
        const QPoint bottom = stage.at({100, 80});
        QVERIFY(stage.place().top() > bottom.y() && stage.place().top() < bottom.y() + 30);
        QVERIFY(std::abs(stage.place().center().x() - bottom.x()) <= 1);
        stage.canvas->setTool("line");
        QVERIFY(!stage.capsule().isVisible());
        stage.canvas->setTool("window");
        QVERIFY(stage.capsule().isVisible());
        stage.session.history.push(
            new app::SetWindows(stage.session.document, app::ClipWindows{}, {}));
        QVERIFY(!stage.capsule().isVisible());
    }
    // With Select only if it was chosen: keys are for what was chosen last.
    void withOtherToolsAWindowIsChosenFirst()
    {
        CapsuleStage stage;
        stage.insertAbove();
        stage.canvas->setTool("select");
        QVERIFY(!stage.capsule().isVisible());
        QTest::keyClick(&stage.surface(), '-');
        QCOMPARE(stage.window().operation, app::WindowOperation::Add);
        stage.session.chooseWindow(1);
        QVERIFY(stage.capsule().isVisible());
        QTest::keyClick(&stage.surface(), '-');
        QCOMPARE(stage.window().operation, app::WindowOperation::CutOut);
        stage.click({10, 90}); // on nothing
        QVERIFY(!stage.capsule().isVisible());
    }
    void itIsGoneInEveryGesture()
    {
        CapsuleStage stage;
        stage.move({100, 50});
        stage.press({100, 50});
        stage.move({110, 50}, Qt::LeftButton);
        QVERIFY(!stage.capsule().isVisible());
        stage.move({120, 45}, Qt::LeftButton);
        stage.release({120, 45});
        QVERIFY(stage.capsule().isVisible());
        const QPoint bottom = stage.at({120, 75});
        QVERIFY(std::abs(stage.place().center().x() - bottom.x()) <= 1);
        // The view, too.
        stage.wheel(QPointF(300, 200), {0, 120});
        QVERIFY(!stage.capsule().isVisible());
        QTRY_VERIFY(stage.capsule().isVisible());
    }
    void typedSizesAreUndoSteps()
    {
        CapsuleStage stage;
        stage.session.changeDisplay([](app::Display& d) { d.unit = app::Unit::Px; });
        auto& width = stage.part<ui::LengthField>("capsule-width");
        QCOMPARE(width.text(), QStringLiteral("100.0"));
        stage.key(Qt::Key_Return); // goes into the first field, whose text is selected
        QVERIFY(width.hasFocus());
        const QRect before = stage.place();
        QTest::keyClicks(&width, "120/2");
        QTest::keyClick(&width, Qt::Key_Tab);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {110, 80}}));
        QCOMPARE(stage.place(), before); // it stays while a field is open
        auto& height = stage.part<ui::LengthField>("capsule-height");
        QVERIFY(height.hasFocus());
        QTest::keyClicks(&height, "20");
        QTest::keyClick(&height, Qt::Key_Return);
        QVERIFY(stage.surface().hasFocus());
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {110, 40}}));
        stage.session.history.undo();
        stage.session.history.undo();
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {150, 80}}));
        QCOMPARE(width.text(), QStringLiteral("100.0"));
    }
    void shiftAndEnterKeepTheProportions()
    {
        CapsuleStage stage;
        stage.session.changeDisplay([](app::Display& d) { d.unit = app::Unit::Px; });
        const auto enter = [&stage](const char* name, const char* number, bool shift) {
            auto& side = stage.part<ui::LengthField>(name);
            side.setFocus();
            side.selectAll();
            QTest::keyClicks(&side, number);
            QTest::keyClick(&side, Qt::Key_Return, shift ? Qt::ShiftModifier : Qt::NoModifier);
        };
        enter("capsule-width", "50", true);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {100, 50}}));
        enter("capsule-height", "60", true);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {150, 80}}));
        enter("capsule-height", "30", false);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {150, 50}}));
    }
    void whatIsTypedIsForTheWindowThatWasShown()
    {
        CapsuleStage stage;
        stage.session.changeDisplay([](app::Display& d) { d.unit = app::Unit::Px; });
        stage.drag({160, 20}, {190, 60}); // another window, which is chosen
        auto& width = stage.part<ui::LengthField>("capsule-width");
        const QRect before = stage.place();
        width.setFocus();
        QTest::keyClicks(&width, "7");
        stage.session.chooseWindow(0); // by a command, while the field is open
        QVERIFY(stage.surface().hasFocus());
        QCOMPARE(width.text(), QStringLiteral("100.0"));
        QVERIFY(stage.place() != before);
        QCOMPARE(stage.session.history.undoText(), QStringLiteral("Draw clip window"));
        // The same number in another drawing.
        width.setFocus();
        QTest::keyClicks(&width, "7");
        app::Sheet sheet;
        sheet.window = {{10, 10}, {90, 80}};
        stage.session.load({app::documentOf(sheet), {}});
        QVERIFY(!width.hasFocus());
        QCOMPARE(stage.box(), (clipping::Window{{10, 10}, {90, 80}}));
    }
    void whatIsTypedIsTakenByTheOtherParts()
    {
        CapsuleStage stage;
        stage.session.changeDisplay([](app::Display& d) { d.unit = app::Unit::Px; });
        auto& width = stage.part<ui::LengthField>("capsule-width");
        stage.key(Qt::Key_Return);
        QTest::keyClicks(&width, "60");
        stage.clickPart("capsule-operation", int(app::WindowOperation::CutOut));
        QCOMPARE(stage.window().operation, app::WindowOperation::CutOut);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {110, 80}}));
        // What changes elsewhere leaves it.
        stage.key(Qt::Key_Return);
        QTest::keyClicks(&width, "30");
        stage.session.changeDisplay([](app::Display& d) { d.guides = !d.guides; });
        QCOMPARE(width.text(), QStringLiteral("30"));
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {80, 80}}));
    }
    void theWheelIsForTheCanvas()
    {
        CapsuleStage stage;
        auto& width = stage.part<ui::LengthField>("capsule-width");
        const double zoom = stage.canvas->view().zoom;
        const QPoint middle = width.rect().center();
        QWheelEvent wheel(middle, width.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&width, &wheel);
        QVERIFY(stage.canvas->view().zoom > zoom);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {150, 80}}));
        QVERIFY(stage.surface().hasFocus());
    }
    void aWindowWithoutAreaIsNoNeighbour()
    {
        CapsuleStage stage;
        app::ClipWindows windows = stage.session.windows();
        windows.list.push_back({.shape = app::RectangleShape{{{20, 20}, {20, 60}}}});
        stage.session.history.push(new app::SetWindows(stage.session.document, windows, {}));
        QVERIFY(stage.capsule().isVisible());
    }
    // Its gesture could be corrected by typed numbers; the chosen window is another one.
    void enterIsForTheChosenWindow()
    {
        CapsuleStage stage;
        stage.drag({160, 20}, {190, 60});
        stage.click({100, 50}); // the first one
        QCOMPARE(stage.session.windowNumber(), std::size_t(0));
        stage.key(Qt::Key_Return);
        QVERIFY(stage.part<ui::LengthField>("capsule-width").hasFocus());
        QTest::keyClicks(QApplication::focusWidget(), "60");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCOMPARE(stage.session.windows().list.size(), std::size_t(2));
        QVERIFY(stage.session.windowNumber() == std::size_t(0));
    }
    void aClickOnAFieldSelectsAllOfIt()
    {
        CapsuleStage stage;
        QTest::qWait(untilItListens);
        auto& width = stage.part<ui::LengthField>("capsule-width");
        auto* line = width.findChild<QLineEdit*>();
        QTest::mouseClick(line, Qt::LeftButton, {}, {line->width() - 4, line->height() / 2});
        QCoreApplication::processEvents();
        QCOMPARE(line->selectedText(), line->text());
    }
    // On the side where the pointer was let go; a click that changes nothing does not move it.
    void itIsWhereThePointerWasLetGo()
    {
        CapsuleStage stage;
        stage.drag({100, 30}, {110, 30});
        QVERIFY(stage.place().bottom() < stage.at({100, 20}).y());
        const QRect before = stage.place();
        for (const app::Point& at : {app::Point(60, 75), app::Point(140, 75)})
            stage.click(at);
        QCOMPARE(stage.place(), before);
        stage.drag({100, 70}, {110, 70});
        QVERIFY(stage.place().top() > stage.at({100, 80}).y());
    }
    void whatIsNoLengthIsRefused()
    {
        CapsuleStage stage;
        QSignalSpy refused(stage.canvas.get(), &ui::Canvas::refused);
        auto& width = stage.part<ui::LengthField>("capsule-width");
        stage.key(Qt::Key_Return);
        QTest::keyClicks(&width, "-5");
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(stage.box(), (clipping::Window{{50, 20}, {150, 80}}));
        QTest::keyClick(&width, Qt::Key_Escape);
        QVERIFY(stage.surface().hasFocus());
    }
    void itSaysWhatTheWindowDoes()
    {
        CapsuleStage stage;
        stage.addAbove();
        for (const app::WindowOperationInfo& each : app::windowOperations()) {
            stage.clickPart("capsule-operation", int(each.operation));
            QCOMPARE(stage.window().operation, each.operation);
        }
        stage.clickPart("capsule-operation", 0);
        stage.clickPart("capsule-operation", 1);
        QCOMPARE(stage.window().operation, app::WindowOperation::CutOut);
        QCOMPARE(stage.session.history.undoText(), QStringLiteral("Cut out Rectangle"));
        QVERIFY(stage.surface().hasFocus());
        stage.session.history.undo();
        QCOMPARE(stage.window().operation, app::WindowOperation::Add);
    }
    void theFirstWindowHasNoneToIntersectOrReplace()
    {
        CapsuleStage stage;
        QSignalSpy refused(&stage.session, &app::Session::refused);
        const QString why = "No clip window is above Rectangle.";
        const auto buttons = stage.part<QWidget>("capsule-operation").findChildren<QToolButton*>();
        const auto entries = stage.part<QToolButton>("capsule-operations").menu()->actions();
        for (const app::WindowOperationInfo& each : app::windowOperations()) {
            const bool can = each.operation == app::WindowOperation::Add
                             || each.operation == app::WindowOperation::CutOut;
            QCOMPARE(buttons[int(each.operation)]->isEnabled(), can);
            QCOMPARE(buttons[int(each.operation)]->toolTip() == why, !can);
            QCOMPARE(entries[int(each.operation)]->isEnabled(), can);
            QTest::keyClick(&stage.surface(), each.letter[0].toLatin1());
        }
        QCOMPARE(refused.size(), int(app::windowOperations().size()) - 2);
        QCOMPARE(refused[0][0].toString(), why);
        QCOMPARE(stage.window().operation, app::WindowOperation::CutOut);
        stage.addAbove();
        for (const QToolButton* button : buttons)
            QVERIFY(button->isEnabled() && button->toolTip() != why);
    }
    void itsKeysWorkOnTheCanvas()
    {
        CapsuleStage stage;
        stage.addAbove();
        for (const app::WindowOperationInfo& each : app::windowOperations()) {
            QTest::keyClick(&stage.surface(), each.letter[0].toLatin1());
            QCOMPARE(stage.window().operation, each.operation);
        }
        stage.key(Qt::Key_X);
        QCOMPARE(stage.session.windows().keep, app::Keep::Outside);
        // Just after a window was drawn, too; in a gesture a sign is typed.
        stage.drag({160, 20}, {190, 80});
        QCOMPARE(stage.session.windows().list.size(), std::size_t(3));
        QTest::keyClick(&stage.surface(), '-');
        QCOMPARE(stage.session.windows().list[2].operation, app::WindowOperation::CutOut);
        stage.canvas->setTool("line");
        QTest::keyClick(&stage.surface(), '+');
        QCOMPARE(stage.session.windows().list[2].operation, app::WindowOperation::CutOut);
    }
    void tabChoosesTheNextWindow()
    {
        CapsuleStage stage;
        stage.drag({160, 20}, {190, 60});
        stage.drag({10, 20}, {40, 60});
        QCOMPARE(stage.session.windowNumber(), std::size_t(2));
        app::changeWindow(stage.session, 1, {}, [](app::ClipWindow& w) { w.visible = false; });
        stage.key(Qt::Key_Tab);
        QCOMPARE(stage.session.windowNumber(), std::size_t(0));
        stage.key(Qt::Key_Tab); // the hidden one is passed over
        QCOMPARE(stage.session.windowNumber(), std::size_t(2));
        stage.key(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(stage.session.windowNumber(), std::size_t(0));
        QVERIFY(stage.surface().hasFocus());
        stage.key(Qt::Key_Escape); // to Select
        stage.key(Qt::Key_Tab);
        QCOMPARE(stage.session.windowNumber(), std::size_t(0));
    }
    // The second click of a double click may come where it has just appeared.
    void aClickThatCameTooSoonGoesThrough()
    {
        CapsuleStage stage;
        QTest::qWait(untilItListens);
        QVERIFY(!stage.capsule().testAttribute(Qt::WA_TransparentForMouseEvents));
        stage.drag({100, 50}, {110, 50});
        auto& width = stage.part<ui::LengthField>("capsule-width");
        const auto what = [&] {
            return stage.canvas->childAt(width.mapTo(stage.canvas.get(), width.rect().center()));
        };
        QVERIFY(!stage.capsule().isAncestorOf(what()));
        QTest::qWait(untilItListens);
        QVERIFY(stage.capsule().isAncestorOf(what()));
    }
    void itsMenuIsAskedFor()
    {
        CapsuleStage stage;
        QSignalSpy wanted(stage.canvas.get(), &ui::Canvas::windowMenuWanted);
        QTest::qWait(untilItListens);
        QTest::mouseClick(&stage.part<QToolButton>("capsule-more"), Qt::LeftButton);
        QCOMPARE(wanted.size(), 1);
    }
    void itIsShorterOnANarrowCanvas()
    {
        CapsuleStage stage;
        stage.addAbove();
        const int whole = stage.capsule().width();
        stage.canvas->resize(500, 400);
        stage.canvas->settle();
        QVERIFY(stage.capsule().isVisible() && stage.capsule().width() < whole);
        QVERIFY(!stage.part<QWidget>("capsule-operation").isVisible());
        auto& operations = stage.part<QToolButton>("capsule-operations");
        operations.menu()->actions()[2]->trigger();
        QCOMPARE(stage.window().operation, app::WindowOperation::Intersect);
    }
    void itIsSwitchedOff()
    {
        CapsuleStage stage;
        stage.canvas->setCapsuleHome(app::CapsuleHome::Off);
        QVERIFY(!stage.capsule().isVisible());
        stage.key(Qt::Key_Return); // nothing to go into
        QVERIFY(stage.surface().hasFocus());
        stage.canvas->setCapsuleHome(app::CapsuleHome::AtObject);
        QVERIFY(stage.capsule().isVisible());
    }
    void aWindowOffTheScreenHasNone()
    {
        CapsuleStage stage;
        app::View away = stage.canvas->view();
        away.centre += app::Point(10'000, 0);
        stage.canvas->go(away);
        stage.canvas->settle();
        QVERIFY(!stage.capsule().isVisible());
    }
};

} // namespace canvas_window_capsule_test

TEST_CLASS(canvas_window_capsule_test::WindowCapsuleTest, Widgets)
#include "tests/ui/canvas/window_capsule_test.moc"

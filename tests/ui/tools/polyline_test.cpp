// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool.h"

#include <QAction>
#include <QElapsedTimer>
#include <QSignalSpy>

#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"
#include "tests/ui/test_window.h"

namespace tools_polyline_test {

// While a polyline is drawn, Undo and Redo go by corners, and no way of ending it loses corners.
class PolylineTest : public QObject {
    Q_OBJECT

private slots:
    void backspaceMeansTheCornerAlsoWithASelection()
    {
        Hand hand;
        hand.window.session().history.push(
            addShapes(hand.window.session().document, {line({0, 0}, {5, 5})}, "line"));
        hand.window.session().select({0});
        hand.click(3);
        hand.key(Qt::Key_Backspace);
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.shapes().size(), std::size_t(2));
        QCOMPARE(hand.corners(1), hand.placed(2));
    }
    void aLaterStepIsRefusedWhileCornersWouldReplaceIt()
    {
        Hand hand;
        app::Session& session = hand.window.session();
        for (int i = 1; i < 4; ++i)
            session.history.push(addShapes(session.document, {line({0, 0}, {5. * i, 5})}, "line"));
        session.history.setIndex(1);
        hand.click(2);
        const QSignalSpy refused(&session, &app::Session::refused);
        hand.window.canvas().goToStep(3);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(session.history.count(), 3);
        hand.window.canvas().goToStep(0); // keeps the corners as a step that can be redone
        QCOMPARE(session.history.index(), 0);
        QCOMPARE(session.history.count(), 2);
    }
    // Chosen in the bar: what is ended is closed, if it has three corners.
    void itIsClosedIfThatIsChosen()
    {
        Hand hand;
        hand.window.canvas().keepNumbers("polyline", {1});
        hand.click(2);
        hand.key(Qt::Key_Return);
        hand.click(3);
        hand.key(Qt::Key_Return);
        hand.click(4);
        hand.window.canvas().setTool("select"); // keeps it, too
        const auto& objects = hand.window.session().now().objects();
        QCOMPARE(objects.size(), std::size_t(3));
        for (const std::size_t i : {0, 1, 2})
            QCOMPARE(objects[i].path().subpaths().front().closed, i > 0);
        QCOMPARE(hand.corners(2), hand.placed(4));
    }
    void undoRemovesACornerAndRedoRestoresIt()
    {
        Hand hand;
        hand.window.session().history.push(
            addShapes(hand.window.session().document, {line({0, 0}, {5, 5})}, "line"));
        hand.click(3);
        hand.undo();
        QCOMPARE(hand.t.action("redo")->text(), "&Redo Place corner");
        QCOMPARE(hand.t.action("undo")->text(), "&Undo Place corner");
        hand.undo();
        hand.undo();
        QCOMPARE(hand.shapes().size(), std::size_t(1)); // the finished line is still there
        for (int i = 0; i < 3; ++i)
            hand.redo();
        hand.redo(); // no more than there were
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.shapes().size(), std::size_t(2));
        QCOMPARE(hand.corners(1), hand.placed(3));
        QCOMPARE(hand.window.session().history.count(), 2); // one step
        hand.undo();
        QCOMPARE(hand.shapes().size(), std::size_t(1));
        hand.redo();
        QCOMPARE(hand.corners(1), hand.placed(3));
    }
    void earlierStepsAreUndoneAfterTheCornersAndRedoneBefore()
    {
        Hand hand;
        app::Session& session = hand.window.session();
        session.history.push(addShapes(session.document, {line({0, 0}, {5, 5})}, "line"));
        hand.click(2);
        for (int i = 0; i < 3; ++i)
            hand.undo();
        QVERIFY(hand.shapes().empty());
        hand.redo();
        QCOMPARE(hand.shapes().size(), std::size_t(1));
        QVERIFY(!hand.window.canvas().pendingObject());
        hand.redo();
        hand.redo();
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.corners(1), hand.placed(2));
    }
    void cornersDoNotComeBackAfterALaterStep()
    {
        for (const std::size_t limit : {app::History::usualLimit, std::size_t(0)}) {
            Hand hand;
            app::Session& session = hand.window.session();
            session.history.setLimit(limit); // 0: as many steps as before, but not the same
            const auto step = [&session] {
                session.history.push(addShapes(session.document, {line({0, 0}, {5, 5})}, "line"));
            };
            step();
            hand.click(1);
            hand.undo();
            QVERIFY(hand.t.action("redo")->isEnabled());
            step();
            QVERIFY(!hand.t.action("redo")->isEnabled());
        }
    }
    void aNewCornerDiscardsRemovedCorners()
    {
        Hand hand;
        hand.click(2);
        hand.undo();
        hand.clickAt(2);
        QVERIFY(!hand.t.action("redo")->isEnabled());
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.corners(0), (std::vector{hand.place(0), hand.place(2)}));
    }
    void backspaceIsUndoneByRedo()
    {
        Hand hand;
        hand.click(3);
        hand.key(Qt::Key_Backspace);
        hand.redo();
        hand.key(Qt::Key_Return);
        QCOMPARE(hand.corners(0), hand.placed(3));
    }
    void everyEndKeepsThePolyline()
    {
        for (const auto& [name, end] : endings())
            for (const int count : name.startsWith('E') ? std::vector{3, 2, 1} : std::vector{3}) {
                Hand hand;
                hand.click(count);
                hand.point(count); // the corner not yet clicked
                end(hand);
                const bool kept = count > 1;
                QVERIFY2(hand.shapes().size() == std::size_t(kept), qPrintable(name));
                QCOMPARE(hand.window.session().history.count(), int(kept));
                if (kept)
                    QVERIFY2(hand.corners(0) == hand.placed(count), qPrintable(name));
                QVERIFY2(!hand.window.canvas().pendingObject(), qPrintable(name));
            }
    }
    void savingAndClosingIncludeThePolyline()
    {
        Hand hand;
        hand.click(3);
        hand.t.answers->save = hand.t.path("polyline.svg");
        hand.t.run("save");
        QCOMPARE(app::sheetOf(app::readFile(hand.t.answers->save).value->document).shapes.size(),
                 std::size_t(1));
        hand.click(2);
        QVERIFY(!hand.window.close()); // it asks; the answer is Cancel
        QCOMPARE(hand.t.answers->asked, 1);
        QCOMPARE(hand.shapes().size(), std::size_t(2));
    }
    void thePolylineIsNotAddedToAnotherDrawing()
    {
        Hand hand;
        hand.click(3);
        hand.window.session().load({app::documentOf(app::Sheet()), {}});
        QVERIFY(hand.shapes().empty() && hand.window.session().history.isClean());
    }
    void undoDuringADragCancelsOnlyTheDrag()
    {
        for (const char* const tool :
             {"line", "rectangle", "ellipse", "pencil", "window", "select"}) {
            Stage stage(ui::Backend::Raster);
            stage.session.history.push(
                addShapes(stage.session.document, {line({20, 20}, {40, 40})}, "line"));
            const app::Sheet before = sheetOf(stage.session.document);
            stage.canvas->setTool(tool);
            stage.move({100, 50});
            stage.press({100, 50});
            stage.move({120, 60}, Qt::LeftButton);
            stage.canvas->undo();
            stage.move({130, 60}, Qt::LeftButton);
            stage.release({130, 60});
            QVERIFY2(sheetOf(stage.session.document) == before
                         && stage.session.history.count() == 1,
                     tool);
        }
    }
    void aMoveWithoutChangeSignalsNothing()
    {
        Hand hand;
        hand.click(2);
        const QSignalSpy told(&hand.window.canvas(), &ui::Canvas::stepsChanged);
        for (int i = 0; i < 50; ++i)
            hand.point(i % 5);
        QCOMPARE(told.count(), 0);
        hand.clickAt(2);
        QCOMPARE(told.count(), 1);
        hand.key(Qt::Key_Backspace);
        QCOMPARE(told.count(), 2);
    }
    // Each signal copies the whole line.
    void aLongFreehandLineIsSignalledRarely()
    {
        constexpr int moves = 400;
        Stage stage(ui::Backend::Raster);
        stage.canvas->setTool("pencil");
        stage.press({100, 50});
        const QSignalSpy told(stage.canvas.get(), &ui::Canvas::stepsChanged);
        QElapsedTimer clock;
        clock.start();
        for (int i = 1; i <= moves; ++i)
            stage.move({100. + i % 200, 50. + i % 7}, Qt::LeftButton);
        QVERIFY2(told.count() <= clock.elapsed() / 100, qPrintable(QString::number(told.count())));
        QTRY_VERIFY(told.count() > 0); // while the pointer rests
        QCOMPARE(stage.canvas->pendingObject()->object.path.subpaths()[0].segments.size(),
                 std::size_t(moves));
        stage.release({100, 60});
        QVERIFY(!stage.canvas->pendingObject());
    }
    void theHintExplainsUndo()
    {
        const QString hint = ui::findTool("polyline")->hint;
        QVERIFY2(hint.contains("Ctrl+Z") && !hint.contains("cancel"), qPrintable(hint));
    }

private:
    /// A window with an empty drawing, and functions that place corners.
    struct Hand {
        Hand() : window(*t.window)
        {
            window.session().load({app::documentOf(app::Sheet()), {}});
            t.show();
            window.canvas().setTool("polyline");
            window.canvas().setSnapping(app::SnapTo::Nothing);
        }
        app::Point place(int corner) const { return {40 + 50 * corner, corner % 2 ? 150 : 60}; }
        QPoint screen(int corner) const
        {
            const app::Point s = window.canvas().view().toScreen(place(corner));
            return {qRound(s.x), qRound(s.y)};
        }
        void point(int corner) { QTest::mouseMove(t.drawingArea(), screen(corner)); }
        void clickAt(int corner)
        {
            QTest::mouseClick(t.drawingArea(), Qt::LeftButton, {}, screen(corner));
        }
        void click(int count)
        {
            for (int i = 0; i < count; ++i)
                clickAt(i);
        }
        void key(Qt::Key key) { QTest::keyClick(t.drawingArea(), key); }
        void undo() { t.action("undo")->trigger(); }
        void redo() { t.action("redo")->trigger(); }
        std::vector<app::Shape> shapes() const { return sheetOf(window.session().document).shapes; }
        /// Rounded: a click hits whole pixels.
        std::vector<app::Point> corners(std::size_t shape) const
        {
            if (shape >= shapes().size())
                return {};
            const app::Subpath path = shapes()[shape].paths[0];
            std::vector<app::Point> all{nearest(path.start)};
            for (const app::PathSegment& segment : path.segments)
                all.push_back(nearest(segment.to));
            return all;
        }
        std::vector<app::Point> placed(int count) const
        {
            std::vector<app::Point> all;
            for (int i = 0; i < count; ++i)
                all.push_back(place(i));
            return all;
        }
        app::Point nearest(const app::Point& p) const
        {
            for (int i = 0; i < 5; ++i)
                if (near(p, place(i), 1))
                    return place(i);
            return p;
        }

        ui::TestWindow t;
        ui::MainWindow& window;
    };

    using Ending = std::pair<QString, std::function<void(Hand&)>>;
    static std::vector<Ending> endings()
    {
        std::vector<Ending> all{
            {"Enter", [](Hand& hand) { hand.key(Qt::Key_Return); }},
            {"Esc", [](Hand& hand) { hand.key(Qt::Key_Escape); }},
            {"Crop",
             [](Hand& hand) {
                 hand.window.files().cutPermanently(app::permanentCut("crop"));
                 hand.window.files().wait();
             }},
            {"panes",
             [](Hand& hand) { // fewer or more panes: the view changes
                 app::Panes panes = hand.window.canvas().panes();
                 panes.show(2);
                 hand.window.canvas().setPanes(panes);
             }},
            {"microscope", [](Hand& hand) { hand.window.drawnLine().look(); }},
        };
        for (const ui::ToolInfo& info : ui::tools())
            if (info.key != "polyline")
                all.emplace_back(
                    info.name, [key = info.key](Hand& hand) { hand.window.canvas().setTool(key); });
        return all;
    }
};

} // namespace tools_polyline_test

TEST_CLASS(tools_polyline_test::PolylineTest, Widgets)
#include "tests/ui/tools/polyline_test.moc"

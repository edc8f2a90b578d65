// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"
#include "app/scene/bounds.h"
#include "app/session/units.h"
#include "app/session/window_steps.h"
#include "ui/tools/tool.h"

#include <QDir>

#include <glm/geometric.hpp>

#include <set>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_tools_test {

// Every tool with real events, and its effect on the drawing and the undo list.
class ToolsTest : public QObject {
    Q_OBJECT

private slots:
    void theCatalogueNamesEveryFile()
    {
        const QDir folder(QStringLiteral(SOURCE_DIR "/ui/tools"));
        QStringList files = folder.entryList({"*_tool.cpp"}), keys;
        std::set<QString> shortcuts;
        for (const ui::ToolInfo& info : ui::tools()) {
            keys << QString::fromUtf8(info.key.data(), qsizetype(info.key.size())) + "_tool.cpp";
            QVERIFY(!info.name.isEmpty() && !info.hint.isEmpty() && info.make());
            QVERIFY(shortcuts.insert(info.shortcut.toString()).second);
        }
        keys.sort();
        QCOMPARE(files, keys);
    }

    void drawsALine()
    {
        Stage stage(raster, {});
        stage.canvas->setTool("line");
        stage.session.pen.style.width = 3;
        stage.drag({20, 30}, {70, 60});
        QCOMPARE(shapes(stage).size(), std::size_t(1));
        const app::Subpath path = shapes(stage)[0].paths[0];
        QVERIFY(near(path.start, {20, 30}) && near(path.segments[0].to, {70, 60}) && !path.closed);
        QCOMPARE(shapes(stage)[0].style.width, 3.0);
        const QString step = stage.session.history.undoText();
        QVERIFY2(step.startsWith("Draw line, 58."), qPrintable(step)); // of 50 and 30
        stage.drag({20, 90}, {120, 84}, Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(shapes(stage)[1].paths[0].segments[0].to.y, shapes(stage)[1].paths[0].start.y);
        stage.click({100, 10});
        QCOMPARE(stage.session.history.count(), 2); // a click is no line
    }

    void escapeCancelsTheGesture()
    {
        std::size_t drawing = 0;
        for (const ui::ToolInfo& tool : ui::tools()) {
            if (!tool.draws())
                continue;
            ++drawing;
            Stage stage(raster, {});
            stage.canvas->setTool(tool.key);
            stage.press({20, 30});
            stage.move({70, 60}, Qt::LeftButton);
            stage.key(Qt::Key_Escape);
            stage.release({70, 60});
            QCOMPARE(stage.session.history.count(), 0);
            QCOMPARE(stage.canvas->tool(), tool.key); // Esc backs out one level
            stage.key(Qt::Key_Escape);
            QCOMPARE(stage.canvas->tool(), std::string_view("select"));
        }
        QVERIFY(drawing >= 5);
    }

    void drawsAPolyline()
    {
        Stage stage(raster, {});
        stage.canvas->setTool("polyline");
        for (const app::Point p : {app::Point(10, 10), {40, 12}, {99, 99}, {60, 40}}) {
            stage.click(p);
            if (p.x == 99)
                stage.key(Qt::Key_Backspace);
        }
        stage.key(Qt::Key_Return);
        QCOMPARE(shapes(stage).size(), std::size_t(1));
        const app::Subpath path = shapes(stage)[0].paths[0];
        QCOMPARE(path.segments.size(), std::size_t(2));
        QVERIFY(near(path.segments[0].to, {40, 12}) && near(path.segments[1].to, {60, 40}));
        QCOMPARE(stage.session.history.count(), 1);

        stage.click({110, 10});
        stage.click({140, 10});
        QTest::mouseDClick(&stage.surface(), Qt::LeftButton, {}, stage.at({140, 40}));
        QCOMPARE(shapes(stage).size(), std::size_t(2));
    }

    void closesAPolylineAtItsStart()
    {
        Stage stage(raster, {});
        stage.canvas->setTool("polyline");
        for (const app::Point p : {app::Point(10, 10), {40, 12}, {30, 44}, {10.5, 10.5}})
            stage.click(p);
        QVERIFY(shapes(stage).size() == 1 && shapes(stage)[0].paths[0].closed);
        QCOMPARE(shapes(stage)[0].paths[0].segments.size(), std::size_t(2));
    }

    void drawsFreehandWithFewPoints()
    {
        Stage stage(raster, {});
        stage.canvas->setTool("pencil");
        stage.press({20, 50});
        for (int i = 1; i <= 100; ++i)
            stage.move({20 + i, 50 + 20 * std::sin(i * 0.06)}, Qt::LeftButton);
        stage.release({120, 50 + 20 * std::sin(6.0)});
        QCOMPARE(shapes(stage).size(), std::size_t(1));
        const auto segments = shapes(stage)[0].paths[0].segments;
        QVERIFY(segments.size() >= 2 && segments.size() < 12);
        QVERIFY(near(segments.back().to, {120, 50 + 20 * std::sin(6.0)}));
    }

    void drawsRectanglesAndEllipses()
    {
        Stage stage(raster, {});
        stage.canvas->setTool("rectangle");
        stage.drag({90, 60}, {30, 20});
        QVERIFY(near(bounds(stage, 0), {{30, 20}, {90, 60}}));
        QVERIFY(shapes(stage)[0].paths[0].closed);
        stage.drag({100, 50}, {120, 55}, Qt::LeftButton, Qt::ShiftModifier | Qt::AltModifier);
        QVERIFY(near(bounds(stage, 1), {{80, 30}, {120, 70}}));
        stage.canvas->setTool("ellipse");
        stage.drag({20, 10}, {180, 90}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(near(bounds(stage, 2), {{20, 10}, {180, 90}}));
        const app::SceneLines& lines = stage.session.scene.lines();
        for (std::size_t i = lines.firstLineOf(2); i < lines.size(); ++i) {
            const clipping::Segment s = lines[i];
            const app::Point unit = (s.a - app::Point(100, 50)) / app::Point(80, 40);
            QVERIFY(std::abs(glm::length(unit) - 1) < 1e-3);
        }
    }

    void snapsToEndsMiddlesAndTheWindow()
    {
        Stage stage(raster);
        stage.canvas->setTool("line");
        stage.drag({11, 51}, {101.5, 20.5}); // the line's end, the window's upper edge
        QCOMPARE(shapes(stage)[1].paths[0].start, app::Point(10, 50));
        QCOMPARE(shapes(stage)[1].paths[0].segments[0].to.y, 20.0);
        stage.drag({11, 51}, {30, 70}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(shapes(stage)[2].paths[0].start != app::Point(10, 50));
        stage.drag({20, 90}, {99, 51}); // the middle
        QCOMPARE(shapes(stage)[3].paths[0].segments[0].to, app::Point(100, 50));
        stage.canvas->setSnapping(app::SnapTo::Nothing);
        stage.drag({20, 80}, {11, 51});
        QVERIFY(shapes(stage)[4].paths[0].segments[0].to != app::Point(10, 50));
    }

    void aClickSelects()
    {
        Stage stage(raster,
                    {line({10, 10}, {60, 10}), line({10, 30}, {40, 30}), line({10, 90}, {60, 90})});
        stage.click({30, 11});
        QCOMPARE(stage.session.selection(), Set{0});
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(0));
        stage.click({30, 31}, Qt::ShiftModifier);
        QCOMPARE(stage.session.selection(), (Set{0, 1}));
        stage.click({30, 11}, Qt::ShiftModifier);
        QCOMPARE(stage.session.selection(), Set{1});
        stage.click({100, 50});
        QVERIFY(stage.session.selection().empty() && !stage.session.inspected());
    }

    void boxesSelectContainedOrTouchedObjects()
    {
        Stage stage(raster, {line({100, 40}, {140, 42}), line({90, 60}, {190, 60}),
                             line({10, 95}, {60, 95})});
        stage.drag({80, 30}, {146, 70});
        QCOMPARE(stage.session.selection(), Set{0});
        stage.drag({146, 70}, {80, 30});
        QCOMPARE(stage.session.selection(), (Set{0, 1}));
        QCOMPARE(stage.session.history.count(), 0);
    }

    void dragsMoveAndDeleteRemoves()
    {
        Stage stage(raster, {line({60, 40}, {140, 42}), line({70, 60}, {130, 60})});
        stage.drag({100, 41}, {110, 46}); // not selected before: it is now
        QCOMPARE(stage.session.selection(), Set{0});
        QVERIFY(near(shapes(stage)[0].paths[0].start, {70, 45}));
        QCOMPARE(stage.session.history.count(), 1);
        const double millimetre = 96 / 25.4;
        const app::Point before = shapes(stage)[0].paths[0].start;
        stage.key(Qt::Key_Down);
        stage.key(Qt::Key_Down);
        QVERIFY(
            near(shapes(stage)[0].paths[0].start, before + app::Point(0, 2 * millimetre), 1e-9));
        QCOMPARE(stage.session.history.count(), 2);
        stage.key(Qt::Key_Right, Qt::AltModifier); // the window, whatever is selected
        QVERIFY(near(sheetOf(stage.session.document).window.min, {50 + millimetre, 20}, 1e-9));
        stage.key(Qt::Key_Delete);
        QCOMPARE(shapes(stage).size(), std::size_t(1));
        QVERIFY(stage.session.selection().empty());
        while (stage.session.history.canUndo())
            stage.session.history.undo();
        QCOMPARE(shapes(stage)[0].paths[0].start, app::Point(60, 40));
    }

    void areasAreSelectedByAClickAndBoxesStartOnThem()
    {
        app::Shape ground = line({0, 0}, {200, 0});
        ground.paths[0].segments.insert(ground.paths[0].segments.end(), {{{200, 100}}, {{0, 100}}});
        ground.paths[0].closed = true;
        ground.style.fill = app::Colour{250, 250, 250};
        Stage stage(raster, {ground, line({100, 40}, {120, 40})});
        stage.click({70, 60});
        QCOMPARE(stage.session.selection(), Set{0});
        stage.session.select({});
        stage.drag({80, 30}, {130, 60});
        QCOMPARE(stage.session.selection(), Set{1});
        QCOMPARE(stage.session.history.count(), 0);
    }

    void theSelectionBoxResizesTheSelection()
    {
        Stage stage(raster, {line({70, 40}, {90, 40}), line({70, 60}, {80, 60})});
        stage.session.select({0, 1}); // 70, 40 to 90, 60
        stage.drag({90, 60}, {110, 70});
        QVERIFY(near(bounds(stage, 0), {{70, 40}, {110, 40}}));
        QVERIFY(near(bounds(stage, 1), {{70, 70}, {90, 70}}));
        QCOMPARE(stage.session.history.undoText(), QString("Resize selection"));
        stage.session.history.undo();
        QCOMPARE(bounds(stage, 0), (clipping::Window{{70, 40}, {90, 40}}));
    }

    void theHandlesObeyTheChoiceForStrokes()
    {
        for (const bool scales : {false, true}) {
            Stage stage(raster, {line({70, 40}, {90, 40}), line({70, 60}, {80, 60})});
            const double width = stage.session.now().objects()[0].style().width;
            stage.session.arrange.strokes =
                scales ? app::StrokeScaling::Scale : app::StrokeScaling::Keep;
            stage.session.select({0, 1}); // 70, 40 to 90, 60
            stage.drag({90, 60}, {110, 80});
            QVERIFY(near(bounds(stage, 0), {{70, 40}, {110, 40}}));
            const double now = stage.session.now().objects()[1].style().width;
            QVERIFY(std::abs(now - width * (scales ? 2 : 1)) < 0.1 * width);
            stage.session.history.undo();
            QCOMPARE(stage.session.now().objects()[1].style().width, width);
        }
    }

    // Hovering and painting use the stored box, however many objects are selected. A different box,
    // put in its place, stays until something changes.
    void theSelectionBoxIsCalculatedOnce()
    {
        Stage stage(raster, {line({70, 40}, {90, 40}), line({70, 60}, {80, 60})});
        stage.session.select({0, 1});
        stage.move({150, 95});
        // The box lies 6 pixels outside: 3 in the drawing.
        const QColor page = stage.colourAt({35, 7});
        using Bounds = std::optional<clipping::Window>;
        auto& known = const_cast<Bounds&>(stage.session.selectionBounds());
        known = clipping::Window{{20, 10}, {180, 90}};
        stage.move({20, 10});
        QCOMPARE(stage.surface().cursor().shape(), Qt::SizeFDiagCursor);
        QVERIFY(stage.colourAt({35, 7}) != page);
        stage.move({100, 51});
        QVERIFY(stage.colourAt({35, 7}) != page);
        QCOMPARE(stage.session.selectionBounds(), Bounds({{20, 10}, {180, 90}}));
        stage.key(Qt::Key_Down);
        QCOMPARE(stage.session.selectionBounds(),
                 app::boundsOf(stage.session.scene.lines(), stage.session.selection()));
        QCOMPARE(stage.colourAt({35, 7}), page);
    }

    void lockedLayersAreNotTouched()
    {
        Stage stage(raster);
        ::setLayers(stage.session.document, {{"Drawing", true, true}});
        stage.click({100, 50});
        QVERIFY(stage.session.selection().empty());
    }

    void nothingIsDrawnOnALockedLayer()
    {
        Stage stage(raster, {});
        ::setLayers(stage.session.document, {{"Drawing", true, true}});
        stage.canvas->setTool("line");
        stage.drag({20, 30}, {70, 60});
        QCOMPARE(stage.session.history.count(), 0);
        QCOMPARE(stage.surface().cursor().shape(), Qt::ForbiddenCursor);
        QVERIFY(stage.canvas->toolHint().contains("Drawing"));
    }

    // The hint is requested during the change.
    void theLayerToDrawOnMayDisappear()
    {
        Stage stage(raster);
        app::Session& session = stage.session;
        stage.canvas->setTool("line");
        for (int i = 0; i < 300; ++i) { // more than one block of the table of containers
            session.history.push(addLayer(session.document, "above"));
            session.pen.layer = session.now().containers().childrenOf(0).back();
        }
        const auto penIsOnALayer = [&] {
            return !stage.canvas->toolHint().isEmpty()
                   && session.now().containers().contains(session.pen.layer);
        };
        session.history.undo();
        QVERIFY(penIsOnALayer());
        session.pen.layer = session.now().containers().childrenOf(0).back();
        session.history.push(new app::RemoveLayer(session.document, session.pen.layer));
        QVERIFY(penIsOnALayer());
        session.pen.layer = session.now().containers().childrenOf(0).back();
        session.load({});
        QVERIFY(penIsOnALayer());
    }

    void theHintNamesTheHoveredLine()
    {
        Stage stage(raster);
        const QString usual = stage.canvas->toolHint();
        stage.move({100, 51});
        QVERIFY(stage.canvas->toolHint().startsWith("Line 1 in Drawing."));
        stage.move({100, 90});
        QCOMPARE(stage.canvas->toolHint(), usual);
    }

    void theHintSaysWhatCanBeDoneWithTheHoveredWindow()
    {
        Stage stage(raster);
        stage.move({50, 20});
        QCOMPARE(stage.canvas->toolHint(),
                 "Drag: resize the clip window Rectangle. Right click: its menu.");
        stage.move({75, 20});
        QCOMPARE(stage.canvas->toolHint(),
                 "Drag: move the clip window Rectangle. Right click: its menu.");
        app::removeWindow(stage.session); // below the pointer, which does not move
        QVERIFY(!stage.canvas->toolHint().contains("clip window Rectangle"));
    }

    void theHintSaysWhatTheHoveredObjectIs()
    {
        app::Shape circle = line({}, {});
        circle.paths = {*app::outlineOf(app::EllipseRecipe{{100, 51}, {20, 10}})};
        circle.id = QStringLiteral("sun");
        Stage stage(raster, {circle});
        stage.move({120, 51});
        QVERIFY(stage.canvas->toolHint().startsWith("Path “sun” in Drawing."));
        stage.session.select({0});
        QCOMPARE(app::selectionText(stage.session), QStringLiteral("Path “sun”"));
    }

    void aLineDraggedAtOnceIsInspected()
    {
        Stage stage(raster, {line({10, 10}, {60, 10}), line({10, 90}, {60, 90})});
        stage.drag({30, 11}, {40, 31});
        QCOMPARE(stage.session.selection(), Set{0});
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(0));
        stage.drag({30, 91}, {40, 71});
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(1));
    }

    void theHintGroupsDigitsAndNamesTheInspectedLine()
    {
        std::vector<app::Shape> many(1200, line({10, 50}, {190, 50}));
        Stage stage(raster, std::move(many));
        const QString usual = stage.canvas->toolHint();
        stage.session.select(app::ObjectRanges(app::ObjectRange{0, 1200}));
        stage.move({100, 90});
        QVERIFY(stage.canvas->toolHint().startsWith("1,200 objects selected."));
        stage.session.select({});
        QCOMPARE(stage.canvas->toolHint(), usual);
        stage.session.inspect(1);
        QVERIFY(stage.canvas->toolHint().startsWith("The Line panel shows line 2."));
    }

    void withoutAClipWindowADragOrTheOfferMakesOne()
    {
        Stage stage(raster, {});
        app::Session& session = stage.session;
        session.document.apply({.windows = app::ClipWindows()});
        stage.key(Qt::Key_W);
        QVERIFY(!session.clipWindow());
        stage.drag({60, 30}, {120, 70});
        QVERIFY(session.clipWindow() && near(*session.clipWindow(), {{60, 30}, {120, 70}}));
        stage.drag({80, 50}, {90, 50}); // now there is one: it moves
        QVERIFY(near(*session.clipWindow(), {{70, 30}, {130, 70}}));
        session.history.setIndex(0);
        QVERIFY(!session.clipWindow());
        const clipping::Window page = session.now().page().rectangle();
        const app::Point handle((page.min.x + page.max.x) / 2, page.max.y);
        stage.canvas->zoomBy(0.5); // so that there is room for it under the page
        const QPoint under = stage.at(handle) + QPoint(0, 13 + 8);
        QTest::mouseClick(&stage.surface(), Qt::LeftButton, {}, under);
        QCOMPARE(session.clipWindow(), std::optional(page));
        QCOMPARE(session.history.undoText(), "Lay clip window on page");
    }

    void aDoubleClickOnTheOfferDoesNotReachTheTool()
    {
        Stage stage(raster, {line({10, 50}, {190, 50}), line({-300, 121}, {500, 121})});
        app::Session& session = stage.session;
        session.document.apply({.windows = app::ClipWindows()});
        stage.canvas->zoomBy(0.5);
        session.select({0});
        const QPoint under = stage.at({100, 121}); // on the offer, which hides the second line
        const auto doubleClick = [&] {
            QTest::mouseClick(&stage.surface(), Qt::LeftButton, {}, under);
            QTest::mouseDClick(&stage.surface(), Qt::LeftButton, {},
                               under); // the second press of the double click
            QTest::mouseRelease(&stage.surface(), Qt::LeftButton, {}, under);
        };
        for (int twice = 0; twice < 2; ++twice) {
            doubleClick();
            QCOMPARE(stage.canvas->tool(), std::string_view("select"));
            QCOMPARE(session.selection(), app::ObjectRanges{0});
            QCOMPARE(session.clipWindow(), std::optional(session.now().page().rectangle()));
            QCOMPARE(session.history.count(), 1);
            session.history.undo(); // it is offered again
        }
        session.history.redo();
        stage.click({100, 121}); // the next click is the tool's
        QCOMPARE(session.selection(), app::ObjectRanges{1});
        doubleClick();
        QCOMPARE(stage.canvas->tool(), std::string_view("nodes"));
    }

    void theSnapMarkDisappearsAfterTheDrag()
    {
        Stage stage(raster, {});
        stage.key(Qt::Key_L);
        stage.move({20, 90});
        const QColor free = stage.colourAt({25, 90}); // where the mark's ring would be, 3 units off
        stage.drag({20, 50}, {20, 90});
        const auto ring = [&] {
            const QImage picture = stage.picture();
            const QPoint end = stage.at({20, 90});
            for (int dx = 4; dx <= 9; ++dx)
                if (picture.pixelColor(end + QPoint(dx, 0)) != free)
                    return true;
            return false;
        };
        QVERIFY(!ring());
        stage.move({20.4, 90}); // hovering near the end, it is what a new line would start at
        QVERIFY(ring());
        stage.session.history.undo();
        QVERIFY(!ring());
    }

    void theSelectToolDragsTheWindowToo()
    {
        Stage stage(raster, {});
        stage.drag({150, 80}, {170, 90}, Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(near(sheetOf(stage.session.document).window, {{50, 20}, {170, 90}}));
        stage.drag({50, 30}, {60, 30});
        QVERIFY(near(sheetOf(stage.session.document).window, {{60, 20}, {180, 90}}));
    }

    void zoomsToARectangle()
    {
        Stage stage(raster);
        stage.key(Qt::Key_Z);
        stage.drag({60, 30}, {100, 50});
        QVERIFY(near(stage.canvas->view().centre, {80, 40}));
        QVERIFY(std::abs(stage.canvas->view().zoom - 20) < 1);
    }

    void aHoveredLineIsHighlighted()
    {
        Stage stage(raster);
        const QColor before = stage.colourAt({100, 50});
        stage.move({100, 51});
        const QColor hovered = stage.colourAt({100, 50});
        QVERIFY2(hovered != before, qPrintable(hovered.name()));
    }

private:
    using Set = app::ObjectRanges;
    static constexpr ui::Backend raster = ui::Backend::Raster;

    static std::vector<app::Shape> shapes(const Stage& stage)
    {
        return sheetOf(stage.session.document).shapes;
    }
    static clipping::Window bounds(const Stage& stage, std::size_t shape)
    {
        return app::boundsOf(stage.session.scene.lines(), {shape}).value();
    }
};

} // namespace tools_tools_test

TEST_CLASS(tools_tools_test::ToolsTest, Widgets)
#include "tests/ui/tools/tools_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/formats/format.h"
#include "app/session/drawn_line.h"

#include <QTest>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace session_drawn_line_test {

namespace {

constexpr clipping::Window window{{0, 0}, {10, 10}};

app::Sheet sheetOf(const std::vector<clipping::Segment>& lines)
{
    app::Sheet sheet;
    sheet.window = window;
    for (const auto& line : lines) {
        app::Shape shape;
        shape.paths.push_back({line.a, {{line.b}}});
        sheet.shapes.push_back(shape);
    }
    return sheet;
}

const clipping::Segment inside{{1, 1}, {2, 2}}, across{{-5, 5}, {15, 6}}, half{{5, 5}, {15, 5}};

} // namespace

class DrawnLineTest : public QObject {
    Q_OBJECT

private slots:
    void itLooksAtALineThatIsCut()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({inside, half, across})), {}});
        drawn.look();
        QVERIFY(session.microscope.isOpen());
        QCOMPARE(drawn.line(), std::size_t(2));
        QCOMPARE(session.microscope.tracedLine().line, across);
        QCOMPARE(session.inspected(), std::size_t(2));
        session.microscope.close();
        session.inspect(0);
        drawn.look();
        QCOMPARE(session.microscope.tracedLine().line, inside);
    }
    void itPassesOverLockedLayers()
    {
        app::Sheet sheet = sheetOf({across, inside, half});
        sheet.layers = {{QStringLiteral("Grid"), true, true}, {QStringLiteral("Lines")}};
        for (const std::size_t shape : {1, 2})
            sheet.shapes[shape].layer = 1;
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheet), {}});
        drawn.look();
        QCOMPARE(session.microscope.tracedLine().line, half);
        session.microscope.close();
        sheet.layers[1].locked = true; // all are
        session.load({app::documentOf(sheet), {}});
        drawn.look();
        QCOMPARE(session.microscope.tracedLine().line, across);
    }
    void sampleWithNineRegionsDoesNotTraceAGridLine()
    {
        const auto read =
            app::readFile(QStringLiteral(SOURCE_DIR "/resources/samples/nine-regions.svg"));
        QVERIFY2(read.value.has_value(), qPrintable(read.error));
        app::Session session;
        app::DrawnLine drawn(session);
        session.load(*read.value);
        drawn.look();
        const auto& [a, b] = session.microscope.tracedLine().line;
        QVERIFY(a.x != b.x && a.y != b.y);
        const auto piece = session.microscope.narration().visible;
        QVERIFY(piece && (piece->a != a || piece->b != b));
    }
    void anEmptyDrawingHasALineToo()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({})), {}});
        drawn.look();
        QVERIFY(session.microscope.isOpen());
        QVERIFY(!drawn.line());
        QVERIFY(session.microscope.narration().visible);
        drawn.go(1); // nowhere to go
        QVERIFY(!drawn.line());
    }
    void itFollowsTheDrawing()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across, half})), {}});
        drawn.look(0);
        session.history.push(windowStep(session.document, {{0, 0}, {8, 8}}));
        QCOMPARE(session.microscope.tracedLine().window, (clipping::Window{{0, 0}, {8, 8}}));
        session.history.push(new app::MoveObjects(session.document, {0}, {1, 0}));
        QCOMPARE(session.microscope.tracedLine().line, (clipping::Segment{{-4, 5}, {16, 6}}));
        session.history.undo();
        QCOMPARE(session.microscope.tracedLine().line, across);
        app::Display display = session.display();
        display.variant.algorithm = clipping::findAlgorithm("skala");
        session.setDisplay(display);
        QCOMPARE(session.microscope.tracedLine().variant.algorithm, display.variant.algorithm);
        session.inspect(1);
        QCOMPARE(session.microscope.tracedLine().line, half);
    }
    void whatIsChangedByHandStays()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across, half})), {}});
        const app::Document before = session.now();
        drawn.look(0);
        app::TracedLine tracedLine = session.microscope.tracedLine();
        tracedLine.line.a = {-7, 3};
        session.microscope.setTracedLine(tracedLine);
        QVERIFY(drawn.changed());
        QVERIFY(session.now() == before);
        session.history.push(windowStep(session.document, {{0, 0}, {8, 8}}));
        QCOMPARE(session.microscope.tracedLine().line.a, app::Point(-7, 3));
        QCOMPARE(session.microscope.tracedLine().window.max, app::Point(8, 8));
        session.history.push(new app::MoveObjects(session.document, {0}, {1, 0}));
        QCOMPARE(session.microscope.tracedLine().line.a, app::Point(-7, 3));
        drawn.back();
        QVERIFY(!drawn.changed());
        QCOMPARE(session.microscope.tracedLine().line, (clipping::Segment{{-4, 5}, {16, 6}}));
    }
    void knowsWhetherItIsClippedAtThePage()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        app::Document document = app::documentOf(sheetOf({across}));
        document.apply({.windows = app::ClipWindows()});
        session.load({document, {}});
        drawn.look(0);
        QVERIFY(session.microscope.tracedLine().windowIsPage);
        session.history.push(windowStep(session.document, {{0, 0}, {8, 8}}));
        QVERIFY(!session.microscope.tracedLine().windowIsPage);
        session.history.undo();
        QVERIFY(session.microscope.tracedLine().windowIsPage);
    }
    void aLineThatGoesStaysUnderTheMicroscope()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across})), {}});
        drawn.look(0);
        session.history.push(new app::RemoveObjects(session.document, {0}));
        QCOMPARE(session.microscope.tracedLine().line, across);
        QVERIFY(!drawn.line());
        drawn.back(); // nowhere
        QCOMPARE(session.microscope.tracedLine().line, across);
    }
    void aLessonsLineIsLeftAlone()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across, half})), {}});
        drawn.look(0);
        const app::TracedLine lesson{.variant = {clipping::findAlgorithm("cs")},
                                     .line = {{0, 0}, {3, 3}},
                                     .window = {{1, 1}, {2, 2}},
                                     .y = app::YAxis::Up};
        session.microscope.setTracedLine(lesson);
        QVERIFY(!drawn.line());
        session.history.push(windowStep(session.document, {{0, 0}, {8, 8}}));
        session.inspect(1);
        app::Display display = session.display();
        display.variant.algorithm = clipping::findAlgorithm("skala");
        session.setDisplay(display);
        QCOMPARE(session.microscope.tracedLine(), lesson);
        drawn.choose({clipping::findAlgorithm("lb")});
        QCOMPARE(session.display().variant.algorithm, clipping::findAlgorithm("skala"));
        QCOMPARE(session.microscope.tracedLine().variant.algorithm, clipping::findAlgorithm("lb"));
    }
    void choosingClipsTheDrawingToo()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across})), {}});
        drawn.look(0);
        drawn.choose({clipping::findAlgorithm("cs"), clipping::Form::Published});
        QCOMPARE(session.display().variant.algorithm, clipping::findAlgorithm("cs"));
        QCOMPARE(session.display().variant.form, clipping::Form::Published);
        QCOMPARE(session.microscope.tracedLine().variant.form, clipping::Form::Published);
    }
    void aMisprintIsOnlyLookedAt()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across, half})), {}});
        drawn.look(0);
        const app::Variant before = session.variant(), misprint = *app::findVariant("md-step-2");
        drawn.choose(misprint);
        QVERIFY(session.variant() == before);
        QVERIFY(session.microscope.tracedLine().variant == misprint);
        QCOMPARE(drawn.line(), std::size_t(0)); // and it is still the drawing's line
        drawn.go(1);
        QCOMPARE(drawn.line(), std::size_t(1));
        QVERIFY(session.microscope.tracedLine().variant == misprint);
    }
    void linesGoRoundAndRound()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({inside, across, half})), {}});
        drawn.look(0);
        drawn.go(-1);
        QCOMPARE(drawn.line(), std::size_t(2));
        drawn.go(1);
        QCOMPARE(drawn.line(), std::size_t(0));
    }
    void inspectedLineFollowsIntoTheMicroscope()
    {
        app::Session session;
        app::DrawnLine drawn(session);
        session.load({app::documentOf(sheetOf({across, half})), {}});
        drawn.look(1);
        const app::TracedLine tracedLine = session.microscope.tracedLine();
        session.microscope.close();
        session.microscope.open(tracedLine);
        QCOMPARE(drawn.line(), std::size_t(1));
    }
};

} // namespace session_drawn_line_test

TEST_CLASS(session_drawn_line_test::DrawnLineTest, Core)
#include "tests/app/session/drawn_line_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/transform_objects.h"
#include "app/document/contents.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/session/live_sheets.h"
#include "app/session/window_steps.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_live_sheets_test {

using namespace app;

namespace {

/// 400 × 200 mm with a line across.
Imported wide()
{
    DocumentBuilder builder;
    builder.open({.name = "Drawing"});
    const Subpath line{{0, 100}, {{{400, 100}}}, false};
    builder.add(Object{.path = Path({&line, 1}), .style = {.stroke = Colour{}, .width = 0.5}});
    builder.close();
    return {builder.take(Page{{0, 0}, {400, 200}, {400, Unit::Mm}, {200, Unit::Mm}, {}}), {}};
}

} // namespace

class LiveSheetsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreDividedWhileOpen()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        QSignalSpy opened(&sheets, &LiveSheets::openChanged);
        sheets.open();
        QVERIFY(sheets.isOpen());
        QCOMPARE(opened.size(), 1);
        QCOMPARE(sheets.tiling().value->columns, 3); // 190 + 180 + 180 mm
        QCOMPARE(sheets.tiling().value->rows, 1);
        sheets.close();
        QVERIFY(!sheets.isOpen());
        QVERIFY(session.history.isClean());
    }

    void aCircleCutAtItselfStaysWhole()
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        const EllipseRecipe round{{200, 100}, {80, 80}};
        const Path circle(std::vector{*outlineOf(Recipe(round))});
        builder.add(Object{.path = circle, .style = {.stroke = Colour{}, .width = 0.5}});
        builder.close();
        Document document =
            builder.take(Page{{0, 0}, {400, 200}, {400, Unit::Mm}, {200, Unit::Mm}, {}});
        document.apply({.windows = ClipWindows{{{.shape = PathShape{circle, {}, round}}}}});
        Session session;
        LiveSheets sheets(session);
        session.load({document, {}});
        sheets.open();
        QCOMPARE(sheets.drawing().objects().size(), std::size_t(1));
        QVERIFY(sheets.drawing().objects()[0].path() == circle);
    }

    void settingsThatFailAreNotTaken()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        QSignalSpy changed(&sheets, &LiveSheets::changed);
        SheetSettings next = sheets.settings();
        next.plan.overlap = 190;
        const auto refusal = sheets.change(next);
        QCOMPARE(refusal.value_or(""),
                 "Overlap must be less than 190\u00a0mm, the width of a sheet.");
        QCOMPARE(sheets.settings().plan.overlap, 10.0);
        QVERIFY(changed.empty());
        next.plan.overlap = 20;
        QVERIFY(!sheets.change(next));
        QCOMPARE(changed.size(), 1);
    }

    void settingsStayWhenTheyAreClosed()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        SheetSettings next = sheets.settings();
        next.landscape = true;
        QVERIFY(!sheets.change(next));
        QCOMPARE(sheets.tiling().value->columns, 2);
        sheets.close();
        sheets.open();
        QVERIFY(sheets.settings().landscape);
    }

    void theDivisionIsSavedWithTheDrawing()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        sheets.close();
        QVERIFY(session.history.isClean()); // nothing was chosen
        sheets.open();
        SheetSettings next = sheets.settings();
        next.plan.overlap = 25;
        next.plan.leftOut = {2};
        QVERIFY(!sheets.change(next));
        sheets.keep(); // before the document is saved
        const Document saved = session.now();
        sheets.close();
        QCOMPARE(session.history.count(), 1);
        QVERIFY(saved.page().sheets == static_cast<const PageSheets&>(next));

        LiveSheets others(session);
        session.load(wide());
        others.open();
        QCOMPARE(others.settings().plan.overlap, 10.0);
        session.load({saved, {}});
        QCOMPARE(others.settings().plan.overlap, 25.0);
        QCOMPARE(others.tiling().value->written(), 2);
        others.close();
        QVERIFY(session.history.isClean());
    }

    void undoGivesTheDivisionBack()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        for (const double overlap : {20.0, 30.0}) {
            sheets.open();
            SheetSettings next = sheets.settings();
            next.plan.overlap = overlap;
            QVERIFY(!sheets.change(next));
            sheets.close();
        }
        session.history.undo();
        sheets.open();
        QCOMPARE(sheets.settings().plan.overlap, 20.0);
        session.history.redo();
        QCOMPARE(sheets.settings().plan.overlap, 30.0);
    }

    // What belongs to one drawing does not pass on to another one.
    void anotherDrawingBeginsAnew()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        SheetSettings next = sheets.settings();
        next.name = "mine-{n}";
        next.plan.leftOut = {2};
        next.plan.overlap = 15;
        QVERIFY(!sheets.change(next));
        QCOMPARE(sheets.tiling().value->written(), 2);
        session.load(wide());
        QCOMPARE(sheets.tiling().value->written(), 3);
        QVERIFY(sheets.settings().name.isEmpty());
        QCOMPARE(sheets.settings().plan.overlap, 15.0);
    }

    // A sheet that is left out has another number when the sheets are others.
    void otherSheetsAreAllThere()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        SheetSettings next = sheets.settings();
        next.plan.leftOut = {2};
        QVERIFY(!sheets.change(next));
        next.landscape = true; // 2 columns × 2 rows
        next.plan.empty = EmptySheets::Written;
        QVERIFY(!sheets.change(next));
        QCOMPARE(sheets.tiling().value->written(), 4);
    }

    void emptySheetsFollowTheDrawing()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        SheetSettings next = sheets.settings();
        next.landscape = true; // 2 columns × 2 rows
        QVERIFY(!sheets.change(next));
        QCOMPARE(sheets.tiling().value->written(), 2); // nothing is in the lower row
        addWindow(session, {.shape = RectangleShape{{{100, 50}, {150, 150}}}});
        sheets.wait();
        QCOMPARE(sheets.tiling().value->written(), 1);
        session.history.undo();
        sheets.wait();
        QCOMPARE(sheets.tiling().value->written(), 2);
    }

    // 100 mm to the left, and back: one column more, and none.
    void sheetsFollowWhatLiesBeyondThePage()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        SheetSettings next = sheets.settings();
        next.plan.leftOut = {1};
        QVERIFY(!sheets.change(next));
        session.history.push(new TransformObjects(session.document, {0}, translation({-100, 0}),
                                                  StrokeScaling::Keep, "Move"));
        QCOMPARE(sheets.tiling().value->beyond.left, 1);
        QCOMPARE(sheets.tiling().value->columns, 4);
        QVERIFY(!sheets.tiling().value->tiles[0].leftOut);
        QVERIFY(sheets.tiling().value->tiles[1].leftOut);
        next = sheets.settings();
        next.byNumber = true;
        next.plan.columns = sheets.tiling().value->pageColumns();
        QVERIFY(!sheets.change(next));
        QCOMPARE(sheets.tiling().value->columns, 4);
        session.history.undo();
        QVERIFY(!sheets.tiling().value->beyond.any());
    }

    void theDrawingIsCutAtItsWindowsFirst()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        QCOMPARE(contentsOf(sheets.drawing()).length, 400.0);
        addWindow(session, {.shape = RectangleShape{{{100, 50}, {150, 150}}}});
        sheets.wait();
        QCOMPARE(contentsOf(sheets.drawing()).length, 50.0);
        QCOMPARE(sheets.scene().lines().size(), 1u);
        QCOMPARE(contentsOf(session.now()).length, 400.0);
    }

    // The sheets have what an exported file has.
    void piecesThatAreTooShortAreDropped()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.open();
        addWindow(session, {.shape = RectangleShape{{{100, 50}, {150, 150}}}});
        app::Display display = session.display();
        display.cutting.leastMillimetres = 60;
        session.setDisplay(display);
        sheets.wait();
        QCOMPARE(contentsOf(sheets.drawing()).length, 0.0);
        QCOMPARE(sheets.sheets().options.leastLength,
                 60 / session.now().page().millimetresPerUnit());
    }

    void namesOfFiles()
    {
        Session session;
        LiveSheets sheets(session);
        session.load(wide());
        sheets.setTitle("rosette");
        sheets.open();
        QCOMPARE(sheets.files(),
                 (QStringList{"rosette-1-1.svg", "rosette-1-2.svg", "rosette-1-3.svg"}));
        const Tiling& tiling = *sheets.tiling().value;
        SheetSettings next = sheets.settings();
        QVERIFY(!sheets.change(*withName(next, "a{n}.pdf", tiling).value));
        QCOMPARE(sheets.files(), (QStringList{"a1.pdf", "a2.pdf", "a3.pdf"}));
        QVERIFY(!sheets.change(withOneFile(sheets.settings(), true)));
        QCOMPARE(sheets.files(), QStringList{"a.pdf"});
        QVERIFY(!sheets.change(withFormat(sheets.settings(), *findFormat(u"svg"))));
        QCOMPARE(sheets.files().front(), "a1.svg");
        QCOMPARE(withName(next, "same.svg", tiling).error,
                 "Each sheet needs a name of its own: put {row} and {column}, or {n}, into it.");
        QCOMPARE(withName(next, "a/{n}", tiling).error,
                 "A name must not contain “/”. The folder is chosen later.");
    }
};

} // namespace session_live_sheets_test

TEST_CLASS(session_live_sheets_test::LiveSheetsTest, Core)
#include "tests/app/session/live_sheets_test.moc"

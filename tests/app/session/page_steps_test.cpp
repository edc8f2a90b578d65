// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_page_parts.h"
#include "app/document/document_builder.h"
#include "app/document/paper.h"
#include "app/session/page_steps.h"
#include "app/session/selection_numbers.h"
#include "app/session/selection_style.h"

#include <QSignalSpy>
#include <QTest>

#include <limits>

#include "tests/test_class.h"

namespace session_page_steps_test {

using namespace app;

class PageStepsTest : public QObject {
    Q_OBJECT

    /// A4, landscape; a line of 100 mm with a stroke of 0.5 mm, and one beyond the page.
    struct Plan : Session {
        Plan()
        {
            DocumentBuilder builder;
            builder.open({.name = "Walls"});
            builder.add(line({20, 30}, {120, 30}));
            builder.add(line({290, 200}, {400, 200}));
            builder.close();
            load({builder.take({}), {}});
            pen.style.width = 0.3;
        }
        static Object line(const Point& a, const Point& b)
        {
            const Subpath path{a, {{b}}, false};
            Style style{.stroke = Colour{}, .width = 0.5};
            style.dashes = {2, 1};
            return {.path = Path(std::span(&path, 1)), .style = style};
        }
        const Page& page() const { return now().page(); }
        Style style() const { return now().objects()[0].style(); }
        double widthOnPaper() const { return style().width * page().millimetresPerUnit(); }
    };
    static bool near(double a, double b) { return std::abs(a - b) < 1e-9; }

private slots:
    void aNewScaleChangesThePageAndNoLength()
    {
        Plan plan;
        PageEditing editing(plan);
        const auto before = *plan.now().objects()[0].singleLine();
        QCOMPARE(editing.change(withScale(plan.page(), 50)), std::nullopt);
        QCOMPARE(plan.page().size, Point(297 * 50, 210 * 50));
        QCOMPARE(millimetresOf(plan.page()), Point(297, 210));
        QVERIFY(*plan.now().objects()[0].singleLine() == before);
        QVERIFY(plan.page().realMillimetresPerUnit() == 1);
        QVERIFY(near(plan.widthOnPaper(), 0.5));
        QVERIFY(near(plan.style().dashes[0] * plan.page().millimetresPerUnit(), 2));
        QVERIFY(near(plan.pen.style.width * plan.page().millimetresPerUnit(), 0.3));
    }
    // A file that gives no size on paper: a pixel is a unit.
    void aPageWithoutASizeGetsOne()
    {
        Page page{{0, 0}, {960, 480}, {100, Unit::Percent}, {100, Unit::Percent}};
        const Point paper = millimetresOf(page);
        const auto scaled = withScale(page, 50);
        QVERIFY(scaled);
        const Point after = millimetresOf(*scaled.value);
        QVERIFY(near(after.x, paper.x) && near(after.y, paper.y));
        QVERIFY(near(scaled.value->realMillimetresPerUnit(), 25.4 / 96));
    }

    void allChangesAreOneStep()
    {
        Plan plan;
        const Document before = plan.now();
        PageEditing editing(plan);
        QCOMPARE(editing.change(withPaper(plan.page(), {420, 297})), std::nullopt);
        QCOMPARE(editing.change(withScale(plan.page(), 50)), std::nullopt);
        QCOMPARE(editing.change(withScale(plan.page(), 100)), std::nullopt);
        QCOMPARE(plan.history.count(), 1);
        QCOMPARE(plan.history.undoText(), "Change page");
        QCOMPARE(plan.page().scale.ratio, 100.0);
        QCOMPARE(millimetresOf(plan.page()), Point(420, 297));
        plan.history.undo();
        QCOMPARE(plan.now(), before);
        QVERIFY(near(plan.pen.style.width, 0.3));
        plan.history.redo();
        QVERIFY(near(plan.widthOnPaper(), 0.5));
    }
    void cancelGoesBehindOtherSteps()
    {
        Plan plan;
        PageEditing editing(plan);
        const Page before = plan.page();
        editing.change(withScale(plan.page(), 50));
        editing.cancel();
        QCOMPARE(plan.page(), before);
        QVERIFY(!plan.history.canUndo());
        editing.change(withScale(plan.page(), 50));
        plan.history.push(new SetGuides(plan.document, {{{0, 20}}}, "Guide"));
        editing.change(withPaper(plan.page(), {210, 297})); // after the guide
        QCOMPARE(plan.history.count(), 3);
        plan.history.undo();
        editing.cancel();
        QCOMPARE(plan.page().size, before.size);
        QCOMPARE(plan.page().scale, before.scale);
        QCOMPARE(plan.page().guides.list.size(), std::size_t(1));
        QVERIFY(near(plan.style().width, 0.5));
    }
    void backAtTheFirstPageIsNoStep()
    {
        Plan plan;
        PageEditing editing(plan);
        editing.change(Result<Page>::of(turnedPage(plan.page())));
        QCOMPARE(plan.page().size, Point(210, 297));
        editing.change(Result<Page>::of(turnedPage(plan.page())));
        QVERIFY(!plan.history.canUndo());
        QCOMPARE(plan.page().size, Point(297, 210));
    }
    void badNumbersChangeNothing_data()
    {
        QTest::addColumn<double>("number");
        for (const double number : {0.0, -1.0, 1e30, std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN()})
            QTest::addRow("%g", number) << number;
    }
    void badNumbersChangeNothing()
    {
        QFETCH(const double, number);
        Plan plan;
        PageEditing editing(plan);
        const Document before = plan.now();
        const Page& page = plan.page();
        const auto sentence = [&](const Result<Page>& result) {
            const QString why = editing.change(result).value_or(QString());
            return why.endsWith(u'.') && why.size() > 20;
        };
        QVERIFY(sentence(withScale(page, number)));
        QVERIFY(sentence(withPaper(page, {number, 210})));
        QVERIFY(sentence(withPaper(page, {297, number})));
        if (number != 0)
            QVERIFY(sentence(withMargins(page, {.left = number})));
        QCOMPARE(plan.now(), before);
        QVERIFY(!plan.history.canUndo());
    }
    void aPageOfAHundredKilometresIsRefused()
    {
        const Plan plan;
        QVERIFY(!withPaper(plan.page(), {1e8, 297}));
        QVERIFY(withPaper(plan.page(), {1e5, 297}));
        QVERIFY(!withMargins(plan.page(), {150, 10, 147, 10}));
        QVERIFY(withMargins(plan.page(), {150, 10, 146, 10}));
        QVERIFY(!fittedPage(plan.page(), std::nullopt));
        QVERIFY(!fittedPage(plan.page(), clipping::Window{{0, 0}, {1e9, 1}}));
    }
    void aPageFitsAroundWhatIsDrawn()
    {
        Plan plan;
        PageEditing editing(plan);
        editing.change(withScale(plan.page(), 10));
        editing.change(withMargins(plan.page(), {20, 10, 10, 10, true}));
        QCOMPARE(editing.change(fittedPage(plan.page(), drawingBox(plan))), std::nullopt);
        QCOMPARE(plan.page().min, Point(20 - 200, 30 - 100)); // margins are on paper
        QCOMPARE(plan.page().rectangle().max, Point(400 + 100, 200 + 100));
        QVERIFY(checkedPage(plan).outside.empty());
        QVERIFY(near(millimetresOf(plan.page()).x, 38 + 30));
        QVERIFY(!windowsBox(plan));
    }
    void objectsOutsideAreCounted()
    {
        Plan plan;
        QCOMPARE(checkedPage(plan).outside, ObjectRanges({1}));
        QCOMPARE(checkedPage(plan).text, "1 object lies outside the page.");
        PageEditing editing(plan);
        editing.change(withMargins(plan.page(), {25, 0, 0, 0, true}));
        QCOMPARE(checkedPage(plan).text, "2 objects lie outside the margins.");
        editing.change(withPaper(plan.page(), {400, 210}));
        editing.change(withMargins(plan.page(), {0, 0, 0, 0, true}));
        QCOMPARE(checkedPage(plan).text, "All 2 objects lie inside the margins.");
        QCOMPARE(checkedPage(Session()).text, QString());
    }
    void numbersAreRealLengths()
    {
        Plan plan;
        PageEditing editing(plan);
        Page page = *withScale(plan.page(), 50).value;
        page.scale.unit = Unit::Metre;
        QSignalSpy shown(&plan, &Session::displayChanged);
        editing.change(Result<Page>::of(page));
        QCOMPARE(plan.display().unit, Unit::Metre);
        QVERIFY(shown.count() > 0);
        plan.history.undo();
        QCOMPARE(plan.display().unit, Unit::Mm);
    }
    void styleOfNewObjectsInALayerStaysOnPaper()
    {
        Plan plan;
        setLayerStyle(plan, Style{.stroke = Colour{}, .width = 0.7});
        PageEditing editing(plan);
        editing.change(withScale(plan.page(), 50));
        QVERIFY(near(layerStyle(plan)->width * plan.page().millimetresPerUnit(), 0.7));
        plan.history.undo();
        QCOMPARE(layerStyle(plan)->width, 0.7);
    }
};

} // namespace session_page_steps_test

TEST_CLASS(session_page_steps_test::PageStepsTest, Core)
#include "tests/app/session/page_steps_test.moc"

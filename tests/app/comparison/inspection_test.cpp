// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/inspection.h"

#include <QTest>

namespace {

app::Sheet sheetOf(const std::vector<clipping::Segment>& lines)
{
    app::Sheet sheet;
    sheet.window = {{0, 0}, {10, 10}};
    for (const auto& line : lines) {
        app::Shape shape;
        shape.paths.push_back({line.a, {{line.b}}});
        sheet.shapes.push_back(shape);
    }
    return sheet;
}

} // namespace

class InspectionTest : public QObject {
    Q_OBJECT

private slots:
    void regionsAreNamedAsTheyAreSeen() // y down
    {
        const clipping::Window window{{0, 0}, {10, 10}};
        QCOMPARE(app::regionOf({-1, -1}, window).words(), "above left");
        QCOMPARE(app::regionOf({11, 11}, window).words(), "below right");
        QCOMPARE(app::regionOf({0, 10}, window).words(), "inside"); // edges belong to the window
        QCOMPARE(app::regionOf({-1, -1}, window).outcode(), "1001");
        QCOMPARE(app::regionOf({11, 11}, window).outcode(), "0110");
    }
    void classesOfLines()
    {
        app::Session session;
        session.load({sheetOf({{{1, 1}, {2, 2}},
                               {{-5, -1}, {15, -1}},
                               {{-10, 5}, {10, 5}},
                               {{-8, 5}, {5, 18.5}}}),
                      {}});
        const auto classOf = [&](std::size_t i) { return app::inspect(session, i).lineClass; };
        QCOMPARE(classOf(0), app::LineClass::Inside);
        QCOMPARE(classOf(1), app::LineClass::Rejected);
        QCOMPARE(classOf(2), app::LineClass::Cut);
        QCOMPARE(classOf(3), app::LineClass::Missed);
    }
    void outcodesOfStepsAreThoseOfTheRegions()
    {
        app::Session session;
        session.load({sheetOf({{{-5, -5}, {15, 5}}}), {}});
        app::Display display = session.display();
        display.algorithm = clipping::findAlgorithm("cs");
        session.setDisplay(display);
        const auto line = app::inspect(session, 0);
        QCOMPARE(line.from.outcode(), "1001");
        QVERIFY2(app::stepTexts(line).front().contains("a = 1001, b = 0010"),
                 qPrintable(app::stepTexts(line).front()));
    }
    void whatIsLeftAndWhatItCosts()
    {
        app::Session session;
        session.load({sheetOf({{{-10, 5}, {10, 5}}}), {}});
        for (const auto& algorithm : clipping::algorithms()) {
            app::Display display = session.display();
            display.algorithm = &algorithm;
            session.setDisplay(display);
            const auto line = app::inspect(session, 0);
            QCOMPARE(line.visible, (clipping::Segment{{0, 5}, {10, 5}}));
            QCOMPARE(line.share, 0.5);
            QVERIFY(line.cost.comparisons > 0);
            QCOMPARE(app::stepTexts(line).size(), qsizetype(line.trace.steps.size()) + 1);
            QVERIFY(app::stepTexts(line).last().contains("Visible"));
        }
    }
    /// A line that differs is explained by who errs on it, as long as somebody looks.
    void whatDiffersIsExplainedByA()
    {
        app::Session session;
        session.load({sheetOf({{{1, 1}, {2, 2}}, {{5, 4}, {5.05, 9}}}), {}});
        const auto kwc = *app::findClipper("kwc:published");
        const auto look = [&](const app::Clipper& a, const app::Clipper& b) {
            session.differences.ask(app::Comparison{a, b});
            session.differences.finish();
        };
        look(kwc, app::exactClipper());
        QCOMPARE(session.differences.found().list.size(), std::size_t(1));
        QVERIFY(app::inspect(session, 1).clipper == kwc);
        QCOMPARE(app::verdictText(app::inspect(session, 1)), "KWC as published: nothing visible");
        QCOMPARE(app::verdictText(app::inspect(session, 0)), "exact: visible, 100.0 %");
        look(app::exactClipper(), kwc);
        QVERIFY(app::inspect(session, 1).clipper == kwc);
        session.differences.ask(std::nullopt);
        QCOMPARE(app::verdictText(app::inspect(session, 1)), "exact: visible, 100.0 %");
    }
    void anExhibitHasNoSteps()
    {
        app::Session session;
        session.load({sheetOf({{{-3, 4}, {17, 9}}, {{-5, 2}, {7, 12}}, {{2, -6}, {9, 14}}}), {}});
        session.differences.ask(app::Comparison{*app::findClipper("md-step-2")});
        session.differences.finish();
        QVERIFY(!session.differences.found().list.empty());
        const auto line = app::inspect(session, session.differences.found().list[0].source);
        QVERIFY(line.clipper.exhibit);
        QVERIFY(app::stepTexts(line).front().contains("not recorded"));
        QVERIFY(app::verdictText(line).startsWith("MD with Step 2 as printed: "));
    }
    void costInWords()
    {
        QCOMPARE(app::costText({4, 1, 1, 14, 0}), "14 compare, 4 add, 1 multiply, 1 divide");
        QCOMPARE(app::costText({}), "nothing");
    }
};

QTEST_APPLESS_MAIN(InspectionTest)
#include "inspection_test.moc"

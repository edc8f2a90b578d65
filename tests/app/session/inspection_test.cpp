// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/line_class.h"
#include "app/session/inspection.h"
#include "clipping/outcode.h"

#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace session_inspection_test {

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

QStringList stepTexts(const app::Inspection& line)
{
    return app::stepTexts(line, app::Unit::User, {});
}

app::Inspection inspected(const char* algorithm, const clipping::Segment& line,
                          clipping::Form form = clipping::Form::Corrected)
{
    app::Session session;
    session.load({app::documentOf(sheetOf({line})), {}});
    session.setDisplay({.variant = {clipping::findAlgorithm(algorithm), form}});
    return app::inspect(session, 0);
}

} // namespace

class InspectionTest : public QObject {
    Q_OBJECT

private slots:
    void regionsAreNamedAsTheyAreSeen() // y down
    {
        const clipping::Window window{{0, 0}, {10, 10}};
        QCOMPARE(app::regionText(clipping::outcodeOf(app::Point{-1, -1}, window), app::YAxis::Down),
                 "above left");
        QCOMPARE(app::regionText(clipping::outcodeOf(app::Point{11, 11}, window), app::YAxis::Down),
                 "below right");
        QCOMPARE(app::regionText(clipping::outcodeOf(app::Point{0, 10}, window), app::YAxis::Down),
                 "inside"); // edges belong to the window
        QCOMPARE(app::outcodeText(clipping::outcodeOf(app::Point{-1, -1}, window)),
                 "0101"); // y < ymin, x < xmin
        QCOMPARE(app::outcodeText(clipping::outcodeOf(app::Point{11, 11}, window)),
                 "1010"); // y > ymax, x > xmax
    }
    void classesOfLines()
    {
        app::Session session;
        session.load({app::documentOf(sheetOf({{{1, 1}, {2, 2}},
                                               {{-5, -1}, {15, -1}},
                                               {{-10, 5}, {10, 5}},
                                               {{-8, 5}, {5, 18.5}}})),
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
        session.load({app::documentOf(sheetOf({{{-5, -5}, {15, 5}}})), {}});
        app::Display display = session.display();
        display.variant.algorithm = clipping::findAlgorithm("cs");
        session.setDisplay(display);
        const auto line = app::inspect(session, 0);
        QCOMPARE(app::outcodeText(line.fromCode), "0101");
        const QString first = stepTexts(line).front();
        QVERIFY2(first.contains("code[1] = 0101, code[2] = 0010"), qPrintable(first));
    }
    void remainingPartAndCost()
    {
        app::Session session;
        session.load({app::documentOf(sheetOf({{{-10, 5}, {10, 5}}})), {}});
        for (const auto& algorithm : clipping::algorithms()) {
            app::Display display = session.display();
            display.variant.algorithm = &algorithm;
            session.setDisplay(display);
            const auto line = app::inspect(session, 0);
            QCOMPARE(line.visible, (clipping::Segment{{0, 5}, {10, 5}}));
            QCOMPARE(line.share, 0.5);
            QVERIFY(line.cost.comparisons > 0);
            const auto tests = std::ranges::count_if(line.trace.steps, [](const auto& step) {
                return step.what == clipping::What::Test;
            });
            QCOMPARE(stepTexts(line).size(), qsizetype(line.trace.steps.size()) - tests + 1);
            QVERIFY(stepTexts(line).last().contains("Visible"));
        }
    }
    void stepsAreInTheChosenUnit() // a unit of the drawing is 5 mm
    {
        const auto text = [](const char* algorithm, const clipping::Segment& line,
                             clipping::Form form = clipping::Form::Corrected) {
            const app::Page page{.min = {0, 0}, // 5 mm a unit
                                 .size = {100, 100},
                                 .width = {500, app::Unit::Mm},
                                 .height = {500, app::Unit::Mm}};
            return app::stepTexts(inspected(algorithm, line, form), app::Unit::Mm, page)
                .join(u'\n');
        };
        const auto says = [](const QString& all, std::initializer_list<const char*> parts) {
            for (const char* part : parts)
                if (!all.contains(QString::fromUtf8(part)))
                    return qWarning("%s is not in\n%s", part, qPrintable(all)), false;
            return true;
        };
        // From (-10, 5) to (10, 9) at (0, 0)-(10, 10): enters at (0, 7), half way.
        const clipping::Segment line{{-10, 5}, {10, 9}};
        QVERIFY(says(text("cs", line), {"leaves (0.000; 35.000) to (50.000; 45.000)",
                                        "Visible: (0.000; 35.000) to (50.000; 45.000)",
                                        "code[1] = 0001, code[2] = 0000"}));
        QVERIFY(says(text("lb", line), {"p = \u2212100, q = \u221250", "r = 0.5", "u0 = 0.5"}));
        QVERIFY(says(text("md", line), {"rise = 10"}));
        QVERIFY(says(text("cb", line),
                     {"xv = 0, yv = 50, nx = 1, ny = 0, D = 100", "N = \u221250", "t = 0.5"}));
        QVERIFY(says(text("cb", line, clipping::Form::Published),
                     {"nx = 50, ny = 0", "D = 5,000", "N = \u22122,500", "t = 0.5"}));
        QVERIFY(says(text("kwc", line, clipping::Form::Published), {"m = 0.2", "c = 35"}));
        QVERIFY(says(text("kwc", line), {"dx = 100, dy = 20"}));
        QVERIFY(says(text("sb", line), {"yOut = 50", "Y: Y = 50", "e = \u22121,500"}));
        QVERIFY(says(text("spy", line), {"way[1] = 10, y = 35"}));
        QVERIFY(says(text("ms", line),
                     {"toLeft = 50, toRight = 100", "toBottom = \u221225, toTop = 25"}));
        QVERIFY(says(text("skala", line),
                     {"f[0] = \u22122,500, f[1] = 2,000", "f[2] = 2,500, f[3] = 1,000"}));
        // (-10, 5), (10, 9) as vectors: 4 units are 20 mm, -140 units of area -3,500 mm2.
        QVERIFY(says(text("skala", line, clipping::Form::Published),
                     {"px = \u221220, py = 100, pw = \u22123,500", "X[k] = 0, Y[k] = 50",
                      "ex[n] = 1, ey[n] = 0, ew[n] = 0"}));
        // Areas: beyond the corner (0, 10), 4 * 20 and 10 * 12 units.
        QVERIFY(
            says(text("nln", {{-10, 14}, {10, 2}}), {"pymax = \u22122,000, pxmin = \u22123,000"}));
    }
    /// In a page that begins at (2, 1), places are counted from there; what holds at the drawing's
    /// own origin only, or in a turned plane, is not said.
    void stepsAreCountedFromThePage()
    {
        const auto text = [](const char* algorithm, const clipping::Segment& line,
                             clipping::Form form = clipping::Form::Corrected) {
            const app::Page page{.min = {2, 1}, // 5 mm a unit
                                 .size = {100, 100},
                                 .width = {500, app::Unit::Mm},
                                 .height = {500, app::Unit::Mm}};
            return app::stepTexts(inspected(algorithm, line, form), app::Unit::Mm, page)
                .join(u'\n');
        };
        const clipping::Segment line{{-10, 5}, {10, 9}};
        QVERIFY2(text("sb", line).contains("yIn = \u22125, yOut = 45"),
                 qPrintable(text("sb", line)));
        QVERIFY2(text("sb", line).contains("Y = 45"), qPrintable(text("sb", line)));
        const QString skala = text("skala", line, clipping::Form::Published);
        QVERIFY2(skala.contains("X[k] = \u221210, Y[k] = 45"), qPrintable(skala));
        QVERIFY2(!skala.contains("pw = ") && !skala.contains("ew[n] = "), qPrintable(skala));
        const QString turned = text("nln", {{-10, 5}, {5, 14}}); // mirrored
        for (const char* name : {" xmin = ", " ymin = ", " x1 = ", " y2 = "})
            QVERIFY2(!turned.contains(name), qPrintable(turned));
        QVERIFY2(turned.contains("dx = 75"), qPrintable(turned));
    }
    void rejectedLinesLeaveNothing()
    {
        for (const auto& algorithm : clipping::algorithms()) {
            const auto line = inspected(algorithm.key.data(), {{-8, 5}, {5, 18.5}});
            const QStringList texts = stepTexts(line);
            QVERIFY(!line.visible);
            QVERIFY2(texts[texts.size() - 2].endsWith("leaves nothing"), algorithm.key.data());
        }
    }
    /// A line that differs is explained by who errs on it, as long as somebody looks.
    void differencesAreExplainedByA()
    {
        app::Session session;
        session.load({app::documentOf(sheetOf({{{1, 1}, {2, 2}}, {{5, 4}, {5.05, 9}}})), {}});
        const auto kwc = *app::findVariant("kwc:published");
        const auto look = [&](const app::Variant& a, const app::Variant& b) {
            session.differences.ask(app::Comparison{a, b});
            session.differences.finish();
        };
        look(kwc, app::exactVariant());
        QCOMPARE(session.differences.found().list.size(), std::size_t(1));
        QVERIFY(app::inspect(session, 1).variant == kwc);
        QCOMPARE(app::verdictText(app::inspect(session, 1)), "KWC as published: nothing visible");
        QCOMPARE(app::verdictText(app::inspect(session, 0)), "exact: visible, 100.0 %");
        look(app::exactVariant(), kwc);
        QVERIFY(app::inspect(session, 1).variant == kwc);
        session.differences.ask(std::nullopt);
        QCOMPARE(app::verdictText(app::inspect(session, 1)), "exact: visible, 100.0 %");
    }
    void aMisprintHasStepsAndItsDefect()
    {
        app::Session session;
        session.load(
            {app::documentOf(sheetOf({{{-3, 4}, {17, 9}}, {{-5, 2}, {7, 12}}, {{2, -6}, {9, 14}}})),
             {}});
        session.differences.ask(app::Comparison{*app::findVariant("md-step-2")});
        session.differences.finish();
        QVERIFY(!session.differences.found().list.empty());
        const auto line = app::inspect(session, session.differences.found().list[0].source);
        QVERIFY(line.variant.misprint);
        QVERIFY(line.cost.comparisons > 0 && !line.trace.steps.empty());
        QVERIFY(stepTexts(line).size() > 2);
        QCOMPARE(stepTexts(line).last(), line.variant.misprint->whatIsWrong);
        QVERIFY(app::verdictText(line).startsWith("MD with Step 2 as printed: "));
    }
    void costInWords()
    {
        QCOMPARE(app::costText({4, 1, 1, 14, 0}),
                 "14 comparisons, 4 additions, 1 multiplication, 1 division");
        QCOMPARE(app::costText({}), "nothing");
    }
};

} // namespace session_inspection_test

TEST_CLASS(session_inspection_test::InspectionTest, None)
#include "tests/app/session/inspection_test.moc"

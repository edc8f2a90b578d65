// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_style.h"
#include "app/view/picking.h"

#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace session_selection_style_test {

using app::Colour;
using app::Style;

// The style of the selection and of new objects, without a screen.
class SelectionStyleTest : public QObject {
    Q_OBJECT

    static constexpr Colour red{255, 0, 0}, blue{0, 0, 255};

    static app::Shape line(double y, const Style& style)
    {
        app::Shape shape;
        shape.paths = {{{0, y}, {{{100, y}}}, false}};
        shape.style = style;
        return shape;
    }
    struct Drawing : app::Session {
        explicit Drawing(const std::vector<Style>& styles, double millimetres = 100)
        {
            app::Sheet sheet;
            sheet.page = {
                {0, 0}, {100, 100}, {millimetres, app::Unit::Mm}, {millimetres, app::Unit::Mm}};
            for (std::size_t i = 0; i < styles.size(); ++i)
                sheet.shapes.push_back(line(10.0 * double(i + 1), styles[i]));
            load({app::documentOf(sheet), {}});
        }
        const Style& style(std::size_t object) { return now().objects()[object].style(); }
    };

private slots:
    void mixedPropertiesHaveNoCommonValue()
    {
        Drawing d({{.stroke = red, .width = 2}, {.stroke = red, .width = 3}});
        d.select({0, 1});
        const auto styles = app::shownStyles(d);
        QCOMPARE(styles.size(), std::size_t(2));
        QCOMPARE(app::common(styles, &Style::stroke), std::optional(std::optional(red)));
        QVERIFY(!app::common(styles, &Style::width));
        d.select({1});
        QCOMPARE(app::common(app::shownStyles(d), &Style::width), std::optional(3.0));
        d.select({});
        QCOMPARE(app::shownStyles(d), std::vector{d.pen.style});
    }
    void selectionIsRestyledInOneStepAndThePenStays()
    {
        Drawing d({{.stroke = red}, {.stroke = blue}, {.stroke = blue}});
        const Style pen = d.pen.style;
        d.select({0, 1});
        QVERIFY(!app::setColour(d, &Style::stroke, Colour{0, 128, 0}));
        QCOMPARE(d.history.count(), 1);
        QCOMPARE(d.history.undoText(), QString("Stroke colour"));
        QVERIFY(d.style(0).stroke == d.style(1).stroke && d.style(2).stroke == blue);
        QCOMPARE(d.pen.style, pen);
        QVERIFY(!app::setColour(d, &Style::stroke, Colour{0, 128, 0})); // nothing changes
        QCOMPARE(d.history.count(), 1);
        d.history.undo();
        QVERIFY(d.style(0).stroke == red && d.style(1).stroke == blue);
    }
    void withoutASelectionNewObjectsGetTheStyle()
    {
        Drawing d({{.stroke = red}});
        int told = 0;
        connect(&d, &app::Session::displayChanged, [&told] { ++told; });
        app::restyle(
            d, [](Style& style) { style.cap = app::Cap::Round; }, "Caps");
        QCOMPARE(d.pen.style.cap, app::Cap::Round);
        QCOMPARE(told, 1);
        QCOMPARE(d.history.count(), 0);
        QCOMPARE(d.style(0).cap, app::Cap::Butt);
    }
    void nothingVisibleIsRefused()
    {
        Drawing d({{.stroke = red}, {.stroke = red, .fill = blue}});
        d.select({0, 1});
        const auto refusal = app::setColour(d, &Style::stroke, std::nullopt);
        QVERIFY(refusal && refusal->endsWith(u'.'));
        QCOMPARE(d.history.count(), 0);
        d.select({1});
        QVERIFY(!app::setColour(d, &Style::stroke, std::nullopt));
        QVERIFY(app::setColour(d, &Style::fill, std::nullopt));
        d.select({});
        QVERIFY(app::setColour(d, &Style::stroke, std::nullopt));
    }
    void copiedStyleKeepsItsSizeOnPaper()
    {
        Drawing from({{.stroke = red, .width = 2, .dashOffset = 1, .dashes = {4, 6}}});
        from.select({0});
        const app::CopiedStyle copied = app::copiedStyle(from);
        Drawing to({{.stroke = blue, .fill = blue}, {.stroke = blue}},
                   200); // 2 mm is a unit
        to.select({0, 1});
        app::pasteStyle(to, copied);
        QCOMPARE(to.history.count(), 1);
        const Style expected{.stroke = red, .width = 1, .dashOffset = 0.5, .dashes = {2, 3}};
        QVERIFY(to.style(0) == expected && to.style(1) == expected);
        to.history.undo();
        QVERIFY(to.style(0).fill == blue);
        to.select({});
        app::pasteStyle(to, copied);
        QVERIFY(to.pen.style == expected);
        QVERIFY(app::copiedStyle(to).style == expected);
    }
    void layerGivesItsStyleToNewObjects()
    {
        Drawing d({{.stroke = red, .width = 2, .dashes = {4, 6}, .cap = app::Cap::Round}});
        const Style pen = d.pen.style, first = d.style(0);
        QVERIFY(!app::layerStyle(d));
        app::setLayerStyle(d, first);
        QCOMPARE(d.history.count(), 1);
        QVERIFY(app::newStyle(d) == first && d.pen.style == pen);
        app::restyle(
            d, [](Style& style) { style.width = 3; }, "Width"); // of the layer
        QCOMPARE(d.history.count(), 2);
        QCOMPARE(app::layerStyle(d)->width, 3.0);
        QVERIFY(d.pen.style == pen && d.style(0) == first);
        d.history.undo();
        QVERIFY(app::newStyle(d) == first);
        app::setLayerStyle(d, std::nullopt);
        QVERIFY(app::newStyle(d) == pen);
        d.history.undo();
        d.history.undo();
        QVERIFY(!app::layerStyle(d));
    }
    void colourAtAPointIsOfTheLineOrTheArea()
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {100, 100}, {100, app::Unit::Mm}, {100, app::Unit::Mm}};
        app::Shape area;
        area.paths = {{{10, 10}, {{{50, 10}}, {{50, 50}}, {{10, 50}}}, true}};
        area.style = {.stroke = red, .fill = blue};
        sheet.layers = {{"locked", true, true}, {"drawing"}};
        sheet.shapes = {line(80, {.stroke = Colour{1, 2, 3}}), area};
        sheet.shapes[1].layer = 1;
        app::Session session;
        session.load({app::documentOf(sheet), {}});
        const app::Picking picking(session.document, session.scene);
        const auto at = [&](double x, double y) {
            return app::colourAt(session.now(), session.scene, picking, {x, y}, 2);
        };
        QCOMPARE(at(10.5, 30), std::optional(red));
        QCOMPARE(at(30, 30), std::optional(blue));
        QCOMPARE(at(40, 79), std::optional(Colour{1, 2, 3})); // on a locked layer
        QCOMPARE(at(90, 5), std::nullopt);
    }
};

} // namespace session_selection_style_test

TEST_CLASS(session_selection_style_test::SelectionStyleTest, Core)
#include "tests/app/session/selection_style_test.moc"

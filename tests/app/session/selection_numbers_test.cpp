// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/session/selection_numbers.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace session_selection_numbers_test {

using namespace app;

class SelectionNumbersTest : public QObject {
    Q_OBJECT

    static Object made(const Subpath& path)
    {
        return {.path = Path(std::span(&path, 1)), .style = {.stroke = Colour{}, .width = 1}};
    }
    /// A box from (10, 20) to (40, 30), and a line from (5, 5) to (8, 1): 5 long at 53.13°.
    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            builder.open({.name = "Drawing"});
            builder.add(made({{10, 20}, {{{40, 20}}, {{40, 30}}, {{10, 30}}}, true}));
            builder.add(made({{5, 5}, {{{8, 1}}}, false}));
            builder.close();
            load({builder.take({}), {}});
            changeDisplay([](app::Display& display) { display.unit = Unit::User; });
        }
        static const SelectionNumber& number(std::string_view key)
        {
            return *std::ranges::find(selectionNumbers(), key, &SelectionNumber::key);
        }
        double value(std::string_view key, const SelectionFrame& frame = {}) const
        {
            return number(key).value(*this, frame).value();
        }
        std::optional<QString> set(std::string_view key, double value,
                                   const SelectionFrame& frame = {})
        {
            return setSelectionNumber(*this, number(key), frame, value);
        }
        clipping::Segment line() const { return *now().objects()[1].singleLine(); }
    };
    static bool near(double a, double b) { return std::abs(a - b) < 1e-9; }

private slots:
    void numbersAreThoseOfTheBox()
    {
        Drawing drawing;
        drawing.select({0});
        QCOMPARE(drawing.value("x"), 10);
        QCOMPARE(drawing.value("y"), 20);
        QCOMPARE(drawing.value("x", {{1, 1}}), 40);
        QCOMPARE(drawing.value("y", {{0, 0}}), 25);
        QCOMPARE(drawing.value("w"), 30);
        QCOMPARE(drawing.value("h"), 10);
        QCOMPARE(drawing.value("angle"), 0);
        QCOMPARE(drawing.value("length"), 80);
        drawing.select({});
        for (const SelectionNumber& number : selectionNumbers())
            QVERIFY(!number.value(drawing, {}));
    }
    void soManyLinesAreNotMeasured()
    {
        constexpr std::size_t count = 600'001;
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        for (std::size_t i = 0; i < count; ++i)
            builder.add(ObjectRow{.path = Path(clipping::Segment{{0, 0}, {0, 2}}),
                                  .style = builder.style({.stroke = Colour{}})});
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        session.changeDisplay([](app::Display& display) { display.unit = Unit::User; });
        const SelectionNumber& length = Drawing::number("length");
        session.select(ObjectRanges(ObjectRange{0, count / 2}));
        QCOMPARE(length.value(session, {}), std::optional(600'000.0));
        session.select(ObjectRanges(ObjectRange{0, count}));
        QVERIFY(!length.value(session, {}));
        QCOMPARE(setSelectionNumber(session, length, {}, 5), std::optional(length.refusal));
        ObjectRanges scattered; // so many ranges that finding their lines takes as long
        for (std::size_t i = 0; i < 50'000; i += 2)
            scattered.insert(i);
        session.select(scattered);
        QVERIFY(!length.value(session, {}));
    }
    void everyNumberCanBeSet()
    {
        for (const SelectionNumber& number : selectionNumbers()) {
            Drawing drawing;
            drawing.select({1}); // a line has all of them
            const auto error = setSelectionNumber(drawing, number, {}, 7);
            QVERIFY2(!error, number.key.data());
            const double shown = number.key == "skew" ? 0 : 7; // a skew is not remembered
            QVERIFY2(near(drawing.value(number.key), shown), number.key.data());
            QCOMPARE(drawing.history.count(), 1);
            drawing.history.undo();
            QCOMPARE(drawing.line(), (clipping::Segment{{5, 5}, {8, 1}}));
        }
    }
    void referencePointStays()
    {
        Drawing drawing;
        drawing.select({0});
        QVERIFY(!drawing.set("w", 60, {{1, 0}}));
        QCOMPARE(drawing.value("x"), -20);
        QVERIFY(!drawing.set("h", 20, {{0, 0}}));
        QCOMPARE(drawing.value("y"), 15);
        QVERIFY(!drawing.set("w", 30, {{-1, -1}, true}));
        QCOMPARE(drawing.value("h"), 10);
    }
    void aTurnedRectangleKeepsItsAngleAndSides()
    {
        Drawing drawing;
        const Recipe recipe = RectangleRecipe{{10, 20}, {30, 10}};
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        Object object = made(*outlineOf(recipe));
        object.particulars.recipe = recipe;
        builder.add(std::move(object));
        builder.close();
        drawing.load({builder.take({}), {}});
        drawing.select({0});
        QVERIFY(!drawing.set("angle", 30, {{0, 0}}));
        QVERIFY(near(drawing.value("angle"), 30) && near(drawing.value("w"), 30)
                && near(drawing.value("h"), 10));
        QVERIFY(!drawing.set("angle", 40, {{0, 0}})); // not 70
        QVERIFY(near(drawing.value("angle"), 40));
        const double x = drawing.value("x"), y = drawing.value("y");
        QVERIFY(!drawing.set("w", 50));
        QVERIFY(near(drawing.value("w"), 50) && near(drawing.value("h"), 10)
                && near(drawing.value("angle"), 40));
        QVERIFY(near(drawing.value("x"), x) && near(drawing.value("y"), y)); // its corner stays
        QVERIFY(!drawing.set("x", 100));
        QVERIFY(near(drawing.value("x"), 100) && near(drawing.value("y"), y));
        QVERIFY(!drawing.set("angle", 0));
        QVERIFY(near(drawing.value("w"), 50) && near(drawing.value("h"), 10));
        QCOMPARE(drawing.history.count(), 5);
        for (int i = 0; i < 5; ++i)
            drawing.history.undo();
        QVERIFY(drawing.now().objects()[0].particulars().recipe == recipe);
    }
    void lineTurnsAndGrowsFromItsStart()
    {
        Drawing drawing;
        drawing.select({1});
        QVERIFY(near(drawing.value("length"), 5));
        QVERIFY(!drawing.set("angle", 90));
        QVERIFY(glm::distance(drawing.line().b, Point(5, 0)) < 1e-12);
        QVERIFY(!drawing.set("length", 3450));
        QCOMPARE(drawing.line().a, Point(5, 5));
        QVERIFY(glm::distance(drawing.line().b, Point(5, -3445)) < 1e-9);
    }
    void skewLeansToTheRightAboutTheReference()
    {
        Drawing drawing;
        drawing.select({0});
        QVERIFY(!drawing.set("skew", 45, {{-1, 1}})); // the lower edge stays
        QCOMPARE(drawing.value("x"), 10);
        QVERIFY(near(drawing.value("w"), 40));
        QCOMPARE(drawing.value("h"), 10);
        QVERIFY(!drawing.set("skew", -45, {{-1, 1}}));
        QVERIFY(near(drawing.value("w"), 30));
        QCOMPARE(drawing.history.count(), 2);
        QVERIFY(!drawing.set("skew", 0));
        for (const double wrong : {90.0, -90.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
            const auto error = drawing.set("skew", wrong);
            QVERIFY(error && error->endsWith(u'.'));
        }
        drawing.select({1});
        drawing.set("angle", 0);
        QVERIFY(drawing.set("skew", 20)); // would change nothing
        QCOMPARE(drawing.history.count(), 3);
    }
    void whatIsImpossibleIsSaid()
    {
        Drawing drawing;
        drawing.select({0});
        for (const double wrong : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()}) {
            const auto error = drawing.set("w", wrong);
            QVERIFY(error && error->endsWith(u'.'));
        }
        QVERIFY(drawing.set("x", std::numeric_limits<double>::infinity()));
        drawing.select({1});
        QVERIFY(!drawing.set("angle", 0));
        QVERIFY(drawing.set("h", 5)); // a horizontal line has no height
        QCOMPARE(drawing.history.count(), 1);
        QVERIFY(!drawing.set("x", drawing.value("x")));
        QCOMPARE(drawing.history.count(), 1); // nothing has changed
    }
};

} // namespace session_selection_numbers_test

TEST_CLASS(session_selection_numbers_test::SelectionNumbersTest, Core)
#include "tests/app/session/selection_numbers_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/document/window_operations.h"
#include "app/document/window_shape.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_window_steps_test {

using namespace app;

namespace {

const RectangleShape box{{{1, 2}, {3, 4}}}, other{{{5, 6}, {9, 9}}};

Object drawn(const Recipe& recipe, const QString& id = {})
{
    const auto outline = outlineOf(recipe);
    return {.path = Path({&*outline, 1}),
            .style = {.stroke = Colour{}, .fillRule = FillRule::EvenOdd},
            .particulars = {.id = id, .recipe = recipe}};
}

/// A session that collects what it refuses.
struct Asked : Session {
    explicit Asked(std::vector<ClipWindow> windows = {}, const std::vector<Object>& objects = {})
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Drawing")});
        for (const Object& object : objects)
            builder.add(object);
        builder.close();
        load({builder.take({}, {}, {std::move(windows)}), {}});
    }
    const std::vector<ClipWindow>& list() const { return now().windows().list; }
    QStringList names() const
    {
        QStringList names;
        for (const ClipWindow& window : list())
            names << window.name;
        return names;
    }
    QSignalSpy refusals{this, &Session::refused};
};

} // namespace

class WindowStepsTest : public QObject {
    Q_OBJECT

private slots:
    void newWindowsAreNumbered()
    {
        Asked session({{.name = "Hall", .shape = box}});
        const auto shape = [](const char* kind) { return windowKind(kind).make({{0, 0}, {9, 9}}); };
        addWindow(session, {.shape = other});
        drawWindow(session, shape("star"));
        QCOMPARE(session.names(), (QStringList{"Hall", "Rectangle 2", "Star 3"}));
        session.chooseWindow(1);
        removeWindow(session);
        drawWindow(session, shape("ellipse"));
        QCOMPARE(session.names(), (QStringList{"Hall", "Star 3", "Ellipse 4"}));
        setWindowShape(session, shape("polygon"), "Reshape"); // its number stays
        session.chooseWindow(0);
        setWindowShape(session, shape("star"), "Reshape"); // and a person's name
        QCOMPARE(session.names(), (QStringList{"Hall", "Star 3", "Polygon 4"}));
        addWindow(session, {.name = "Own", .shape = box});
        QCOMPARE(session.names().last(), "Own");
    }
    void theFirstWindowIsAddedAndThenChanged()
    {
        Asked session;
        QVERIFY(!session.windowNumber());
        setWindowShape(session, box, "Place");
        QCOMPARE(session.clipWindow(), std::optional(box.box));
        setWindowShape(session, other, "Place");
        QCOMPARE(session.clipWindow(), std::optional(other.box));
        QCOMPARE(session.list().size(), 1u);
        QCOMPARE(session.history.count(), 2);
        setWindowShape(session, other, "Place"); // nothing changes
        QCOMPARE(session.history.count(), 2);
    }
    void theLastWindowThatFitsIsAdded()
    {
        Asked session(std::vector<ClipWindow>(ClipWindows::most - 1, {.visible = false}));
        setWindowShape(session, box, "Place");
        QCOMPARE(session.list().size(), ClipWindows::most);
        QCOMPARE(session.refusals.size(), 0);
        const Document before = session.now();
        QVERIFY(!addWindow(session, {.shape = other}));
        QCOMPARE(session.now(), before);
        QCOMPARE(session.history.count(), 1); // a step that does nothing would be none
        QVERIFY(session.refusals[0][0].toString().contains("has 1,000 clip windows"));
    }
    void toolsActOnTheChosenWindowIfItIsVisible()
    {
        Asked session({{.name = "a", .shape = box, .visible = false},
                       {.name = "b", .shape = box},
                       {.name = "c", .shape = other}});
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(1));
        session.chooseWindow(2);
        QCOMPARE(session.clipWindow(), std::optional(other.box));
        QCOMPARE(session.window(), other.box); // compared there, too
        session.chooseWindow(0);
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(1));
        session.chooseWindow(2);
        removeWindow(session);
        QCOMPARE(session.names(), QStringList({"a", "b"}));
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(1));
        session.history.undo();
        QCOMPARE(session.names(), QStringList({"a", "b", "c"}));
    }
    void movedAndReorderedWindowsStayChosen()
    {
        Asked session({{.name = "a", .shape = box}, {.name = "b", .shape = other}, {.name = "c"}});
        session.chooseWindow(1);
        moveWindow(session, {1, -1}, Merging::WithLast);
        moveWindow(session, {1, -1}, Merging::WithLast);
        QCOMPARE(session.history.count(), 1);
        QVERIFY(session.list()[1].shape == WindowShape(RectangleShape{{{7, 4}, {11, 7}}}));
        reorderWindow(session, 1, 0);
        QCOMPARE(session.names(), QStringList({"b", "a", "c"}));
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(0));
        reorderWindow(session, 0, 2);
        QCOMPARE(session.names(), QStringList({"a", "c", "b"}));
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(2));
        reorderWindow(session, 2, 3);
        QCOMPARE(session.names(), QStringList({"a", "c", "b"}));
    }
    void anotherWindowIsOneMore()
    {
        Asked session({{.name = "a", .shape = box}});
        QCOMPARE(withShape(session, other).list.size(), 1u);
        QVERIFY(addWindows(session, {{.shape = other}, {.shape = box}}, "Two"));
        QCOMPARE(session.list().size(), 3u);
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(2));
    }
    void aPreviewMayHaveAWindowMore()
    {
        Asked session(std::vector<ClipWindow>(ClipWindows::most, {.visible = false}));
        ClipWindows more = session.now().windows();
        more.list.push_back({.shape = box});
        session.setPreview({.windows = more});
        QCOMPARE(session.windowNumber(), std::optional(ClipWindows::most));
        setWindowShape(session, other, "Place");
        removeWindow(session);
        QCOMPARE(session.list().size(), ClipWindows::most);
        QCOMPARE(session.history.count(), 0);
        QCOMPARE(session.refusals.size(), 1);
    }
    void everySelectedAreaBecomesAWindow()
    {
        const RectangleRecipe rectangle{{4, 6}, {-3, -4}}; // from a file: the other way round
        const StarRecipe star{{50, 50}, 10, 4, 0, 5};
        const Object line{Path(clipping::Segment{{0, 0}, {1, 1}}), {}};
        Asked session({}, {drawn(rectangle, "frame"), drawn(star), line});
        QVERIFY(windowsOfSelection(session).empty());
        session.select({2});
        QVERIFY(windowsOfSelection(session).empty()); // a line has no area
        session.select({0, 1, 2});
        const auto windows = windowsOfSelection(session);
        QCOMPARE(windows.size(), 2u);
        QCOMPARE(windows[0].name, "frame");
        QVERIFY(windows[0].shape == WindowShape(RectangleShape{{{1, 2}, {4, 6}}}));
        const auto alone = std::get<PathShape>(windows[1].shape);
        QVERIFY(alone.recipe == Recipe(star) && alone.rule == FillRule::EvenOdd);
    }
    void objectsWithoutAreaAreNamedAsLeftOut()
    {
        const Object line{Path(clipping::Segment{{0, 0}, {1, 1}}), {}};
        Asked session({}, {line, drawn(EllipseRecipe{{9, 9}, {4, 3}}, "pond"), line});
        session.select({0, 1, 2});
        addWindowsOfSelection(session);
        QCOMPARE(session.names(), QStringList{"pond"});
        QCOMPARE(session.refusals.size(), 1);
        QCOMPARE(session.refusals[0][0].toString(),
                 "2 of the 3 selected objects enclose no area and were left out.");
        session.select({0, 1});
        addWindowsOfSelection(session);
        QCOMPARE(session.refusals[1][0].toString(),
                 "1 of the 2 selected objects encloses no area and was left out.");
        session.select({0});
        addWindowsOfSelection(session);
        QVERIFY(session.refusals[2][0].toString().startsWith("None of the selected objects"));
        QCOMPARE(session.history.count(), 2);
    }
    void aTextNamesItsWindow()
    {
        Object text = drawn(EllipseRecipe{{9, 9}, {4, 3}}, "text7");
        text.particulars.recipe = TextRecipe{"Old\ntown", "any", 6, {}};
        Asked session({}, {text});
        session.select({0});
        QCOMPARE(windowsOfSelection(session)[0].name, "Old");
    }
    void aDrawnWindowAdds()
    {
        Asked session({{.name = "a", .shape = box}});
        const DrawnWindow before = withDrawn(session, other);
        drawWindow(session, other);
        QVERIFY(session.list() == before.windows.list);
        QCOMPARE(session.list().size(), 2u);
        QCOMPARE(session.windowNumber(), std::optional(before.number));
        QCOMPARE(session.list().back().operation, WindowOperation::Add);
    }
    void theFirstWindowHasNoneToIntersectOrReplace()
    {
        Asked session({{.name = "a", .shape = box}, {.name = "b", .shape = other}});
        for (const WindowOperationInfo& each : windowOperations()) {
            session.refusals.clear();
            setWindowOperation(session, 0, each.operation);
            const bool can = each.operation == WindowOperation::Add
                             || each.operation == WindowOperation::CutOut; // of everything
            QCOMPARE(session.refusals.value(0).value(0).toString(),
                     can ? "" : "No clip window is above a.");
            QCOMPARE(session.list()[0].operation == each.operation, can);
            setWindowOperation(session, 1, each.operation);
            QCOMPARE(session.list()[1].operation, each.operation);
        }
        QCOMPARE(session.history.undoText(), "Replace with b");
        session.chooseWindow(1);
        reorderWindow(session, 1, 0); // it stays what it is, and can be made to add
        QCOMPARE(whyNot(session.windows(), 0, WindowOperation::Replace), "");
        setWindowOperation(session, 0, WindowOperation::Add);
        QCOMPARE(resultOf(session.windows()), QString::fromUtf8("b − a"));
    }
    void onlyWindowsWithAnEffectAreCompared()
    {
        Asked session({{.name = "a", .shape = box},
                       {.name = "b", .shape = other, .operation = WindowOperation::Replace}});
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(1));
        session.chooseWindow(0);
        QCOMPARE(session.windowNumber(), std::optional<std::size_t>(0)); // it can still be edited
        QCOMPARE(session.compared().number, std::optional<std::size_t>(1));
        QVERIFY(!stepInHand(session));
        QCOMPARE(headingInHand(session), "");
        QCOMPARE(needsByName(session).size(), 1u);
        QCOMPARE(replacedText(session.windows(), 0), "without effect: b replaces it");
        QCOMPARE(replacedText(session.windows(), 1), "");
        session.chooseWindow(1);
        QCOMPARE(stepInHand(session), session.region().steps.data());
    }
    void aWindowsOutlineBecomesAnObject()
    {
        Asked session({{.shape = windowKinds()[1].make({{0, 0}, {8, 6}})}});
        windowToPath(session);
        QCOMPARE(session.now().objects().size(), 1u);
        QCOMPARE(session.selection(), ObjectRanges{0});
        const ObjectView object = session.now().objects()[0];
        QVERIFY(object.particulars().recipe == Recipe(EllipseRecipe{{4, 3}, {4, 3}}));
        QVERIFY(!object.path().straight());
        QVERIFY(windowsOfSelection(session)[0].shape == session.list()[0].shape);
    }
    void everyKindOfWindowFitsIntoItsBox()
    {
        const clipping::Window room{{10, 20}, {50, 40}};
        for (const WindowKind& kind : windowKinds()) {
            if (!kind.make)
                continue; // corner by corner
            const auto [min, max] = boxOf(kind.make(room));
            QVERIFY2(min.x >= 9.99 && min.y >= 19.99 && max.x <= 50.01 && max.y <= 40.01,
                     kind.key.data());
            QVERIFY2(max.y - min.y > 15, kind.key.data());
        }
    }
};

} // namespace session_window_steps_test

TEST_CLASS(session_window_steps_test::WindowStepsTest, Core)
#include "tests/app/session/window_steps_test.moc"

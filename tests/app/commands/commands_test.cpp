// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/cut_text.h"
#include "app/session/session.h"

#include <QTest>

#include "tests/app/commands/random_commands.h"
#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace commands_commands_test {

namespace {

app::Shape line(app::Point a, app::Point b, std::uint32_t layer)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    shape.style.stroke = app::Colour{};
    shape.layer = layer;
    return shape;
}

app::Sheet sheet(int perLayer)
{
    app::Sheet result;
    result.layers = {{"a"}, {"b"}, {"c"}};
    for (std::uint32_t layer = 0; layer < 3; ++layer)
        for (int i = 0; i < perLayer; ++i)
            result.shapes.push_back(line({i, layer}, {i + 5, layer + 1}, layer));
    return result;
}

} // namespace

class CommandsTest : public QObject {
    Q_OBJECT

private slots:
    void whateverIsDoneCanBeUndoneAndRedone()
    {
        constexpr int least = 200, most = 5000; // until each command was drawn
        for (unsigned round = 0; round < 5; ++round) {
            app::EditedDocument document(app::documentOf(sheet(20)));
            app::History history;
            RandomCommands steps(document, round);
            std::vector<app::Document> states{document.now()};
            int count = 0;
            for (; count < least || (count < most && !steps.neverDrawn().empty()); ++count) {
                history.push(steps.next());
                states.push_back(document.now());
            }
            QVERIFY2(steps.neverDrawn().empty(), steps.neverDrawn().data());
            for (int i = count; i > 0; --i) {
                QVERIFY(document.now() == states[std::size_t(i)]);
                history.undo();
            }
            for (int i = 0; i < count; ++i) {
                QVERIFY(document.now() == states[std::size_t(i)]);
                history.redo();
            }
            QVERIFY(document.now() == states.back());
        }
    }
    // The lock protects against editing, and what is hidden is not seen to
    // change.
    void croppingLeavesLockedAndHiddenAlone()
    {
        app::Sheet before = sheet(1);
        before.layers = {{"open"}, {"locked", true, true}, {"hidden", false}};
        before.shapes.push_back(line({-5, 0}, {5, 0}, 2));
        before.shapes.insert(before.shapes.begin(), line({0, 9}, {5, 9}, 0));
        before.window = {{1, 0}, {2, 9}};
        before.shapes.front().hidden = true;
        app::EditedDocument document(app::documentOf(before));
        app::CutOptions options;
        options.clipAll = clipping::findAlgorithm("exact")->corrected.clipAll;
        options.region.steps = {{before.window, app::WindowOperation::Add}};
        options.leaveLocked = options.leaveHidden = true;
        app::CropToWindow crop(document, options);
        QCOMPARE(crop.counts().cut, 1u);
        QCOMPARE(crop.counts().leftLocked, 1u);
        QCOMPARE(crop.counts().leftHidden, 3u);
        QCOMPARE(app::cutText(crop.counts()),
                 "1 object cut. Unchanged on locked layers: 1. Unchanged because hidden: 3.");
        QCOMPARE(app::cutText({.whole = 3}), "3 objects kept whole.");
        QCOMPARE(app::cutText({.whole = 1200, .cut = 1, .gone = 2}),
                 "1,200 objects kept whole, 1 cut, 2 left out.");
        QCOMPARE(app::cutText({.cut = 1, .dropped = 2, .fillsRemoved = 3}),
                 "1 object cut. Short pieces dropped: 2. Fills removed: 3.");
        crop.redo();
        const auto after = sheetOf(document).shapes;
        QCOMPARE(after.size(), before.shapes.size());
        for (std::size_t i = 0; i < after.size(); ++i)
            QCOMPARE(after[i] == before.shapes[i], i != 1);
        QCOMPARE(after[1].paths[0].start.x, 1.0);

        options.leaveLocked = options.leaveHidden = false; // as the command line cuts
        app::Document other = app::documentOf(before);
        const app::Cut all = app::cut(other, options);
        other.apply(all.edit);
        QCOMPARE(all.counts.leftLocked + all.counts.leftHidden, 0u);
        QCOMPARE(all.counts.hidden, 3u);
        for (const app::Shape& shape : app::sheetOf(other).shapes)
            QVERIFY(shape.paths[0].start.x >= 1 && shape.paths[0].segments[0].to.x <= 2);
    }
    void quickNudgesAreOneStepAndDragsAreNot()
    {
        using namespace std::chrono_literals;
        app::Session session;
        app::History& history = session.history;
        std::chrono::steady_clock::time_point now{};
        history.setClock([&] { return now; });
        ::load(session.document, sheet(2));
        const auto move = [&](const app::ObjectRanges& shapes, app::Merging merging) {
            history.push(new app::MoveObjects(session.document, shapes, {1, 0}, merging));
        };
        const auto before = sheetOf(session.document);
        for (int i = 0; i < 5; ++i, now += 999ms)
            move({0, 2}, app::Merging::WithLast);
        QCOMPARE(history.count(), 1);
        QCOMPARE(sheetOf(session.document).shapes[2].paths[0].start,
                 (before.shapes[2].paths[0].start + app::Point(5, 0)));
        const auto after = sheetOf(session.document);
        history.undo();
        QVERIFY(sheetOf(session.document) == before);
        history.redo();
        QVERIFY(sheetOf(session.document) == after);
        move({0, 2}, app::Merging::Never); // a drag
        move({0}, app::Merging::WithLast);
        move({0, 2}, app::Merging::WithLast); // other objects
        QCOMPARE(history.count(), 4);
        now += 1000ms;
        move({0, 2}, app::Merging::WithLast);
        QCOMPARE(history.count(), 5);
        history.setIndex(0);
        QVERIFY(sheetOf(session.document) == before);
    }
    void quickStepsOfTheWindowAreOne()
    {
        app::Session session;
        app::History& history = session.history;
        history.setClock([] { return std::chrono::steady_clock::time_point(); });
        const auto before = sheetOf(session.document);
        for (int i = 0; i < 3; ++i)
            history.push(
                windowStep(session.document, {{i * 1.0, 0}, {i + 9.0, 9}}, app::Merging::WithLast));
        QCOMPARE(history.count(), 2); // the first changed its size, too
        history.undo();
        QCOMPARE(sheetOf(session.document).window, (clipping::Window{{0, 0}, {9, 9}}));
        history.undo();
        QVERIFY(sheetOf(session.document) == before);
    }
    void quickStepsOfAStyleAreOne()
    {
        app::Session session;
        app::History& history = session.history;
        history.setClock([] { return std::chrono::steady_clock::time_point(); });
        ::load(session.document, sheet(30));
        const auto before = sheetOf(session.document);
        app::ObjectRanges scattered;
        for (std::size_t i = 0; i < before.shapes.size(); i += 3)
            scattered.insert(i);
        const auto restyle = [&](const app::ObjectRanges& shapes, const QString& text) {
            history.push(new app::SetStyle(
                session.document, shapes, [](app::Style& style) { style.width *= 2; }, text,
                app::Merging::WithLast));
        };
        restyle(scattered, "Width");
        restyle(scattered, "Width");
        QCOMPARE(history.count(), 1);
        QCOMPARE(sheetOf(session.document).shapes[3].style.width, 4.0);
        QCOMPARE(sheetOf(session.document).shapes[4].style.width, 1.0);
        restyle(scattered, "Dashes");
        restyle({0}, "Dashes");
        QCOMPARE(history.count(), 3);
        history.setIndex(0);
        QVERIFY(sheetOf(session.document) == before);
    }
    void theSelectionFollows()
    {
        app::Session session;
        ::load(session.document, sheet(4));
        session.select({1, 6, 9});
        session.history.push(new app::RemoveObjects(session.document, {0, 6}));
        QCOMPARE(session.selection(), (app::ObjectRanges{0, 7}));
        session.history.undo();
        QVERIFY(session.selection().contains(1) && session.selection().contains(9));
    }
    void shapesArriveOnTopOfTheirLayer()
    {
        app::EditedDocument document(app::documentOf(sheet(2)));
        app::History history;
        history.push(addShapes(document, {line({0, 0}, {9, 9}, 1)}, "Add"));
        QCOMPARE(sheetOf(document).shapes[4].paths[0].segments[0].to, app::Point(9, 9));
        QCOMPARE(sheetOf(document).shapes[4].layer, 1U);
    }
};

} // namespace commands_commands_test

TEST_CLASS(commands_commands_test::CommandsTest, None)
#include "tests/app/commands/commands_test.moc"

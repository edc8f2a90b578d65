// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/commands/set_containers.h"
#include "app/commands/set_page_parts.h"
#include "app/scene/bounds.h"
#include "app/session/session.h"

#include <QTest>

#include <functional>
#include <random>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/document/three_layers.h"
#include "tests/test_class.h"

namespace document_selection_test {

namespace {

using Bounds = std::optional<clipping::Window>;

/// Puts bounds of no selection where the session keeps them: they stay until it calculates anew.
const Bounds mark = clipping::Window{{-1000, -1000}, {-999, -999}};
void setMark(const app::Session& session) { const_cast<Bounds&>(session.selectionBounds()) = mark; }

} // namespace

class SelectionTest : public QObject {
    Q_OBJECT

private slots:
    void boundsAreKeptWhileNothingChanges()
    {
        app::Session session;
        session.load({app::documentOf(threeLayers(4)), {}});
        session.select({1, 6, 9});
        QCOMPARE(session.selectionBounds(), (clipping::Window{{1, 0}, {7, 3}}));
        setMark(session);
        session.history.push(windowStep(session.document, {{0, 0}, {2, 5}}));
        session.select({9, 6, 1}); // the same
        session.inspect(3);
        app::ClipWindows windows = session.now().windows();
        windows.keep = app::Keep::Outside;
        session.history.push(new app::SetWindows(session.document, windows, "Keep outside"));
        QCOMPARE(session.selectionBounds(), mark);
    }
    void whatIsLockedByUndoIsNotSelected()
    {
        app::Session session;
        session.load({app::documentOf(threeLayers(2)), {}});
        app::Container layer =
            session.now().containers()[session.now().containers().childrenOf(0)[1]];
        layer.locked = true;
        session.history.push(new app::SetContainers(
            session.document, session.now().containers().with(layer), "Lock"));
        layer.locked = false;
        session.history.push(new app::SetContainers(
            session.document, session.now().containers().with(layer), "Unlock"));
        session.select({0, 2, 3, 5});
        session.history.undo();
        QCOMPARE(session.selection(), (app::ObjectRanges{0, 5}));
    }
    void eachChangeCalculatesThemAnew()
    {
        app::Session session;
        session.load({app::documentOf(threeLayers(4)), {}});
        session.select({1, 6, 9});
        const auto changed = [&](const std::function<void()>& change) {
            setMark(session);
            change();
            const Bounds bounds = session.selectionBounds();
            return bounds != mark
                   && bounds == app::boundsOf(session.scene.lines(), session.selection());
        };
        QVERIFY(changed([&] { session.select({1, 6}); }));
        QVERIFY(changed([&] { ::setLayers(session.document, {{"a"}, {"b", false}, {"c"}}); }));
        QVERIFY(changed([&] { ::setPage(session.document, {}); }));
        QVERIFY(changed([&] {
            session.history.push(new app::MoveObjects(session.document, {1}, {9, 9}));
        }));
        QVERIFY(changed([&] { session.history.undo(); }));
        QVERIFY(changed([&] {
            session.history.push(new app::RemoveObjects(session.document, {0, 1}));
        }));
        QVERIFY(changed([&] { session.select({0}); }));
        QVERIFY(changed([&] { session.select({}); }));
        QCOMPARE(session.selectionBounds(), std::nullopt);
        session.select({1});
        QVERIFY(changed([&] { session.load({app::documentOf(threeLayers(2)), {}}); }));
    }
    void boundsAreThoseOfTheSelectionAfterAnyEdits()
    {
        std::mt19937_64 random(3);
        app::Session session;
        session.load({app::documentOf(threeLayers(8)), {}});
        for (int round = 0; round < 500; ++round) {
            const std::size_t count = sheetOf(session.document).shapes.size();
            app::ObjectRanges some;
            for (std::size_t i = 0; i < count; ++i)
                if (random() % 3 == 0)
                    some.insert(i);
            switch (random() % 6) {
            case 0:
                session.select(some);
                break;
            case 1:
                session.history.push(new app::MoveObjects(session.document, some, {1, 2}));
                break;
            case 2:
                session.history.push(addShapes(
                    session.document, {line({0, 0}, {9, 9}, 1), line({3, 0}, {9, 9}, 1)}, "Add"));
                break;
            case 3:
                if (count > 12)
                    session.history.push(new app::RemoveObjects(session.document, some));
                break;
            case 4:
                session.history.undo();
                break;
            default:
                session.history.redo();
                break;
            }
            QVERIFY(session.selection().empty()
                    || session.selection().last() < sheetOf(session.document).shapes.size());
            QCOMPARE(session.selectionBounds(),
                     app::boundsOf(session.scene.lines(), session.selection()));
        }
    }
};

} // namespace document_selection_test

TEST_CLASS(document_selection_test::SelectionTest, None)
#include "tests/app/document/selection_test.moc"

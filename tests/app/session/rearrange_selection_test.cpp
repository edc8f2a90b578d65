// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/transform_objects.h"
#include "app/document/document_builder.h"
#include "app/session/layer_steps.h"
#include "app/session/rearrange_selection.h"
#include "app/session/units.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_rearrange_selection_test {

using namespace app;

namespace {

Object line(double x, double length = 1)
{
    return {.path = Path(clipping::Segment{{x, 0}, {x + length, 1}}),
            .style = {.stroke = Colour{}, .width = 1}};
}

/// Where the objects begin, in painting order.
std::vector<double> order(const Session& session)
{
    std::vector<double> starts;
    const Objects& all = session.now().objects();
    all.forEach(0, all.size(), [&](std::size_t, const ObjectView& object) {
        starts.push_back(object.singleLine()->a.x);
    });
    return starts;
}

using Order = std::vector<double>;

} // namespace

class RearrangeSelectionTest : public QObject {
    Q_OBJECT

    /// Two layers: 0, 1, (2, 3, (4)), 5 in "low" and 6, 7 in "high". Brackets are groups.
    struct Drawing : Session {
        Drawing()
        {
            DocumentBuilder builder;
            low = builder.open({.name = "low"});
            builder.add(line(0));
            builder.add(line(1));
            outer = builder.open({.kind = Container::Kind::Group, .name = "outer"});
            builder.add(line(2));
            builder.add(line(3));
            inner = builder.open({.kind = Container::Kind::Group});
            builder.add(line(4));
            builder.close();
            builder.close();
            builder.add(line(5));
            builder.close();
            high = builder.open({.name = "high"});
            builder.add(line(6));
            builder.add(line(7));
            builder.close();
            load({builder.take({}), {}});
        }
        const Containers& tree() const { return now().containers(); }
        ContainerId low = 0, outer = 0, inner = 0, high = 0;
    };
    static std::vector<double> selected(const Session& session)
    {
        std::vector<double> starts;
        for (const std::size_t object : session.selection())
            starts.push_back(session.now().objects()[object].singleLine()->a.x);
        return starts;
    }

    // Measured, not judged: a busy machine is slow.
    static constexpr int many = 100'000;
    template <class Run>
    static void timed(const char* what, const Run& run)
    {
        QElapsedTimer timer;
        timer.start();
        run();
        qInfo("%s: %lld ms", what, timer.elapsed());
    }

private slots:
    void aGroupTakesThePlaceOfItsTopmostObject()
    {
        Drawing drawing;
        const Document before = drawing.now();
        drawing.select({0, 5});
        groupSelection(drawing);
        QCOMPARE(order(drawing), (Order{1, 2, 3, 4, 0, 5, 6, 7}));
        QCOMPARE(selected(drawing), (Order{0, 5}));
        const ContainerId group = drawing.tree().containerOf(4);
        QCOMPARE(drawing.tree().rangeOf(group), (ObjectRange{4, 6}));
        QCOMPARE(drawing.tree().parentOf(group), drawing.low);
        QCOMPARE(drawing.history.undoText(), "Group");
        drawing.history.undo();
        QVERIFY(drawing.now() == before);
        QCOMPARE(selected(drawing), (Order{0, 5}));
        drawing.history.redo();
        QCOMPARE(selected(drawing), (Order{0, 5}));
        QCOMPARE(order(drawing), (Order{1, 2, 3, 4, 0, 5, 6, 7}));
    }
    void groupsStayGroupsInANewGroup()
    {
        Drawing drawing;
        drawing.select({1, 2, 3, 4, 6});
        groupSelection(drawing);
        QCOMPARE(order(drawing), (Order{0, 5, 1, 2, 3, 4, 6, 7}));
        const ContainerId group = drawing.tree().containerOf(2);
        QCOMPARE(drawing.tree().parentOf(group), drawing.high);
        QCOMPARE(drawing.tree().parentOf(drawing.outer), group);
        QCOMPARE(drawing.tree().parentOf(drawing.inner), drawing.outer);
        QCOMPARE(drawing.tree().rangeOf(group), (ObjectRange{2, 7}));
    }
    void aGroupThatLosesAllObjectsIsGone()
    {
        Drawing drawing;
        drawing.entered.enter(drawing.outer);
        drawing.select({4});
        drawing.entered.enter(drawing.inner); // its object is meant, not the group
        moveSelectionTo(drawing, drawing.high);
        QCOMPARE(order(drawing), (Order{0, 1, 2, 3, 5, 6, 7, 4}));
        QVERIFY(!drawing.tree().contains(drawing.inner));
        QCOMPARE(drawing.entered.id(), drawing.outer);
        drawing.history.undo();
        QVERIFY(drawing.tree().contains(drawing.inner));
    }
    void objectsAreMovedBetweenOthers()
    {
        Drawing drawing;
        drawing.select({0, 6});
        moveSelectionBetween(drawing, drawing.outer, 3); // above line 2
        QCOMPARE(order(drawing), (Order{1, 2, 0, 6, 3, 4, 5, 7}));
        QCOMPARE(selected(drawing), (Order{0, 6}));
        QCOMPARE(drawing.tree().containerOf(2), drawing.outer);
        QCOMPARE(drawing.history.undoText(), QStringLiteral("Move to group outer"));
        drawing.history.undo();
        QCOMPARE(order(drawing), (Order{0, 1, 2, 3, 4, 5, 6, 7}));

        drawing.select({2, 3, 4}); // the group, below line 0: 0 is the place
        moveSelectionBetween(drawing, drawing.low, 0);
        QCOMPARE(order(drawing), (Order{2, 3, 4, 0, 1, 5, 6, 7}));
        QCOMPARE(drawing.tree().parentOf(drawing.outer), drawing.low);
        QCOMPARE(drawing.history.undoText(), QStringLiteral("Change the order in low"));

        QSignalSpy refused(&drawing, &Session::refused);
        moveSelectionBetween(drawing, drawing.low, 0); // it is there
        moveSelectionBetween(drawing, drawing.inner, 3);
        QCOMPARE(refused.count(), 2);
        QCOMPARE(drawing.history.count(), 1);
    }
    void ungroupingKeepsInnerGroups()
    {
        Drawing drawing;
        drawing.select({2, 3, 4});
        ungroupSelection(drawing);
        QVERIFY(!drawing.tree().contains(drawing.outer));
        QCOMPARE(drawing.tree().parentOf(drawing.inner), drawing.low);
        QCOMPARE(selected(drawing), (Order{2, 3, 4}));
        ungroupSelection(drawing);
        QVERIFY(!drawing.tree().contains(drawing.inner));
        QSignalSpy refused(&drawing, &Session::refused);
        ungroupSelection(drawing);
        QCOMPARE(refused.count(), 1);
        QCOMPARE(drawing.history.count(), 2);
    }
    void clicksAndBoxesSelectWholeGroups()
    {
        Drawing drawing;
        QCOMPARE(unitAt(drawing, 0), (ObjectRanges{0}));
        QCOMPARE(unitAt(drawing, 4), (ObjectRanges{2, 3, 4}));
        QCOMPARE(unitsOf(drawing, {1, 2}, FoundGroups::Any), (ObjectRanges{1, 2, 3, 4}));
        QCOMPARE(unitsOf(drawing, {1, 2}, FoundGroups::Whole), (ObjectRanges{1}));
        drawing.select({0, 1, 2});
        QVERIFY(!someGroupSelected(drawing));
        drawing.select({0, 2, 3, 4});
        QVERIFY(someGroupSelected(drawing));
        drawing.entered.enter(drawing.outer);
        drawing.select({2, 3});
        QVERIFY(!someGroupSelected(drawing));
        drawing.select({4});
        QVERIFY(someGroupSelected(drawing));
        QCOMPARE(unitAt(drawing, 2), (ObjectRanges{2}));
        QCOMPARE(groupAt(drawing, 4), drawing.inner);
        QCOMPARE(unitsOf(drawing, {0, 2, 4}, FoundGroups::Any), (ObjectRanges{2, 4}));
        QCOMPARE(selectableObjects(drawing), (ObjectRanges{2, 3, 4}));
        drawing.entered.enter(drawing.inner);
        QCOMPARE(unitAt(drawing, 2), (ObjectRanges{2})); // beside it, in the group around it
        drawing.entered.leave();
        QCOMPARE(drawing.entered.id(), drawing.outer);
        drawing.entered.leave();
        QCOMPARE(drawing.entered.id(), ContainerId(0));
    }
    void frontAndBackStayInTheContainer()
    {
        Drawing drawing;
        drawing.select({0, 6});
        stackSelection(drawing, Stacking::ToFront);
        QCOMPARE(order(drawing), (Order{1, 2, 3, 4, 5, 0, 7, 6}));
        QCOMPARE(selected(drawing), (Order{0, 6}));
        stackSelection(drawing, Stacking::ToBack);
        QCOMPARE(order(drawing), (Order{0, 1, 2, 3, 4, 5, 6, 7}));
        QSignalSpy refused(&drawing, &Session::refused);
        stackSelection(drawing, Stacking::ToBack);
        QCOMPARE(refused.count(), 1);
    }
    void raisingPassesTheNextObjectThatOverlaps()
    {
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        for (const double x : {0.0, 10.0, 20.0, 0.5, 30.0})
            builder.add(line(x));
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        session.select({0});
        stackSelection(session, Stacking::Raise);
        QCOMPARE(order(session), (Order{10, 20, 0.5, 0, 30}));
        QSignalSpy refused(&session, &Session::refused);
        stackSelection(session, Stacking::Raise);
        QCOMPARE(refused.count(), 1);
        stackSelection(session, Stacking::Lower);
        QCOMPARE(order(session), (Order{10, 20, 0, 0.5, 30}));
        QCOMPARE(selected(session), (Order{0}));
    }
    void layersAboveAndBelow()
    {
        Drawing drawing;
        drawing.select({2, 3, 4});
        moveSelectionBy(drawing, 1);
        QCOMPARE(order(drawing), (Order{0, 1, 5, 6, 7, 2, 3, 4}));
        QCOMPARE(drawing.tree().parentOf(drawing.outer), drawing.high);
        QSignalSpy refused(&drawing, &Session::refused);
        moveSelectionBy(drawing, 1);
        QCOMPARE(refused.count(), 1);
        moveSelectionBy(drawing, -1);
        QCOMPARE(order(drawing), (Order{0, 1, 5, 2, 3, 4, 6, 7}));
    }
    void lockedLayerTakesNothing()
    {
        Drawing drawing;
        Container layer = drawing.tree()[drawing.high];
        layer.locked = true;
        Edit edit;
        edit.containers = drawing.tree().with(layer);
        drawing.document.apply(edit);
        drawing.select({0});
        QSignalSpy refused(&drawing, &Session::refused);
        moveSelectionTo(drawing, drawing.high);
        moveSelectionBy(drawing, 1);
        QCOMPARE(refused.count(), 2);
        QCOMPARE(drawing.history.count(), 0);
    }
    void copiesOfAGroupAreAGroup()
    {
        Drawing drawing;
        drawing.select({1, 2, 3, 4});
        const std::vector maps{translation({100, 0})};
        Edit edit = copying(drawing.now(), drawing.selection(), maps);
        const ObjectRanges added = addedBy(edit.splices);
        drawing.history.push(new CopyObjects(drawing.document, std::move(edit), "Copy"));
        drawing.select(added);
        QCOMPARE(order(drawing), (Order{0, 1, 2, 3, 4, 5, 101, 102, 103, 104, 6, 7}));
        const ContainerId copy = drawing.tree().containerOf(7);
        QVERIFY(copy != drawing.outer);
        QCOMPARE(drawing.tree().rangeOf(copy), (ObjectRange{7, 10}));
        QCOMPARE(drawing.tree().parentOf(drawing.tree().containerOf(9)), copy);

        drawing.history.undo(); // gives back the selection before the copy
        QCOMPARE(selected(drawing), (Order{1, 2, 3, 4}));
        drawing.history.redo();
        QCOMPARE(drawing.selection(), added);
    }
    void aContainerDoesNotMoveIntoItself()
    {
        Drawing drawing;
        QVERIFY(!movedContainer(drawing.now(), drawing.outer, {drawing.inner}));
        QVERIFY(!movedContainer(drawing.now(), drawing.low, {drawing.outer}));
        const auto fault = [&](ContainerId id, ContainerId into) {
            return faultOf(drawing.tree(), id, {into});
        };
        QCOMPARE(fault(drawing.outer, drawing.inner), MoveFault::IntoItself);
        QCOMPARE(fault(drawing.high, drawing.outer), MoveFault::LayerIntoGroup);
        QCOMPARE(fault(drawing.outer, 0), MoveFault::GroupOutOfLayer);
        QCOMPARE(fault(12345, 0), MoveFault::Removed);
        QSignalSpy refused(&drawing, &Session::refused);
        moveLayer(drawing, drawing.high, ContainerPlace{drawing.outer});
        QVERIFY(refused.takeFirst()[0].toString().contains("into a group"));
        const auto nested = movedContainer(drawing.now(), drawing.low, {drawing.high});
        QVERIFY(nested);
        Document document = drawing.now();
        document.apply(nested->edit);
        QCOMPARE(document.containers().parentOf(drawing.low), drawing.high);
        QCOMPARE(document.containers().childrenOf(0).size(), std::size_t(1));
    }
    void manyGroups()
    {
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        for (int i = 0; i < many / 2; ++i) {
            builder.open({.kind = Container::Kind::Group});
            builder.add(line(2 * i));
            builder.add(line(2 * i + 1));
            builder.close();
        }
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        const ObjectRanges all = selectableObjects(session);
        ObjectRanges everyThird;
        for (std::size_t i = 0; i < many; i += 3)
            everyThird.insert(i);
        timed("groups of a box", [&] {
            QCOMPARE(unitsOf(session, everyThird, FoundGroups::Any).size(), std::size_t(66'668));
        });
        timed("whole groups of a box",
              [&] { QCOMPARE(unitsOf(session, all, FoundGroups::Whole), all); });
        session.select(unitsOf(session, everyThird, FoundGroups::Any));
        timed("group two thirds of 50,000 groups", [&] { groupSelection(session); });
        timed("ungroup", [&] { ungroupSelection(session); });
        timed("bring to front", [&] { stackSelection(session, Stacking::ToFront); });
    }
    void manyObjects()
    {
        DocumentBuilder builder;
        builder.open({.name = "layer"});
        for (int i = 0; i < many; ++i)
            builder.add(line(i, 3));
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        timed("select all", [&] { session.select(selectableObjects(session)); });
        timed("group all", [&] { groupSelection(session); });
        timed("undo", [&] { session.history.undo(); });
        ObjectRanges everySecond;
        for (std::size_t i = 0; i < many; i += 2)
            everySecond.insert(i);
        session.select(everySecond);
        timed("group every second", [&] { groupSelection(session); });
        timed("undo", [&] { session.history.undo(); });
        QCOMPARE(session.selection(), everySecond);
        timed("raise every second", [&] { stackSelection(session, Stacking::Raise); });
        timed("undo", [&] { session.history.undo(); });
        session.select({0});
        timed("raise one", [&] { stackSelection(session, Stacking::Raise); });
        timed("bring one to front", [&] { stackSelection(session, Stacking::ToFront); });
        QCOMPARE(session.selection(), (ObjectRanges{many - 1}));
        timed("send every second back", [&] {
            session.select(everySecond);
            stackSelection(session, Stacking::ToBack);
        });
    }
};

} // namespace session_rearrange_selection_test

TEST_CLASS(session_rearrange_selection_test::RearrangeSelectionTest, Core)
#include "tests/app/session/rearrange_selection_test.moc"

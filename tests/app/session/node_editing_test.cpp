// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"
#include "app/document/document_builder.h"
#include "app/session/node_editing.h"
#include "app/session/session.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/app/nodes/shapes.h"
#include "tests/test_class.h"

namespace session_node_editing_test {

class NodeEditingTest : public QObject {
    Q_OBJECT

    struct Drawing {
        explicit Drawing(const std::vector<app::Subpath>& paths)
        {
            app::Sheet sheet;
            for (const app::Subpath& path : paths) {
                app::Shape shape;
                shape.paths.push_back(path);
                shape.style.stroke = app::Colour{};
                shape.id = QStringLiteral("id%1").arg(sheet.shapes.size());
                sheet.shapes.push_back(shape);
            }
            session.load({app::documentOf(sheet), {}});
            session.select(app::ObjectRanges(app::ObjectRange{0, paths.size()}));
            nodes.setShown(true);
        }
        app::Subpath path(std::size_t object = 0)
        {
            return session.now().objects()[object].path().subpaths().front();
        }
        app::Session session;
        app::NodeEditing& nodes = session.nodes;
        QSignalSpy refused{&session, &app::Session::refused};
    };
    static app::Subpath line(app::Point a, app::Point b) { return {a, {{b}}, false}; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    void movingIsOneStepAndKeepsTheSelection()
    {
        Drawing d({wave()});
        d.nodes.selectOnly({0, 1});
        QVERIFY(d.nodes.moveTo({0, 1}, {70, 7}));
        QCOMPARE(d.path().segments[0].to, app::Point(70, 7));
        QCOMPARE(d.session.history.count(), 1);
        QVERIFY((d.nodes.summary().only == app::NodeAddress{0, 1}));
        d.session.history.undo();
        QVERIFY(d.path() == wave());
        QVERIFY((d.nodes.summary().only == app::NodeAddress{0, 1}));
        QCOMPARE(d.nodes.path()[0].nodes[1].at, app::Point(60, 0));
    }
    void aTypeStaysWhereNoShapeChanges()
    {
        Drawing d({circle(10)});
        d.nodes.selectOnly({0, 1});
        QVERIFY(d.nodes.run(app::nodeStep("corner-nodes")));
        QCOMPARE(d.session.history.count(), 0);
        QCOMPARE(d.nodes.path()[0].nodes[1].type, app::NodeType::Corner);
        d.nodes.selectOnly({0, 3});
        d.nodes.move({5, 5});
        QCOMPARE(d.nodes.path()[0].nodes[1].type, app::NodeType::Corner);
    }
    void fourLinesBecomeOneObjectThatKeepsTheFirstId()
    {
        Drawing d({line({0, 0}, {10, 0}), line({10, 0}, {10, 10}), line({10, 10}, {0, 10}),
                   line({0, 10}, {0, 0})});
        QVERIFY(d.nodes.run(app::nodeStep("join-ends")));
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
        QVERIFY(d.path().closed);
        QCOMPARE(d.session.now().objects()[0].particulars().id, "id0");
        QCOMPARE(d.session.selection().size(), std::size_t(1));
        QCOMPARE(d.nodes.summary().selected, std::size_t(0));
        QCOMPARE(d.session.history.count(), 1);
        d.session.history.undo();
        QCOMPARE(d.session.now().objects().size(), std::size_t(4));
    }
    void theLastNodesRemoveTheObjectAndTheOthersKeepTheirNodes()
    {
        Drawing d({line({0, 0}, {10, 0}), circle(10)});
        d.nodes.select([](app::NodePath& path) {
            path[0].nodes[0].selected = path[1].nodes[2].selected = true;
        });
        QVERIFY(d.nodes.run(app::nodeStep("delete-nodes")));
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
        QCOMPARE(d.nodes.path().size(), std::size_t(1));
        QCOMPARE(d.nodes.path()[0].nodes.size(), std::size_t(3));
        QCOMPARE(d.nodes.objectOf(0), std::size_t(0));
    }
    void anAddedNodeIsSelected()
    {
        Drawing d({wave()});
        QVERIFY(d.nodes.insert({0, 0}, 0.5));
        QVERIFY((d.nodes.summary().only == app::NodeAddress{0, 1}));
        QCOMPARE(d.path().segments.size(), std::size_t(3));
        QVERIFY(!d.nodes.insert({0, 0}, NAN));
    }
    void tabGoesFromNodeToNode()
    {
        Drawing d({wave(), line({0, 0}, {5, 5})});
        for (const auto wanted : {app::NodeAddress{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {0, 0}}) {
            d.nodes.selectNeighbour(true);
            QVERIFY(d.nodes.summary().only == wanted);
        }
        d.nodes.selectNeighbour(false);
        QVERIFY((d.nodes.summary().only == app::NodeAddress{1, 1}));
    }
    void anotherSelectionHasNodesOfItsOwn()
    {
        Drawing d({line({0, 0}, {10, 0}), line({5, 5}, {9, 9})});
        d.session.select(app::ObjectRanges{0});
        d.nodes.selectAll(true);
        d.session.select(app::ObjectRanges{1});
        QCOMPARE(d.nodes.summary().selected, std::size_t(0));
        QCOMPARE(d.nodes.path()[0].nodes[0].at, app::Point(5, 5));
    }
    void aLockedLayerIsRefusedWithOneSentence()
    {
        Drawing d({wave()});
        d.nodes.selectOnly({0, 1});
        app::Containers tree = d.session.now().containers();
        app::Container layer = tree[tree.childrenOf(0)[0]];
        layer.locked = true;
        d.session.history.push(
            new app::SetContainers(d.session.document, tree.with(layer), "Lock"));
        d.session.select(app::ObjectRanges{0}); // as a program could
        const app::Document before = d.session.now();
        d.nodes.selectOnly({0, 1});
        QVERIFY(!d.nodes.move({1, 1}));
        QCOMPARE(d.refused.size(), 1);
        QVERIFY(d.refused[0][0].toString().contains("locked"));
        QVERIFY(!d.nodes.run(app::nodeStep("reverse-path")));
        QVERIFY(d.session.now() == before);
    }
    void numbersThatAreNotFiniteAreRefused()
    {
        Drawing d({wave()});
        d.nodes.selectOnly({0, 1});
        QVERIFY(!d.nodes.move({NAN, 0}));
        QVERIFY(!d.nodes.moveTo({0, 1}, {0, INFINITY}));
        d.nodes.moveTo({0, 1}, {1.7e308, 0});
        d.nodes.move({1.7e308, 0}); // beyond all numbers
        QVERIFY(d.refused.size() >= 3);
        for (const app::Subpath& subpath : d.session.now().objects()[0].path().subpaths())
            QVERIFY(app::isFinite(app::nodesOf(std::span(&subpath, 1))));
    }
    void withoutTheToolStepsOfWholePathsWorkAndOthersSayWhy()
    {
        Drawing d({wave()});
        d.nodes.setShown(false);
        QVERIFY(d.nodes.refusal(app::nodeStep("reverse-path")).isEmpty());
        QVERIFY(d.nodes.refusal(app::nodeStep("smooth-nodes")).contains("Nodes (N)"));
        QVERIFY(d.nodes.run(app::nodeStep("reverse-path")));
        QCOMPARE(d.path().start, app::Point(120, 10));
        d.session.select({});
        QVERIFY(d.nodes.refusal(app::nodeStep("reverse-path")).contains("selected"));
    }
    void endsFarApartAreNotJoined()
    {
        Drawing d({line({0, 0}, {10, 0}), line({500, 0}, {600, 0})});
        QVERIFY(!d.nodes.run(app::nodeStep("join-ends")));
        QVERIFY(d.refused[0][0].toString().contains("within 0.1 mm of"));
        QCOMPARE(d.session.history.count(), 0);
        d.session.arrange.joinWithin = 500;
        const auto done = d.nodes.tried(app::nodeStep("join-ends"));
        QVERIFY(done && d.refused.size() == 1);
        QCOMPARE(*done.value, "2 objects became 1: 1 pair of ends was joined within 500 mm.");
    }
    void endsOfSeveralLayersOrStylesAreNotJoined()
    {
        app::DocumentBuilder builder;
        const app::Style black{.stroke = app::Colour{}}, red{.stroke = app::Colour{255, 0, 0}};
        const auto add = [&](const app::Style& style, app::Point a, app::Point b) {
            builder.add(app::Object{app::Path(clipping::Segment{a, b}), style});
        };
        builder.open({.name = "lower"});
        add(black, {0, 0}, {10, 0});
        add(red, {10, 0}, {20, 0});
        builder.open({.kind = app::Container::Kind::Group});
        add(black, {10, 0}, {10, 9}); // the same layer
        builder.close();
        builder.close();
        builder.open({.name = "upper"});
        add(black, {10, 9}, {0, 0});
        builder.close();
        app::Session session;
        session.load({builder.take({}), {}});
        session.select(app::ObjectRanges(app::ObjectRange{0, 4}));
        const auto done = session.nodes.tried(app::nodeStep("join-ends"));
        QVERIFY2(done, qPrintable(done.error));
        QCOMPARE(*done.value, "4 objects became 3: 1 pair of ends was joined within 0.1 mm.");
        QCOMPARE(session.now().objects().size(), std::size_t(3));
        QVERIFY(session.now().objects()[0].path().subpaths()[0].segments.size() == 2);
        QCOMPARE(session.history.count(), 1);

        session.nodes.setShown(true);
        session.nodes.select([](app::NodePath& path) {
            path[1].nodes[1].selected = path[2].nodes[0].selected = true; // of red and black
        });
        QVERIFY(!session.nodes.asksTolerance(app::nodeStep("join-ends")));
        const auto refused = session.nodes.tried(app::nodeStep("join-ends"));
        QVERIFY(!refused && refused.error.contains("several layers or styles"));
        QCOMPARE(session.history.count(), 1);
    }
    // Whoever chooses two ends wants them joined, whatever the tolerance.
    void twoChosenEndsNeedNoTolerance()
    {
        Drawing d({line({0, 0}, {10, 0}), line({50, 0}, {60, 0})});
        QVERIFY(d.nodes.asksTolerance(app::nodeStep("join-ends")));
        QVERIFY(!d.nodes.asksTolerance(app::nodeStep("close-path")));
        d.nodes.select([](app::NodePath& path) {
            path[0].nodes[1].selected = path[1].nodes[0].selected = true;
        });
        QVERIFY(!d.nodes.asksTolerance(app::nodeStep("join-ends")));
        const auto done = d.nodes.tried(app::nodeStep("join-ends"));
        QVERIFY(done && done.value->isEmpty());
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
    }
    void theDistanceIsSaidInTheUnitOfTheWindow()
    {
        Drawing d({line({0, 0}, {10, 0}), line({500, 0}, {600, 0})});
        const auto saidAs = [&](app::Unit unit) {
            d.session.changeDisplay([&](app::Display& display) { display.unit = unit; });
            return d.nodes.tried(app::nodeStep("join-ends"))
                .error.section("within ", 1)
                .section(" of", 0, 0);
        };
        QCOMPARE(saidAs(app::Unit::Inch), "0.0039 in");
        d.session.arrange.joinWithin = 0.0254;
        QCOMPARE(saidAs(app::Unit::Inch), "0.001 in");
        d.session.arrange.joinWithin = 0;
        QCOMPARE(saidAs(app::Unit::Mm), "0 mm");
    }
    // Whole drawings are joined in one step. The time is printed, not tested.
    void aHundredThousandLinesAreOneStep()
    {
        app::DocumentBuilder builder;
        builder.open({});
        const app::StyleEntry style = builder.style({.stroke = app::Colour{}});
        for (int i = 0; i < 100'000; ++i) {
            const app::Point from(i % 317 * 0.5, i / 317 * 0.5);
            builder.addLine({from, from + app::Point(0.45, 0.01)}, style);
        }
        builder.close();
        app::Session session;
        session.load({builder.take({}), {}});
        session.select(app::ObjectRanges(app::ObjectRange{0, 100'000}));
        QElapsedTimer timer;
        timer.start();
        const auto done = session.nodes.tried(app::nodeStep("join-ends"));
        qInfo("joined in %lld ms", timer.elapsed());
        QVERIFY2(done, qPrintable(done.error));
        QCOMPARE(session.now().objects().size(), std::size_t(316));
        QCOMPARE(session.history.count(), 1);
        session.history.undo();
        QCOMPARE(session.now().objects().size(), std::size_t(100'000));
    }
    // The time is printed, not tested.
    void aMillionNodesAreEdited()
    {
        app::Subpath path{{0, 0}, {}, false};
        for (int i = 1; i < 1'000'000; ++i)
            path.segments.push_back({app::Point(i, i % 7)});
        Drawing d({path});
        QCOMPARE(d.nodes.summary().nodes, std::size_t(1'000'000));
        d.nodes.selectOnly({0, 500'000});
        QElapsedTimer timer;
        timer.start();
        QVERIFY(d.nodes.move({0, 50}));
        QVERIFY(d.nodes.run(app::nodeStep("smooth-nodes")));
        QVERIFY(d.nodes.run(app::nodeStep("delete-nodes")));
        QCOMPARE(d.nodes.summary().nodes, std::size_t(999'999));
        qInfo("edited in %lld ms", timer.elapsed());
    }
};

} // namespace session_node_editing_test

TEST_CLASS(session_node_editing_test::NodeEditingTest, Core)
#include "tests/app/session/node_editing_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"
#include "app/session/node_editing.h"
#include "app/session/session.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/app/nodes/shapes.h"

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
        QVERIFY(d.refused[0][0].toString().contains("1 mm"));
        QCOMPARE(d.session.history.count(), 0);
    }
    void aMillionNodesAreEditedInSeconds()
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
        QVERIFY2(timer.elapsed() < 10'000, qPrintable(QString::number(timer.elapsed())));
    }
};

QTEST_GUILESS_MAIN(NodeEditingTest)
#include "node_editing_test.moc"

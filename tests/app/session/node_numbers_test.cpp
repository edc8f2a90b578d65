// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/node_numbers.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_node_numbers_test {

using namespace app;

class NodeNumbersTest : public QObject {
    Q_OBJECT

    /// A line from (10, 20) to (40, 20), and a curve from there to (100, 20) and back, with smooth
    /// nodes; y down.
    struct Nodes : Session {
        Nodes()
        {
            DocumentBuilder builder;
            builder.open({.name = "Drawing"});
            const Subpath path{{10, 20},
                               {{{40, 20}},
                                {{100, 20}, {50, 20}, {100, 50}, true},
                                {{140, 20}, {100, 0}, {130, 20}, true}},
                               false};
            builder.add({.path = Path(std::span(&path, 1)), .style = {.stroke = Colour{}}});
            builder.close();
            load({builder.take({}), {}});
            changeDisplay([](app::Display& display) { display.unit = Unit::User; });
            select({0});
            nodes.setShown(true);
        }
        void choose(std::initializer_list<std::size_t> which)
        {
            nodes.select([&](NodePath& path) {
                selectAll(path, false);
                for (const std::size_t node : which)
                    path[0].nodes[node].selected = true;
            });
        }
        static const NodeNumber& number(std::string_view key)
        {
            return *std::ranges::find(nodeNumbers(), key, &NodeNumber::key);
        }
        std::optional<NodeValue> value(std::string_view key) const
        {
            return nodeValue(*this, number(key));
        }
        bool set(std::string_view key, double to) { return setNodeNumber(*this, number(key), to); }
        Node node(std::size_t i) const { return nodes.path()[0].nodes[i]; }
    };
    static bool near(const Point& a, const Point& b)
    {
        return std::abs(a.x - b.x) < 1e-9 && std::abs(a.y - b.y) < 1e-9;
    }

private slots:
    void aNodeHasAPlaceAndHandles()
    {
        Nodes t;
        t.choose({2});
        QCOMPARE(t.value("node-x")->first, 100.0);
        QCOMPARE(t.value("node-y")->first, 20.0);
        QCOMPARE(t.value("in-length")->first, 30.0);
        QCOMPARE(t.value("in-angle")->first, -90.0);
        QCOMPARE(t.value("out-length")->first, 20.0);
        QCOMPARE(t.value("out-angle")->first, 90.0);
        QCOMPARE(typeOfNodes(t), std::optional(NodeType::Smooth));
        QCOMPARE(nodesText(t), QString("node 3 of 4"));
        t.choose({0}); // beside a straight segment
        QVERIFY(t.value("node-x") && !t.value("in-length") && !t.value("out-angle"));
        t.choose({});
        QVERIFY(!t.value("node-x") && !typeOfNodes(t));
    }
    void eachNumberIsOneStepAndExact()
    {
        Nodes t;
        t.choose({2});
        QVERIFY(t.set("node-x", 90.1));
        QCOMPARE(t.node(2).at, Point(90.1, 20));
        QVERIFY(near(t.node(2).in, {90.1, 50}));
        QVERIFY(t.set("in-length", 10));
        QVERIFY(near(t.node(2).in, {90.1, 30}));
        QVERIFY(near(t.node(2).out, {90.1, 0})); // a smooth node keeps the other length
        QVERIFY(t.set("out-angle", 0));
        QVERIFY(near(t.node(2).out, {110.1, 20}) && near(t.node(2).in, {80.1, 20}));
        QCOMPARE(t.history.count(), 3);
        for (int i = 0; i < 3; ++i)
            t.history.undo();
        QCOMPARE(t.node(2).at, Point(100, 20));
        QCOMPARE(t.node(2).in, Point(100, 50));
    }
    void symmetricHandlesStayEquallyLong()
    {
        Nodes t;
        t.choose({2});
        QVERIFY(t.nodes.run(nodeStep("symmetric-nodes")));
        QVERIFY(t.set("out-length", 8));
        QVERIFY(near(t.node(2).out, {100, 12}) && near(t.node(2).in, {100, 28}));
    }
    void severalNodesShareANumberOrDiffer()
    {
        Nodes t;
        t.choose({1, 2});
        QVERIFY(t.value("node-x")->mixed && !t.value("node-y")->mixed);
        QVERIFY(!t.value("in-length")->mixed); // only one of them has it
        QCOMPARE(nodesText(t), QString("2 of 4 nodes"));
        QVERIFY(t.set("node-x", 60));
        QCOMPARE(t.node(1).at, Point(60, 20));
        QCOMPARE(t.node(2).at, Point(60, 20));
        QCOMPARE(t.history.count(), 1);
    }
    void whatIsImpossibleIsRefusedWithASentence()
    {
        Nodes t;
        const QSignalSpy refused(&t, &Session::refused);
        t.choose({2});
        QVERIFY(!t.set("in-length", 0));
        QVERIFY(!t.set("node-x", std::numeric_limits<double>::infinity()));
        t.choose({0});
        QVERIFY(!t.set("out-angle", 5));
        QCOMPARE(refused.count(), 3);
        for (const auto& sentence : refused)
            QVERIFY(sentence[0].toString().endsWith(u'.'));
        QCOMPARE(t.history.count(), 0);
    }
};

} // namespace session_node_numbers_test

TEST_CLASS(session_node_numbers_test::NodeNumbersTest, Core)
#include "tests/app/session/node_numbers_test.moc"

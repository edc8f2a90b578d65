// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers_builder.h"
#include "app/document/object_tree.h"

#include <QTest>

#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace document_object_tree_test {

using namespace app;
using Kind = TreeRow::Kind;

namespace {

/// Layers, layers in layers, groups in groups, and objects between them.
class RandomTree {
public:
    explicit RandomTree(unsigned seed) : random_(seed)
    {
        for (std::size_t i = random_.whole(1, 4); i > 0; --i)
            fill(Container::Kind::Layer, 1);
    }
    Containers take() { return builder_.take(); }

private:
    void fill(Container::Kind kind, int depth)
    {
        builder_.open({.kind = kind});
        for (std::size_t i = random_.whole(0, 5); i > 0; --i) {
            if (random_.whole(0, 1) == 0 || depth > 5)
                builder_.addObjects(random_.whole(1, 3));
            else if (kind == Container::Kind::Layer && random_.whole(0, 1) == 0)
                fill(Container::Kind::Layer, depth + 1);
            else
                fill(Container::Kind::Group, depth + 1);
        }
        if (kind == Container::Kind::Group)
            builder_.addObjects(1); // a group without objects is none
        builder_.close();
    }

    Random random_;
    ContainersBuilder builder_;
};

ContainerId id(const TreeRow& row) { return row.container; }

/// One layer with `count` lines, then a layer with a group of three between two objects.
struct Example {
    explicit Example(std::size_t count)
    {
        ContainersBuilder builder;
        low = builder.open({.name = "low"});
        builder.addObjects(count);
        builder.close();
        high = builder.open({.name = "high"});
        builder.addObjects(1);
        group = builder.open({.kind = Container::Kind::Group});
        builder.addObjects(3);
        builder.close();
        builder.addObjects(1);
        builder.close();
        tree = builder.take();
    }
    ContainerId low = 0, high = 0, group = 0;
    Containers tree;
};

} // namespace

class ObjectTreeTest : public QObject {
    Q_OBJECT

private slots:
    // Each object and each container has one row, from above, where the document says it is.
    void everyRowIsWhereTheDocumentSays()
    {
        for (unsigned seed = 1; seed <= 300; ++seed) {
            const Containers tree = RandomTree(seed).take();
            ObjectTree open;
            for (const ContainerId each : tree.inOrder())
                open.setOpen(each, true);
            std::size_t next = tree.objects(), containers = 0;
            for (const TreeRow& row : open.rows(tree)) {
                QVERIFY(row.kind != Kind::More);
                if (row.kind == Kind::Object) {
                    QCOMPARE(row.number, --next);
                    QCOMPARE(row.container, tree.containerOf(row.number));
                    QCOMPARE(row.depth, tree.depthOf(row.container) + 1);
                } else {
                    ++containers;
                    QCOMPARE(row.depth, tree.depthOf(row.container));
                    QCOMPARE(row.kind == Kind::Layer,
                             tree[row.container].kind == Container::Kind::Layer);
                    QCOMPARE(tree.rangeOf(row.container).end, next);
                }
            }
            QCOMPARE(next, std::size_t(0));
            QCOMPARE(containers, tree.size());
        }
    }
    void whatIsClosedShowsOnlyItsLayers()
    {
        for (unsigned seed = 1; seed <= 100; ++seed) {
            const Containers tree = RandomTree(seed).take();
            std::size_t layers = 0;
            for (const ContainerId each : tree.inOrder())
                layers += tree[each].kind == Container::Kind::Layer;
            const auto rows = ObjectTree().rows(tree);
            QCOMPARE(rows.size(), layers);
            QVERIFY(std::ranges::all_of(
                rows, [](const TreeRow& row) { return row.kind == Kind::Layer; }));
        }
    }
    void someOfManyAreShown()
    {
        const Example example(1300);
        ObjectTree open;
        open.setOpen(example.low, true);
        auto rows = open.rows(example.tree); // high, low, its objects from above
        QCOMPARE(rows.size(), std::size_t(2 + 500 + 1));
        QCOMPARE(rows[2], (TreeRow{Kind::Object, example.low, 1299, 2}));
        QCOMPARE(rows.back(), (TreeRow{Kind::More, example.low, 800, 2}));
        open.showMore(example.low);
        rows = open.rows(example.tree);
        QCOMPARE(rows.back(), (TreeRow{Kind::More, example.low, 300, 2}));
        open.showMore(example.low);
        rows = open.rows(example.tree);
        QCOMPARE(rows.back(), (TreeRow{Kind::Object, example.low, 0, 2}));
    }
    void whatIsRevealedIsClosedAgain()
    {
        const Example example(1300);
        ObjectTree open;
        const auto closed = open.rows(example.tree);
        open.revealObject(example.tree, 1302); // in the group
        QVERIFY(open.isOpen(example.high) && open.isOpen(example.group));
        open.revealObject(example.tree, 1299);
        QVERIFY(!open.isOpen(example.high) && open.isOpen(example.low));
        open.revealObject(example.tree, 3); // not among the first
        QCOMPARE(open.rows(example.tree), closed);
        open.revealObject(example.tree, 1299);
        open.conceal();
        QCOMPARE(open.rows(example.tree), closed);
        // What the person opened stays open.
        open.setOpen(example.high, true);
        open.revealGroup(example.tree, example.group);
        QVERIFY(!open.isOpen(example.group));
        open.conceal();
        QVERIFY(open.isOpen(example.high));
        open.revealObject(example.tree, 1302);
        open.keep();
        open.conceal();
        QVERIFY(open.isOpen(example.group));
    }
    void everyObjectIsFoundAfterItWasRevealed()
    {
        for (unsigned seed = 1; seed <= 100; ++seed) {
            const Containers tree = RandomTree(seed).take();
            ObjectTree open;
            for (std::size_t object = 0; object < tree.objects(); ++object) {
                open.revealObject(tree, object);
                const auto rows = open.rows(tree);
                QCOMPARE(std::ranges::count_if(rows,
                                               [&](const TreeRow& row) {
                                                   return row.kind == Kind::Object
                                                          && row.number == object;
                                               }),
                         1);
            }
        }
    }
    void whatIsGoneIsForgotten()
    {
        const Example example(10);
        ObjectTree open;
        open.setOpen(example.group, true);
        const Containers without = example.tree.dissolved(example.group);
        open.forgetGone(without);
        QVERIFY(!open.isOpen(example.group));
        QVERIFY(std::ranges::all_of(open.rows(without),
                                    [&](const TreeRow& row) { return id(row) != example.group; }));
    }
};

} // namespace document_object_tree_test

TEST_CLASS(document_object_tree_test::ObjectTreeTest, None)
#include "tests/app/document/object_tree_test.moc"

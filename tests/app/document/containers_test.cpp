// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers.h"
#include "app/document/containers_builder.h"

#include <QTest>

#include <set>

#include "tests/app/document/nested_containers.h"
#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace document_containers_test {

using namespace app;
using Kind = Container::Kind;
using nested::Item;
using nested::Node;
using nested::Seen;

namespace {

ObjectRanges rangesOf(const std::vector<Seen>& all, auto holds)
{
    ObjectRanges ranges;
    for (const Seen& each : all)
        if (holds(each))
            ranges.insert(ObjectRange{each.first, each.first + each.node->objects()});
    return ranges;
}

// Every question, asked of both.
bool agrees(const Containers& tree, const Item& root)
{
    const auto all = seen(root);
    const auto owners = nested::owners(root);
    bool same = tree.size() == all.size() && tree.objects() == owners.size();
    std::vector<ContainerId> order;
    for (const Seen& each : all)
        order.push_back(each.node->container.id);
    same = same && tree.inOrder() == order;
    const auto childrenAre = [&](const Node& node) {
        std::vector<ContainerId> children;
        for (const Item& item : node.items)
            if (item)
                children.push_back(item->container.id);
        return tree.childrenOf(node.container.id) == children;
    };
    same = same && childrenAre(*root) && tree.rangeOf(0) == ObjectRange{0, owners.size()};
    for (const Seen& each : all) {
        const ContainerId id = each.node->container.id;
        same = same && tree.contains(id) && tree[id] == each.node->container
               && tree.parentOf(id) == each.parent && tree.depthOf(id) == each.depth
               && tree.shown(id) == each.shown && tree.locked(id) == each.locked
               && tree.rangeOf(id) == ObjectRange{each.first, each.first + each.node->objects()}
               && childrenAre(*each.node);
    }
    for (std::size_t i = 0; same && i < owners.size(); ++i)
        same = tree.containerOf(i) == owners[i]->container.id
               && tree.layerOf(i) == nested::layerAround(all, owners[i]);
    return same && tree.hiddenRanges() == rangesOf(all, [](const Seen& s) { return !s.shown; })
           && tree.lockedRanges() == rangesOf(all, [](const Seen& s) { return s.locked; });
}

/// A tree and its model, edited alike at random.
class Edited {
public:
    explicit Edited(unsigned seed) : random_(seed), root_(std::make_shared<Node>())
    {
        root_->items.push_back(std::make_shared<Node>(Node{tree_[1]}));
    }
    const Containers& tree() const { return tree_; }
    const Item& root() const { return root_; }
    bool agree() const { return agrees(tree_, root_); }

    const char* edit(std::size_t most)
    {
        const int kind = random_.whole(0, tree_.size() < most ? 11 : 5);
        if (kind < 3)
            return splice(tree_.objects() < 4 * most ? 9 : 0), "splice";
        if (kind == 3)
            return change(), "with";
        if (kind == 4)
            return dissolve(), "dissolved";
        if (kind == 5)
            return remove(), "removed";
        return insert(), "inserted";
    }

private:
    Seen any()
    {
        const auto all = seen(root_);
        return all[std::size_t(random_.whole(0, int(all.size()) - 1))];
    }
    Item parentOf(const Seen& each)
    {
        for (const Seen& other : seen(root_))
            if (other.node->container.id == each.parent)
                return other.node;
        return root_;
    }

    void splice(int mostAdded)
    {
        const auto first = std::size_t(random_.whole(0, int(tree_.objects())));
        const auto left = int(tree_.objects() - first);
        const int most = random_.whole(0, 9) > 0 ? 5 : random_.whole(0, 9) > 0 ? 40 : left;
        const auto removed = std::size_t(random_.whole(0, std::min(left, most)));
        const auto added = std::size_t(random_.whole(0, mostAdded));
        const Item before = nested::copy(root_);
        nested::takeAway(before, 0, first, first + removed);
        ContainerId into = 0;
        std::vector<ContainerId> fit; // where they can come to
        for (const Seen& each : seen(before))
            if (nested::putIn(nested::copy(each.node), each.first, first, 1,
                              each.node->container.id))
                fit.push_back(each.node->container.id);
        if (fit.empty())
            return;
        into = fit[std::size_t(random_.whole(0, int(fit.size()) - 1))];
        nested::splice(root_, first, removed, added, into);
        tree_ = tree_.spliced(first, removed, added, into);
    }
    void change()
    {
        Container& container = any().node->container;
        container.name = QString::number(random_.whole(0, 999));
        container.visible = random_.whole(0, 3) > 0;
        container.locked = random_.whole(0, 3) == 0;
        tree_ = tree_.with(container);
    }
    void dissolve()
    {
        const Seen each = any();
        if (each.parent == 0)
            return;
        auto& items = parentOf(each)->items;
        const auto at = std::ranges::find(items, each.node) - items.begin();
        items.erase(items.begin() + at);
        items.insert(items.begin() + at, each.node->items.begin(), each.node->items.end());
        tree_ = tree_.dissolved(each.node->container.id);
    }
    void remove()
    {
        const Seen each = any();
        if (each.parent == 0 && root_->items.size() == 1)
            return;
        if (seen(each.node).size() > 30 && random_.whole(0, 99)) // else trees stay small
            return;
        std::erase(parentOf(each)->items, each.node);
        tree_ = tree_.removed(each.node->container.id);
    }
    void insert()
    {
        Seen parent = any();
        if (random_.whole(0, 9) == 0)
            parent = {root_, 0, 0, 0, true, false};
        auto& items = parent.node->items;
        const auto slot = std::size_t(random_.whole(0, int(items.size())));
        const auto wanted = std::size_t(random_.whole(0, 4));
        std::size_t at = 0, first = parent.first;
        for (std::size_t i = 0; i < slot; ++i) {
            at += items[i] != nullptr;
            first += items[i] ? items[i]->objects() : 1;
        }
        std::size_t end = slot, last = first;
        for (; end < items.size() && end < slot + wanted; ++end)
            last += items[end] ? items[end]->objects() : 1;
        for (end = slot, wantedEnd_ = first; wantedEnd_ < last; ++end) // what begins before `last`
            wantedEnd_ += items[end] ? items[end]->objects() : 1;
        const std::vector<Item> taken(items.begin() + std::ptrdiff_t(slot),
                                      items.begin() + std::ptrdiff_t(end));
        const bool layers =
            parent.node == root_ || std::ranges::any_of(taken, [](const Item& item) {
                return item && !item->isGroup();
            });
        Container made{.id = tree_.nextId(), .kind = Kind::Layer, .name = QStringLiteral("new")};
        if (parent.node->isGroup() || (!layers && random_.whole(0, 2)))
            made.kind = Kind::Group;
        const auto tree = tree_.inserted(made, parent.node->container.id, at, {first, last});
        if (!tree)
            return;
        tree_ = *tree;
        items.erase(items.begin() + std::ptrdiff_t(slot), items.begin() + std::ptrdiff_t(end));
        items.insert(items.begin() + std::ptrdiff_t(slot),
                     std::make_shared<Node>(Node{made, taken}));
    }

    Random random_;
    Containers tree_;
    Item root_;
    std::size_t wantedEnd_ = 0;
};

/// A layer with so many groups of three objects.
Containers wide(std::size_t groups)
{
    ContainersBuilder builder;
    builder.open({});
    for (std::size_t i = 0; i < groups; ++i) {
        builder.open({.kind = Kind::Group});
        builder.addObjects(3);
        builder.close();
    }
    builder.close();
    return builder.take();
}

Containers deep(int levels)
{
    ContainersBuilder builder;
    for (int i = 0; i < levels; ++i) {
        builder.open({.kind = i == 0 ? Kind::Layer : Kind::Group});
        builder.addObjects();
    }
    for (int i = 0; i < levels; ++i)
        builder.close();
    return builder.take();
}

/// Layers and groups at random, of up to three objects between their ends; some are empty.
Containers nestedTree(Random& random, int most)
{
    ContainersBuilder builder;
    std::vector<Kind> open;
    for (int i = random.whole(1, most); i > 0 || !open.empty(); --i) {
        if (i > 0 && (open.empty() || random.whole(0, 1))) {
            const bool group = !open.empty() && (open.back() == Kind::Group || random.whole(0, 1));
            open.push_back(group ? Kind::Group : Kind::Layer);
            builder.open({.kind = open.back()});
        } else {
            builder.close();
            open.pop_back();
        }
        if (!open.empty())
            builder.addObjects(std::size_t(std::max(0, random.whole(-2, 3))));
    }
    return builder.take();
}

/// Each takes some objects; many of them follow each other at once.
std::vector<Splice> splicesOf(const Containers& tree, Random& random)
{
    std::vector<Splice> splices;
    const int farthest = random.whole(0, 1) ? random.whole(0, 300) : 2;
    for (std::size_t at = 0; at < tree.objects();) {
        at += std::size_t(std::max(0, random.whole(-farthest, farthest)));
        if (at >= tree.objects())
            break;
        const auto removed = random.whole(1, std::min(4, int(tree.objects() - at)));
        const int added = random.whole(0, 2) ? random.whole(0, 3) : removed;
        splices.push_back({std::uint32_t(at), std::uint32_t(removed), std::uint32_t(added)});
        at += std::size_t(removed);
    }
    return splices;
}

Containers oneByOne(Containers tree, const std::vector<Splice>& splices)
{
    for (std::size_t i = splices.size(); i-- > 0;) {
        const auto& [first, removed, added] = splices[i];
        std::set<ContainerId> from;
        for (std::size_t k = first; k < std::size_t(first) + removed; ++k)
            from.insert(tree.containerOf(k));
        if (removed != added || from.size() > 1)
            tree = tree.spliced(first, removed, added, tree.containerOf(first));
    }
    return tree;
}

std::size_t stepsOf(const auto& question)
{
    ContainerMarks::steps = 0;
    question();
    return ContainerMarks::steps;
}

} // namespace

class ContainersTest : public QObject {
    Q_OBJECT

private slots:
    void aNewTreeHasOneLayer()
    {
        const Containers tree;
        QCOMPARE(tree.inOrder(), std::vector<ContainerId>{1});
        QCOMPARE(tree[1].name, QStringLiteral("Drawing"));
        QCOMPARE(tree[1].kind, Kind::Layer);
        QCOMPARE(tree.objects(), 0u);
        QCOMPARE(tree.rangeOf(1), (ObjectRange{0, 0}));
    }
    void randomEditsDoWhatTheyShould()
    {
        std::map<std::string, int> done;
        for (unsigned seed = 1; seed <= 60; ++seed) {
            Edited edited(seed);
            Containers before;
            Item model = nested::copy(edited.root());
            for (int i = 0; i < 150; ++i) {
                const std::string name = edited.edit(40);
                ++done[name];
                QVERIFY2(edited.agree(),
                         (name + " " + std::to_string(seed) + " " + std::to_string(i)).c_str());
                if (i % 30 == 0) { // what others share is left alone
                    QVERIFY(agrees(before, model));
                    before = edited.tree();
                    model = nested::copy(edited.root());
                }
            }
        }
        for (const auto& [name, count] : done)
            QVERIFY2(count > 300, name.c_str());
        QCOMPARE(done.size(), 5u);
    }
    // Enough for many blocks, which split and join.
    void largeTreesAreEditedAlike()
    {
        Edited edited(77);
        for (int i = 0; i < 4'000; ++i) {
            edited.edit(2'500);
            if (i % 200 == 0)
                QVERIFY2(edited.agree(), std::to_string(i).c_str());
        }
        QVERIFY(edited.agree());
        QVERIFY2(edited.tree().size() > 500, std::to_string(edited.tree().size()).c_str());
    }
    void aGroupVanishesWithItsLastObject()
    {
        ContainersBuilder builder;
        const auto layer = builder.open({});
        const auto outer = builder.open({.kind = Kind::Group});
        const auto empty = builder.open({.kind = Kind::Group});
        builder.close();
        const auto inner = builder.open({.kind = Kind::Group});
        builder.addObjects(2);
        builder.close();
        builder.close();
        builder.addObjects(1);
        builder.close();
        const Containers tree = builder.take();
        QCOMPARE(tree.spliced(0, 1, 0, layer).size(), 4u);
        QCOMPARE(tree.spliced(0, 2, 0, layer).inOrder(), std::vector<ContainerId>{layer});
        QCOMPARE(tree.spliced(0, 2, 1, inner).size(), 4u);
        QCOMPARE(tree.spliced(0, 2, 1, outer).inOrder(), (std::vector{layer, outer, empty}));
        QCOMPARE(tree.spliced(0, 3, 0, layer).inOrder(), std::vector<ContainerId>{layer});
        QCOMPARE(tree.spliced(2, 1, 0, layer).size(), 4u); // one that was empty before stays
        QVERIFY(!tree.spliced(0, 2, 0, layer).contains(empty));
    }
    // At many places at once is the same as at one after the other, from the last.
    void manySplicesAreThoseOneByOne()
    {
        Random random(11);
        for (int round = 0; round < 3'000; ++round) {
            const Containers tree = nestedTree(random, round % 10 == 0 ? 900 : 20);
            const auto splices = splicesOf(tree, random);
            const Containers expected = oneByOne(tree, splices);
            const Containers after = tree.spliced(splices);
            QVERIFY2(after == expected, std::to_string(round).c_str());
            QCOMPARE(after.size(), after.inOrder().size());
            for (const ContainerId id : tree.inOrder())
                QCOMPARE(after.contains(id), expected.contains(id));
        }
    }
    void whatNothingGoesForComesInto()
    {
        const Containers tree = wide(2); // objects 0 to 2 and 3 to 5
        const std::vector<Splice> splices{{1, 1, 2}, {3, 0, 4}, {3, 1, 0}, {6, 0, 0}};
        QCOMPARE(tree.spliced(splices, 1).rangeOf(2), (ObjectRange{0, 4}));
        QCOMPARE(tree.spliced(splices, 1).rangeOf(3), (ObjectRange{8, 10}));
        QCOMPARE(tree.spliced(splices, 2).rangeOf(2), (ObjectRange{0, 8}));
        QCOMPARE(tree.spliced(splices, 3).rangeOf(3), (ObjectRange{4, 10}));
        QVERIFY(tree.spliced(std::span<const Splice>()) == tree);
    }
    // What comes to the tops of several containers is added to each of them, and to those around.
    void eachSpliceHasItsContainer()
    {
        Random random(12);
        for (int round = 0; round < 3'000; ++round) {
            const Containers tree = nestedTree(random, round % 10 == 0 ? 900 : 20);
            std::vector<ContainerId> into = tree.inOrder();
            const int share = random.whole(1, round % 20 == 0 ? 100 : 4);
            std::erase_if(into, [&](ContainerId) { return random.whole(1, share) > 1; });
            std::ranges::sort(into,
                              [&](ContainerId a, ContainerId b) { return tree.endsBefore(a, b); });
            std::vector<Splice> splices;
            for (const ContainerId id : into)
                splices.push_back(
                    {std::uint32_t(tree.rangeOf(id).end), 0, std::uint32_t(random.whole(1, 3))});
            Containers expected = tree;
            for (std::size_t i = splices.size(); i-- > 0;)
                expected = expected.spliced(splices[i].first, 0, splices[i].added, into[i]);
            const Containers after = tree.spliced(splices, into);
            QVERIFY2(after == expected, std::to_string(round).c_str());
            std::size_t added = 0;
            for (std::size_t i = 0; i < splices.size(); ++i) {
                const std::size_t first = splices[i].first + added;
                added += splices[i].added;
                for (std::size_t k = first; k < first + splices[i].added; ++k)
                    QCOMPARE(after.containerOf(k), into[i]);
            }
            QCOMPARE(after.objects(), tree.objects() + added);
        }
    }
    void treesAreEqualHoweverTheyWereMade()
    {
        const Containers built = wide(400);
        Containers grown = wide(0);
        for (ContainerId i = 0; i < 400; ++i) {
            const std::size_t end = grown.objects();
            grown = *grown.inserted({.kind = Kind::Group}, 1, i, {end, end});
            grown = grown.spliced(end, 0, 3, 2 + i);
        }
        QVERIFY(grown == built);
        QVERIFY(!(grown.spliced(5, 1, 0, 1) == built));
        QVERIFY(!(grown.spliced(5, 1, 0, 1).spliced(6, 0, 1, 4) == built));
        QVERIFY(
            !(grown.with({.id = 5, .kind = Kind::Group, .name = QStringLiteral("x")}) == built));
        QVERIFY(grown.with(grown[5]) == built);
    }
    void idsAreNotGivenAgain()
    {
        Containers tree;
        std::set<ContainerId> ids;
        for (int i = 0; i < 1'000; ++i) {
            QVERIFY(ids.insert(tree.nextId()).second);
            const ContainerId id = tree.nextId();
            tree = tree.inserted({}, 0, 1, {0, 0})->removed(id);
            QVERIFY(!tree.contains(id));
        }
        QCOMPARE(tree.size(), 1u);
    }
    void idsCanStartHigher()
    {
        Containers tree;
        for (const ContainerId next : {ContainerId(3), ContainerId(256), ContainerId(1'000'000)}) {
            const Containers before = tree;
            tree.startIdsAt(next);
            tree.startIdsAt(2);
            QCOMPARE(tree.nextId(), next);
            QVERIFY(tree == before && !tree.contains(next - 1));
            tree = *tree.inserted({}, 0, 1, {0, 0});
            QVERIFY(tree.contains(next) && !tree.contains(next - 1) && !before.contains(next));
        }
        QCOMPARE(tree.inOrder(), (std::vector<ContainerId>{1, 1'000'000, 256, 3}));
    }
    void treesAreNotTooDeep()
    {
        {
            const Containers tree = deep(Containers::deepest); // also destroyed without trouble
            QCOMPARE(tree.depthOf(Containers::deepest), Containers::deepest);
            QVERIFY(!tree.inserted({.kind = Kind::Group}, Containers::deepest, 0, {499, 500}));
            QVERIFY(tree.inserted({.kind = Kind::Group}, Containers::deepest - 1, 1, {500, 500}));
            // Around those that are there: the innermost would be too deep.
            QVERIFY(!tree.inserted({.kind = Kind::Group}, 1, 0, {1, 500}));
            QVERIFY(tree.dissolved(2).inserted({.kind = Kind::Group}, 1, 0, {1, 500}));
        }
        ContainersBuilder builder;
        for (int i = 0; i < Containers::deepest; ++i) {
            QVERIFY(builder.canOpen());
            builder.open({.kind = i == 0 ? Kind::Layer : Kind::Group});
        }
        QVERIFY(!builder.canOpen());
        builder.close();
        QVERIFY(builder.canOpen());
    }
    void treesAreNotTooLarge()
    {
        const Containers tree = wide(Containers::mostContainers - 2);
        const auto full = tree.inserted({}, 0, 1, {tree.objects(), tree.objects()});
        QVERIFY(full.has_value());
        QCOMPARE(full->size(), Containers::mostContainers);
        QVERIFY(!full->inserted({}, 0, 0, {0, 0}));
        ContainersBuilder builder;
        builder.open({});
        for (std::size_t i = 1; i < Containers::mostContainers; ++i) {
            QVERIFY(builder.canOpen());
            builder.open({.kind = Kind::Group});
            builder.close();
        }
        QVERIFY(!builder.canOpen());
    }
    // Steps, not times: the largest trees must answer and change within a few blocks.
    void stepsAreBounded()
    {
        const std::size_t groups = Containers::mostContainers - 501;
        const Containers tree = wide(groups);
        constexpr std::size_t block = ContainerMarks::mostInBlock,
                              blocks = 2 * 100'000 / (block / 2);
        Random random(9);
        for (int i = 0; i < 200; ++i) {
            const auto id = ContainerId(random.whole(2, int(groups)));
            const auto object = std::size_t(random.whole(0, int(tree.objects()) - 1));
            QVERIFY(stepsOf([&] { tree.rangeOf(id); }) < 2 * block + 100);
            QVERIFY(stepsOf([&] { tree.containerOf(object); }) < block + 100);
            QVERIFY(stepsOf([&] { tree.shown(id); }) == 0);
            QVERIFY(stepsOf([&] { tree.with(tree[id]); }) == 0);
            const auto splice = [&] { tree.spliced(object, 1, 1, tree.containerOf(object)); };
            QVERIFY(stepsOf(splice) < 6 * block + blocks);
            const auto inGroup = [&] {
                tree.inserted({.kind = Kind::Group}, id, 0, tree.rangeOf(id));
            };
            QVERIFY(stepsOf(inGroup) < 20 * block + 2 * blocks);
            QVERIFY(stepsOf([&] { tree.dissolved(id); }) < 20 * block + 2 * blocks);
            QVERIFY(stepsOf([&] { tree.removed(id); }) < 20 * block + 2 * blocks);
        }
        const std::size_t all = 2 * groups;
        QVERIFY(stepsOf([&] { QCOMPARE(tree.childrenOf(1).size(), groups); }) < 5 * all);
        QVERIFY(stepsOf([&] { tree.hiddenRanges(); }) < 2 * all);
        QVERIFY(stepsOf([&] { QCOMPARE(tree.spliced(0, tree.objects(), 0, 1).size(), 1u); })
                < 5 * all);
    }
    // A few splices look at a few blocks, many at each mark a few times.
    void stepsOfManySplicesAreBounded()
    {
        const std::size_t groups = Containers::mostContainers - 1;
        const Containers tree = wide(groups);
        const auto splicesOf = [&](std::size_t count) {
            std::vector<Splice> splices;
            for (std::size_t i = 0; i < count; ++i)
                splices.push_back({std::uint32_t(tree.objects() / count * i), 1, 0});
            return splices;
        };
        const std::size_t all = 2 * groups;
        constexpr std::size_t block = ContainerMarks::mostInBlock;
        const auto few = splicesOf(10), many = splicesOf(groups);
        QVERIFY(stepsOf([&] { tree.spliced(few); }) < few.size() * (6 * block + all / block * 2));
        QVERIFY(stepsOf([&] { tree.spliced(many); }) < 5 * all);
        QCOMPARE(tree.spliced(many).objects(), 2 * groups);
    }
    // New layers on top, at the bottom, in the middle: labels run out at times, and are made anew.
    void manyInsertionsAtOnePlaceStayCheap()
    {
        for (const int place : {0, 1, 2}) {
            Containers tree = wide(20'000);
            std::size_t steps = 0;
            for (std::size_t i = 0; i < 300; ++i) {
                const std::size_t at = place == 0 ? 0 : place == 1 ? i + 1 : (i + 1) / 2;
                const auto layers = tree.childrenOf(0);
                const std::size_t end = at == 0 ? 0 : tree.rangeOf(layers[at - 1]).end;
                steps += stepsOf([&] { tree = *tree.inserted({}, 0, at, {end, end}); });
            }
            QVERIFY2(steps / 300 < 6'000, std::to_string(steps / 300).c_str());
            QCOMPARE(tree.size(), 20'301u);
        }
    }
};

} // namespace document_containers_test

TEST_CLASS(document_containers_test::ContainersTest, Gui)
#include "tests/app/document/containers_test.moc"

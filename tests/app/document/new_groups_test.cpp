// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers_builder.h"

#include <QTest>

#include "tests/test_class.h"

namespace document_new_groups_test {

using namespace app;

namespace {

constexpr auto group = Container::Kind::Group;

// "layer[2 a[1]]": each container with the objects directly in it, in order.
QString textOf(const Containers& tree)
{
    QString text;
    const Containers::Parts parts = tree.parts();
    for (const ContainerMark& mark : parts.marks) {
        if (mark.id != 0)
            text += mark.closes ? QStringLiteral("]") : tree[mark.id].name + u'[';
        if (mark.objects > 0)
            text += QString::number(mark.objects);
    }
    return text;
}

} // namespace

class NewGroupsTest : public QObject {
    Q_OBJECT

private slots:
    void groupsStandAmongTheObjects()
    {
        ContainersBuilder builder;
        builder.open({.name = "L"});
        builder.addObjects(3);
        builder.open({.kind = group, .name = "G"});
        builder.addObjects(4);
        builder.close();
        builder.addObjects(2);
        builder.close();
        const Containers tree = builder.take();
        const std::vector<NewGroup> groups{{{0, 2}, {.name = "a"}},
                                           {{3, 5}, {.name = "b"}},
                                           {{5, 7}, {.name = "c"}},
                                           {{8, 9}, {.name = "d"}}};
        const auto with = withGroups(tree, groups);
        QVERIFY(with);
        QCOMPARE(textOf(*with), QStringLiteral("L[a[2]1G[b[2]c[2]]1d[1]]"));
        QCOMPARE(with->objects(), tree.objects());
        QCOMPARE(with->nextId(), tree.nextId() + 4);
        QVERIFY(*withGroups(tree, {}) == tree);
    }

    void tooManyAreRefused()
    {
        ContainersBuilder builder;
        builder.open({.name = "L"});
        for (int depth = 1; depth < Containers::deepest; ++depth)
            builder.open({.kind = group});
        builder.addObjects(2);
        for (int depth = 0; depth < Containers::deepest; ++depth)
            builder.close();
        const std::vector<NewGroup> one{{{0, 2}, {}}};
        QVERIFY(!withGroups(builder.take(), one));

        ContainersBuilder flat;
        flat.open({.name = "L"});
        flat.addObjects(Containers::mostContainers);
        flat.close();
        std::vector<NewGroup> many;
        for (std::size_t i = 0; i < Containers::mostContainers; ++i)
            many.push_back({{i, i + 1}, {}});
        const Containers tree = flat.take();
        QVERIFY(!withGroups(tree, many));
        many.pop_back();
        QVERIFY(withGroups(tree, many));
    }
};

} // namespace document_new_groups_test

TEST_CLASS(document_new_groups_test::NewGroupsTest, Core)
#include "tests/app/document/new_groups_test.moc"

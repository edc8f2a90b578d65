// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/hidden_objects.h"

#include <QTest>

#include "tests/test_class.h"

namespace document_hidden_objects_test {

using namespace app;

namespace {

QStringList namesOf(const Containers& containers)
{
    QStringList names;
    for (const ContainerId id : containers.inOrder())
        names << containers[id].name;
    return names;
}

} // namespace

class HiddenObjectsTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsHiddenGoes()
    {
        DocumentBuilder builder;
        const auto add = [&](double x, bool hidden) {
            builder.add(Object{Path(clipping::Segment{{x, 0}, {x, 1}}), {}, {}, hidden});
        };
        constexpr auto group = Container::Kind::Group;
        builder.open({.name = "shown"});
        add(0, false);
        add(1, true);
        builder.open({.kind = group, .name = "hidden group", .visible = false});
        add(2, false);
        builder.open({.kind = group, .name = "in it", .visible = false});
        add(3, true);
        builder.close();
        builder.close();
        builder.open({.kind = group, .name = "group of hidden ones"});
        add(4, true);
        builder.close();
        add(5, false);
        builder.close();
        builder.open({.name = "hidden layer", .visible = false});
        add(6, false);
        builder.close();
        builder.open({.name = "empty layer"});
        builder.close();
        const Document document = builder.take({});
        QCOMPARE(hiddenObjects(document), (ObjectRanges{1, 2, 3, 4, 6}));
        const Document shown = withoutHidden(document);
        QCOMPARE(shown.objects().size(), 2u);
        QCOMPARE(shown.objects()[0].singleLine()->a.x, 0.0);
        QCOMPARE(shown.objects()[1].singleLine()->a.x, 5.0);
        QCOMPARE(namesOf(shown.containers()), (QStringList{"shown", "empty layer"}));
        QCOMPARE(shown.containers().objects(), 2u);
        QVERIFY(withoutHidden(shown) == shown);
    }

    void aLayerIsLeftInAnyCase()
    {
        DocumentBuilder builder;
        for (const char* name : {"one", "two"}) {
            builder.open({.name = name, .visible = false});
            builder.add(Object{Path(clipping::Segment{{0, 0}, {1, 1}}), {}});
            builder.close();
        }
        const Document shown = withoutHidden(builder.take({}));
        QVERIFY(shown.objects().empty());
        QCOMPARE(namesOf(shown.containers()), (QStringList{"Drawing"}));
    }

    void manyHiddenLayersTakeNoTime()
    {
        DocumentBuilder builder;
        for (int i = 0; i < 50'000; ++i) {
            builder.open({.visible = i % 2 == 0});
            builder.add(Object{Path(clipping::Segment{{0, 0}, {1, 1}}), {}});
            builder.close();
        }
        const Document shown = withoutHidden(builder.take({}));
        QCOMPARE(shown.objects().size(), 25'000u);
        QCOMPARE(shown.containers().size(), 25'000u);
    }
};

} // namespace document_hidden_objects_test

TEST_CLASS(document_hidden_objects_test::HiddenObjectsTest, None)
#include "tests/app/document/hidden_objects_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// What the drawing has under a name.
#include "app/document/document_builder.h"
#include "app/session/named_things.h"
#include "app/session/units.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace session_named_things_test {

using namespace app;
using Kind = NamedThing::Kind;
using namespace std::chrono_literals;

namespace {

struct Garden : Session {
    explicit Garden(int trees = 3)
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Trees")});
        for (int i = 0; i < trees; ++i)
            builder.add({.path = Path(clipping::Segment{{0, 0}, {1, double(i)}}),
                         .style = {.stroke = Colour{}},
                         .particulars = {.id = QStringLiteral("tree-%1").arg(i)}});
        builder.close();
        builder.open({.name = QStringLiteral("Hidden trees"), .visible = false});
        builder.add({.path = Path(clipping::Segment{{0, 0}, {5, 5}}),
                     .style = {.stroke = Colour{}},
                     .particulars = {.id = QStringLiteral("old tree")}});
        builder.close();
        const RectangleShape box{{{0, 0}, {2, 2}}};
        load(
            {builder.take(Page{}, {},
                          {{{.name = QStringLiteral("Tree house"), .shape = box},
                            {.name = QStringLiteral("Tree top"), .shape = box, .visible = false}}}),
             {}});
    }
    QStringList found(const QString& typed, std::size_t most = 100) const
    {
        QStringList names;
        for (const NamedThing& thing : thingsNamed(*this, typed, most, 1s).list)
            names << thing.name;
        return names;
    }
    NamedThing thing(const QString& typed) const
    {
        return thingsNamed(*this, typed, 100, 1s).list[0];
    }
};

} // namespace

class NamedThingsTest : public QObject {
    Q_OBJECT

private slots:
    void whatHasNoNameIsFoundByItsNumber()
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Fence")});
        for (int i = 0; i < 12; ++i)
            builder.add({.path = Path(clipping::Segment{{0, 0}, {1, double(i)}}),
                         .style = {.stroke = Colour{}}});
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        QVERIFY(thingsNamed(session, QStringLiteral("line"), 100, 1s).list.empty());
        const auto found = thingsNamed(session, QStringLiteral("line 12"), 100, 1s).list;
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].name, QStringLiteral("Line 12"));
        QVERIFY(chooseThing(session, found[0]));
        QCOMPARE(session.selection(), ObjectRanges({11}));
    }
    void digitsAreFoundGroupedOrNot()
    {
        DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Fence")});
        for (int i = 0; i < 1300; ++i)
            builder.add({.path = Path(clipping::Segment{{0, 0}, {1, double(i)}}),
                         .style = {.stroke = Colour{}}});
        builder.close();
        Session session;
        session.load({builder.take({}), {}});
        const QString name = app::objectName(session, 1233);
        QVERIFY(name != QStringLiteral("Line 1234"));
        for (const QString& typed : {QStringLiteral("line 1234"), name}) {
            const auto found = thingsNamed(session, typed, 100, 10s).list;
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].name, name);
        }
    }
    void windowsLayersAndObjectsAreFound()
    {
        const Garden garden;
        QCOMPARE(garden.found("tree"),
                 (QStringList{"Tree house", "Tree top", "Trees", "Hidden trees", "tree-0", "tree-1",
                              "tree-2", "old tree"}));
        QCOMPARE(garden.found("TREE-1"), QStringList("tree-1"));
        QVERIFY(garden.found("bush").isEmpty());
        QCOMPARE(garden.found(" "),
                 (QStringList{"Tree house", "Tree top", "Trees", "Hidden trees"}));
    }
    void itIsSaidWhatTheyAre()
    {
        const Garden garden;
        QCOMPARE(garden.thing("trees").what, QStringLiteral("layer, 3 objects"));
        QCOMPARE(garden.thing("hidden trees").what, QStringLiteral("layer, 1 object"));
        QCOMPARE(garden.thing("tree-2").what, QStringLiteral("object in Trees"));
        QCOMPARE(garden.thing("tree top").remark, QStringLiteral("hidden"));
        QCOMPARE(garden.thing("old tree").remark, QStringLiteral("hidden"));
        QCOMPARE(garden.thing("tree house").remark, QString());
    }
    void whatIsFoundIsChosen()
    {
        Garden garden;
        QVERIFY(chooseThing(garden, garden.thing("tree-1")));
        QCOMPARE(garden.selection(), ObjectRanges(ObjectRange{1, 2}));
        QVERIFY(chooseThing(garden, garden.thing("trees")));
        QCOMPARE(garden.selection(), ObjectRanges(ObjectRange{0, 3}));
        QVERIFY(!garden.windowChosen());
        QVERIFY(chooseThing(garden, garden.thing("tree house")));
        QVERIFY(garden.windowChosen());
    }
    void whatIsHiddenOrGoneIsRefused()
    {
        Garden garden;
        QSignalSpy refused(&garden, &Session::refused);
        const NamedThing last = garden.thing("tree-2"), house = garden.thing("tree house");
        for (const char* name : {"old tree", "hidden trees", "tree top"})
            QVERIFY(!chooseThing(garden, garden.thing(name)));
        QCOMPARE(refused.size(), 3);
        garden.load({}, {}); // while the list is open
        QVERIFY(!chooseThing(garden, last) && !chooseThing(garden, house));
        QVERIFY(garden.selection().empty());
    }
    void aListHasAnEnd()
    {
        const Garden garden(20'000);
        const auto some = thingsNamed(garden, "tree", 50, 1s);
        QCOMPARE(some.list.size(), 50u);
        QVERIFY(!some.isAll);
        QVERIFY(!thingsNamed(garden, "tree-19999", 50, -1us).isAll); // no time
        QVERIFY(thingsNamed(garden, "tree-19999", 50, 10s).isAll);
    }
};

} // namespace session_named_things_test

TEST_CLASS(session_named_things_test::NamedThingsTest, None)
#include "tests/app/session/named_things_test.moc"

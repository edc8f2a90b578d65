// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of the tree of layers, groups and objects that are found by what is typed.
#include "app/document/document_builder.h"
#include "app/session/tree_search.h"
#include "app/session/units.h"

#include <QElapsedTimer>
#include <QTest>

#include "tests/test_class.h"
#include "tests/verify.h"

namespace session_tree_search_test {

using namespace app;
using namespace std::chrono_literals;

namespace {

struct House : Session {
    explicit House(int walls = 3)
    {
        DocumentBuilder builder;
        builder.open({.name = "Walls"});
        for (int i = 0; i < walls; ++i)
            add(builder, {});
        builder.close();
        builder.open({.name = "Furniture"});
        builder.open({.kind = Container::Kind::Group, .name = "Kitchen"});
        add(builder, "sink");
        add(builder, {});
        builder.close();
        builder.open({.name = "Garden"});
        add(builder, {});
        builder.close();
        builder.close();
        load({builder.take({}), {}});
    }
    static void add(DocumentBuilder& builder, const QString& id)
    {
        builder.add({.path = Path(clipping::Segment{{0, 0}, {1, 1}}),
                     .style = {.stroke = Colour{}},
                     .particulars = {.id = id}});
    }
    QStringList textOf(const std::vector<TreeRow>& rows) const
    {
        QStringList all;
        for (const TreeRow& row : rows)
            all << QString(row.depth - 1, u'.')
                       + (row.kind == TreeRow::Kind::Object
                              ? app::objectName(*this, row.number)
                              : now().containers()[row.container].name);
        return all;
    }
    QStringList found(const QString& typed, std::size_t most = 100) const
    {
        TreeSearch search(*this, typed);
        while (!search.advance(1s)) {
        }
        return textOf(search.rows(most));
    }
};

} // namespace

class TreeSearchTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsAroundIsKept()
    {
        const House house;
        QCOMPARE(house.found("SINK"), QStringList({"Furniture", ".Kitchen", "..sink"}));
        QCOMPARE(house.found("line 5"), QStringList({"Furniture", ".Kitchen", "..Line 5"}));
        QCOMPARE(house.found("garden"), QStringList({"Furniture", ".Garden", "..Line 6"}));
        QCOMPARE(house.found("kitchen"),
                 QStringList({"Furniture", ".Kitchen", "..Line 5", "..sink"}));
    }
    void wordsAreFoundInWhatIsAround()
    {
        const House house;
        QCOMPARE(house.found("walls line"),
                 QStringList({"Walls", ".Line 3", ".Line 2", ".Line 1"}));
        QCOMPARE(house.found("line furniture 6"),
                 QStringList({"Furniture", ".Garden", "..Line 6"}));
        QCOMPARE(house.found("walls sink"), QStringList());
        QCOMPARE(house.found("chimney"), QStringList());
    }
    void theTopmostAreShown()
    {
        const House house;
        QCOMPARE(house.found("line", 2),
                 QStringList({"Furniture", ".Garden", "..Line 6", ".Kitchen", "..Line 5"}));
        TreeSearch search(house, "line");
        QVERIFY(search.advance(1s));
        QCOMPARE(search.found(), std::size_t(5));
    }
    void digitsAreFoundGroupedOrNot()
    {
        const House house(1500);
        const QString line = "." + app::objectName(house, 1233);
        QCOMPARE(house.found("line 1234"), QStringList({"Walls", line}));
        QCOMPARE(house.found(line.mid(1)), QStringList({"Walls", line}));
    }
    // Each way of finding one goes through all objects: the result is the same as that of the
    // names.
    void manyObjectsAreFoundInSlices()
    {
        const House house(100'000);
        for (const char* const typed : {"7", "line", "walls", "l 99"}) {
            TreeSearch search(house, typed);
            QElapsedTimer clock;
            qint64 longest = 0;
            int slices = 0;
            for (bool done = false; !done; ++slices) {
                clock.start();
                done = search.advance(6ms);
                longest = std::max(longest, clock.nsecsElapsed());
            }
            qInfo("“%s”: %zu found in %d slices, the longest %.1f ms", typed, search.found(),
                  slices, double(longest) / 1e6);
            std::size_t expected = 0;
            for (std::size_t i = 0; i < house.now().objects().size(); ++i) {
                const ContainerId layer = house.now().containers().layerOf(i);
                const QString name = app::objectName(house, i) + u' ' + QString::number(i + 1)
                                     + u' ' + house.now().containers()[layer].name;
                bool fits = true;
                for (const QString& word : QString(typed).split(u' '))
                    fits = fits && name.contains(word, Qt::CaseInsensitive);
                expected += fits;
            }
            VERIFY_OR_SAY(search.found() - expected <= 1, typed); // the layer itself
            QVERIFY(search.rows(500).size() <= 500 + 4);
        }
    }
};

} // namespace session_tree_search_test

TEST_CLASS(session_tree_search_test::TreeSearchTest, Core)
#include "tests/app/session/tree_search_test.moc"

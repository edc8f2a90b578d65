// SPDX-License-Identifier: GPL-3.0-or-later
// What a list of rows keeps when objects and layers come and go.
#include "app/document/containers_builder.h"
#include "app/document/kept_rows.h"

#include <QTest>

#include <numeric>

#include "tests/clipping/random.h"
#include "tests/test_class.h"

namespace document_kept_rows_test {

using namespace app;
using Kind = TreeRow::Kind;

namespace {

Containers oneLayer(std::size_t objects)
{
    ContainersBuilder builder;
    builder.open({.name = "all"});
    builder.addObjects(objects);
    builder.close();
    return builder.take();
}

std::vector<Splice> randomSplices(Random& random, std::size_t objects)
{
    std::vector<Splice> splices;
    for (std::size_t at = random.whole(0, 4); at <= objects; at += random.whole(0, 6)) {
        const std::size_t removed = random.whole(0, std::min<std::size_t>(3, objects - at));
        splices.push_back(
            {std::uint32_t(at), std::uint32_t(removed), std::uint32_t(random.whole(0, 3))});
        at += removed + 1;
    }
    return splices;
}

/// The old number of each object after the splices; −1: it is another one.
std::vector<int> oldNumbers(std::size_t objects, const std::vector<Splice>& splices)
{
    std::vector<int> all(objects);
    std::iota(all.begin(), all.end(), 0);
    for (auto splice = splices.rbegin(); splice != splices.rend(); ++splice) {
        if (splice->removed == splice->added)
            continue;
        const auto at = all.begin() + splice->first;
        all.insert(all.erase(at, at + splice->removed), splice->added, -1);
    }
    return all;
}

} // namespace

class KeptRowsTest : public QObject {
    Q_OBJECT

private slots:
    void objectsKeepTheirRows()
    {
        Random random(7);
        std::size_t some = 0;
        for (int round = 0; round < 300; ++round) {
            const std::size_t before = random.whole(1, 30);
            const std::vector<Splice> splices = randomSplices(random, before);
            const std::vector<int> old = oldNumbers(before, splices);
            const Containers tree = oneLayer(old.size());
            const ContainerId layer = tree.childrenOf(0)[0];
            std::vector<TreeRow> rows;
            for (std::size_t i = before; i-- > 0;)
                rows.push_back({Kind::Object, layer, i, 2});
            const KeptRows kept = keptRows(rows, splices, tree);
            std::vector<TreeRow> expected;
            std::vector<std::size_t> lost;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const auto now = std::ranges::find(old, int(rows[i].number));
                if (now == old.end())
                    lost.push_back(i);
                else
                    expected.push_back({Kind::Object, layer, std::size_t(now - old.begin()), 2});
            }
            QVERIFY(kept.rows == expected);
            QVERIFY(kept.lost == lost);
            some += lost.size();
        }
        QVERIFY(some > 100);
    }
    void whatIsGoneLosesItsRow()
    {
        const Containers tree = oneLayer(2);
        const ContainerId layer = tree.childrenOf(0)[0];
        const std::vector<TreeRow> rows{{Kind::Layer, layer + 1},
                                        {Kind::Group, layer + 2, 0, 2},
                                        {Kind::Object, layer + 2, 1, 3},
                                        {Kind::Layer, layer},
                                        {Kind::Object, layer, 5, 2}};
        const KeptRows kept = keptRows(rows, {}, tree);
        QVERIFY(kept.lost == std::vector<std::size_t>({0, 1, 4}));
        QVERIFY(kept.rows
                == std::vector<TreeRow>({{Kind::Object, layer, 1, 3}, {Kind::Layer, layer}}));
    }
};

} // namespace document_kept_rows_test

TEST_CLASS(document_kept_rows_test::KeptRowsTest, None)
#include "tests/app/document/kept_rows_test.moc"

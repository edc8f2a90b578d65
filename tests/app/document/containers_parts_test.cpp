// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers.h"

#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/test_class.h"

namespace document_containers_parts_test {

using namespace app;

class ContainersPartsTest : public QObject {
    Q_OBJECT

private slots:
    void restoreTheTree()
    {
        for (unsigned seed = 0; seed < 40; ++seed) {
            RandomDocuments random(seed);
            Document document = random.document(60);
            for (int i = 0; i < 20; ++i)
                document.apply(random.edit(document));
            const Containers& tree = document.containers();
            const auto again = Containers::of(tree.parts());
            QVERIFY(again && *again == tree);
            QCOMPARE(again->nextId(), tree.nextId());
            for (const ContainerId id : tree.inOrder()) {
                QCOMPARE(again->parentOf(id), tree.parentOf(id));
                QVERIFY(again->rangeOf(id) == tree.rangeOf(id));
                QVERIFY(again->childrenOf(id) == tree.childrenOf(id));
            }
            const auto splice = [](const Containers& to) {
                return to.spliced(to.objects(), 0, 3, to.childrenOf(0).back());
            };
            QVERIFY(splice(*again) == splice(tree));
        }
    }
    void thatAreNoTreeAreRefused()
    {
        const Containers::Parts good = RandomDocuments(3).document(60).containers().parts();
        QVERIFY(Containers::of(good));
        const auto refused = [&](const auto& spoil) {
            Containers::Parts parts = good;
            spoil(parts);
            return !Containers::of(parts);
        };
        using Parts = Containers::Parts;
        QVERIFY(refused([](Parts& p) { p = {}; }));
        QVERIFY(refused([](Parts& p) { p.marks.pop_back(); }));
        QVERIFY(refused([](Parts& p) { p.containers.pop_back(); }));
        QVERIFY(refused([](Parts& p) { p.nextId = p.containers.back().id; }));
        QVERIFY(refused([](Parts& p) { p.nextId = ~0U; }));
        QVERIFY(refused([](Parts& p) { p.marks.front().objects = 1; }));
        QVERIFY(refused([](Parts& p) { p.marks.back().objects = 1; }));
        QVERIFY(refused([](Parts& p) { p.marks[1].objects = ~0U, p.marks[2].objects = ~0U; }));
        QVERIFY(refused([](Parts& p) { p.containers.front().kind = Container::Kind::Group; }));
        for (std::size_t i = 0; i < good.marks.size(); ++i) {
            QVERIFY(refused([i](Parts& p) { p.marks[i].closes ^= 1; }));
            QVERIFY(refused([i](Parts& p) { p.marks[i].id = 1'000'000; }));
            if (i > 0)
                QVERIFY(refused([i](Parts& p) { p.marks[i].id = p.marks[i].id == 1 ? 2 : 1; })
                        || good.marks[i].id < 3);
        }
    }
};

} // namespace document_containers_parts_test

TEST_CLASS(document_containers_parts_test::ContainersPartsTest, None)
#include "tests/app/document/containers_parts_test.moc"

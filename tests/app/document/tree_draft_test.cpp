// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copies.h"
#include "app/document/hidden_objects.h"
#include "app/document/moved_runs.h"
#include "app/document/regrouping.h"
#include "app/document/stacking.h"

#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/test_class.h"

namespace document_tree_draft_test {

using namespace app;

class TreeDraftTest : public QObject {
    Q_OBJECT

    static ObjectRanges some(RandomDocuments& random, const Document& document)
    {
        ObjectRanges chosen;
        for (int i = 0; i < 20; ++i)
            chosen.insert(random.below(document.objects().size()));
        return common(chosen, editableObjects(document));
    }
    static std::vector<Path> paths(const Document& document, const ObjectRanges& objects)
    {
        std::vector<Path> paths;
        for (const std::size_t i : objects)
            paths.push_back(document.objects()[i].path());
        return paths;
    }

private slots:
    void aDraftWithoutChangesChangesNothing()
    {
        RandomDocuments random(3);
        for (int i = 0; i < 50; ++i) {
            const Document document = random.document(100);
            const auto result = TreeDraft(document, some(random, document)).rearranged();
            QVERIFY(result && !result->changes());
        }
    }
    void theChosenObjectsAreFollowedAndEditsAreUndone()
    {
        RandomDocuments random(4);
        const auto overlaps = [](const ObjectRange& range) { return range.first % 4 == 0; };
        for (int i = 0; i < 200; ++i) {
            const Document before = random.document(100);
            const ObjectRanges chosen = some(random, before);
            const auto all = before.containers().inOrder();
            const ContainerId entered = all[random.below(all.size())];
            auto result = i % 3 == 0   ? grouped(before, chosen, entered)
                          : i % 3 == 1 ? ungrouped(before, chosen, entered)
                                       : stacked(before, chosen, entered, Stacking(random.below(4)),
                                                 overlaps);
            QVERIFY(result);
            Document after = before;
            const Edit back = after.apply(result->edit);
            QCOMPARE(result->chosen.size(), chosen.size());
            auto old = paths(before, chosen), now = paths(after, result->chosen);
            for (const Path& path : old) { // in another order, perhaps
                const auto found = std::ranges::find(now, path);
                QVERIFY(found != now.end());
                now.erase(found);
            }
            after.apply(back);
            QVERIFY(after == before);
        }
    }
    void fewObjectsMove()
    {
        RandomDocuments random(5);
        DocumentBuilder builder;
        builder.open({});
        for (int i = 0; i < 1000; ++i)
            builder.add(random.object());
        builder.close();
        const Document document = builder.take({});
        const auto front = stacked(document, {0}, 0, Stacking::ToFront, {});
        QCOMPARE(front->edit.objects.size(), std::size_t(1));
        QCOMPARE(front->chosen, (ObjectRanges{999}));
        ObjectRanges most(ObjectRange{0, 900});
        const auto back = stacked(document, most, 0, Stacking::ToFront, {});
        QCOMPARE(back->edit.objects.size(), std::size_t(100)); // the others go down
    }
    void tooDeepNestingIsRefused()
    {
        Containers tree;
        ContainerId at = tree.childrenOf(0).front();
        tree = tree.spliced(0, 0, 1, at);
        for (int depth = 1; depth < Containers::deepest; ++depth) {
            const ContainerId id = tree.nextId();
            tree = *tree.inserted({.kind = Container::Kind::Group}, at, 0, {0, 1});
            at = id;
        }
        Objects objects;
        objects.append(RandomDocuments(1).object());
        const Document document(DocumentParts{{}, {}, objects, tree});
        QVERIFY(!grouped(document, {0}, at));
        QVERIFY(ungrouped(document, {0}, 0)->changes());
    }
    void aDrawingIsInsertedWithItsGroups()
    {
        RandomDocuments random(6);
        for (int i = 0; i < 30; ++i) {
            const Document document = random.document(40), other = random.document(30);
            const ContainerId into = document.containers().childrenOf(0).front();
            const auto result = withDrawing(document, other, into);
            QVERIFY(result);
            Document after = document;
            after.apply(result->edit);
            QCOMPARE(result->added.size(), other.objects().size());
            const ObjectRanges all(ObjectRange{0, other.objects().size()});
            QVERIFY(paths(after, result->added) == paths(other, all));
            QCOMPARE(after.containers().rangeOf(into).size(),
                     document.containers().rangeOf(into).size() + other.objects().size());
        }
    }
    void rangesWithin()
    {
        const ObjectRanges objects{1, 2, 3, 7, 9};
        QCOMPARE(within(objects, {2, 8}), (ObjectRanges{2, 3, 7}));
        QVERIFY(within(objects, {4, 7}).empty());
        QVERIFY(meets(objects, {3, 4}) && !meets(objects, {4, 7}) && !meets(objects, {10, 12}));
    }
};

} // namespace document_tree_draft_test

TEST_CLASS(document_tree_draft_test::TreeDraftTest, None)
#include "tests/app/document/tree_draft_test.moc"

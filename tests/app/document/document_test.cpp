// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <QTest>

#include "tests/app/document/random_documents.h"
#include "tests/test_class.h"

namespace document_document_test {

using namespace app;

namespace {

std::vector<Object> objectsOf(const Objects& objects)
{
    std::vector<Object> all;
    objects.forEach(0, objects.size(),
                    [&](std::size_t, const ObjectView& object) { all.push_back(object.copy()); });
    return all;
}

// The objects after an edit, one by one.
std::vector<Object> edited(const std::vector<Object>& before, const Edit& edit)
{
    std::vector<Object> after;
    std::size_t at = 0, added = 0;
    for (const Splice& s : edit.splices) {
        after.insert(after.end(), before.begin() + std::ptrdiff_t(at),
                     before.begin() + std::ptrdiff_t(s.first));
        for (const std::size_t end = added + s.added; added < end; ++added)
            after.push_back(edit.objects[added].copy());
        at = std::size_t(s.first) + s.removed;
    }
    after.insert(after.end(), before.begin() + std::ptrdiff_t(at), before.end());
    return after;
}

Object line(double x) { return {Path(clipping::Segment{{x, 0}, {x, 1}}), {.width = x + 1}}; }

// Three layers, of which the second is hidden and the third locked, of two lines each.
Document threeLayers()
{
    DocumentBuilder builder;
    for (int i = 0; i < 3; ++i) {
        builder.open({.name = QString::number(i), .visible = i != 1, .locked = i == 2});
        builder.add(line(2 * i));
        builder.add(line(2 * i + 1));
        builder.close();
    }
    return builder.take({});
}

std::size_t blocksOnlyIn(const Objects& a, const Objects& b)
{
    std::size_t count = 0;
    for (const auto& block : a.blocks())
        count += std::ranges::none_of(b.blocks(),
                                      [&](const auto& other) { return sameAddress(block, other); });
    return count;
}

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyOne()
    {
        const Document document;
        QCOMPARE(document.objects().size(), std::size_t(0));
        QCOMPARE(document.containers().size(), std::size_t(1));
        QVERIFY(document.windows() == ClipWindows{});
        QVERIFY(document.page() == Page{});
        QVERIFY(document == Document());
        QVERIFY(document == DocumentBuilder().take({}));
    }

    void hiddenAndLocked()
    {
        Document document = threeLayers();
        Object hidden = line(9);
        hidden.hidden = true;
        Edit edit{.splices = {{1, 1, 1}}};
        edit.objects.append(hidden);
        document.apply(edit);
        QString seen;
        for (std::size_t i = 0; i < 6; ++i)
            seen += document.editable(i) ? 'e' : document.shown(i) ? 's' : '-';
        QCOMPARE(seen, QString("e---ss"));
    }

    void splicesKnowTheirInverse()
    {
        const std::vector<Splice> splices{{0, 0, 2}, {3, 4, 1}, {7, 1, 0}, {8, 2, 2}};
        const std::vector<Splice> back{{0, 2, 0}, {5, 1, 4}, {6, 0, 1}, {6, 2, 2}};
        QVERIFY(inverse(splices) == back);
        QVERIFY(inverse(back) == splices);
        QVERIFY(inverse({}).empty());
    }

    void addedObjectsAreNumberedAfterwards()
    {
        const std::vector<Splice> splices{{0, 0, 2}, {3, 4, 0}, {7, 1, 1}, {8, 0, 2}};
        QCOMPARE(addedBy(splices), (ObjectRanges{0, 1, 5, 6, 7}));
        QVERIFY(addedBy({}).empty());
    }
    void stylesOfItsOwnStayApart()
    {
        const Document document = threeLayers();
        const std::size_t styles = document.styles().size();
        QVERIFY(styles > 0);
        Document apart = withOwnStyles(document);
        QVERIFY(apart == document);
        QCOMPARE(apart.styles().size(), styles);
        QCOMPARE(blocksOnlyIn(apart.objects(), document.objects()), std::size_t(0));
        Objects more = apart.objects().slice(0, 0);
        more.append(
            Object{.path = Path(clipping::Segment{{0, 0}, {1, 1}}), .style = {.width = 77}});
        apart.apply(adding(apart, more, apart.containers().childrenOf(0).front()));
        QCOMPARE(apart.styles().size(), styles + 1);
        QCOMPARE(document.styles().size(), styles);
        Document taken = document; // and back: the style gets a number there
        taken.apply(adding(taken, apart.objects(), taken.containers().childrenOf(0).back()));
        QCOMPARE(document.styles().size(), styles + 1);
        const Document none = withOwnStyles(Document());
        QVERIFY(none.objects().empty());
    }
    void whatIsAddedGoesWhereSomethingWent()
    {
        const Containers before = threeLayers().containers();
        const auto ids = before.childrenOf(0);
        const std::vector<Splice> splices{{0, 1, 3}, {2, 2, 0}, {5, 1, 2}, {6, 0, 1}};
        const Containers after = before.spliced(splices, ids[2]);
        QVERIFY((after.rangeOf(ids[0]) == ObjectRange{0, 4}));
        QVERIFY(after.rangeOf(ids[1]).empty());
        QVERIFY((after.rangeOf(ids[2]) == ObjectRange{4, 8}));
        // As many as went, but from two layers: all of them into the first one's.
        const Containers across = before.spliced(std::array{Splice{1, 2, 2}});
        QVERIFY((across.rangeOf(ids[0]) == ObjectRange{0, 3}));
        QVERIFY((across.rangeOf(ids[1]) == ObjectRange{3, 4}));
        QVERIFY(before.spliced(std::array{Splice{2, 2, 2}}) == before);
    }

    // One edit after another is done, undone and done again; then all are undone.
    void editsAreUndone()
    {
        RandomDocuments random(3);
        for (int round = 0; round < 40; ++round) {
            Document document = random.document(random.below(80));
            std::vector<Document> states{document};
            std::vector<Edit> undo;
            for (int i = 0; i < 25; ++i) {
                const Edit edit = random.edit(document);
                const auto expected = edited(objectsOf(document.objects()), edit);
                const Edit back = document.apply(edit);
                const Document after = document;
                QVERIFY(objectsOf(document.objects()) == expected);
                QVERIFY(!edit.containers || document.containers() == *edit.containers);
                QVERIFY(!edit.windows || document.windows() == *edit.windows);
                QVERIFY(!edit.page || document.page() == *edit.page);
                const Edit again = document.apply(back);
                QVERIFY(document == states.back());
                undo.push_back(document.apply(again));
                QVERIFY(document == after);
                states.push_back(after);
            }
            for (; !undo.empty(); undo.pop_back()) {
                QVERIFY(document == states.back());
                states.pop_back();
                document.apply(undo.back());
            }
            QVERIFY(document == states.back());
        }
    }

    void idsOfUndoneContainersAreNotGivenAgain()
    {
        Document document = threeLayers();
        const auto insert = [&] {
            const Containers& tree = document.containers();
            return document.apply({.containers = tree.inserted({}, 0, 0, {0, 0})});
        };
        const ContainerId first = document.containers().nextId();
        const Edit back = insert();
        document.apply(back);
        QVERIFY(document == threeLayers());
        insert();
        QVERIFY(!document.containers().contains(first));
        QVERIFY(document.containers().contains(first + 1));
    }

    void copiesStayAsTheyWere()
    {
        RandomDocuments random(4);
        Document document = random.document(300);
        const Document snapshot = document;
        QVERIFY(sameAddress(snapshot, document));
        const auto objects = objectsOf(document.objects());
        const Containers containers = document.containers();
        const ClipWindows windows = document.windows();
        for (int i = 0; i < 100; ++i)
            document.apply(random.edit(document));
        QVERIFY(!sameAddress(snapshot, document) && !(snapshot == document));
        QVERIFY(objectsOf(snapshot.objects()) == objects);
        QVERIFY(snapshot.containers() == containers);
        QVERIFY(snapshot.windows() == windows);
    }

    void anEditCopiesTheBlocksThatItTouches()
    {
        DocumentBuilder builder;
        builder.open({});
        const StyleEntry style = builder.style({});
        for (int i = 0; i < 100'000; ++i)
            builder.addLine({{double(i), 0}, {0, double(i)}}, style);
        builder.close();
        Document document = builder.take({});
        const std::size_t blocks = document.objects().blocks().size();
        QVERIFY(blocks > 20);

        const Document before = document;
        Edit edit{.splices = {{70'000, 1, 1}}};
        edit.objects.append(line(1));
        const Edit back = document.apply(edit);
        QVERIFY(blocksOnlyIn(document.objects(), before.objects()) <= 2);
        QVERIFY(back.bytesNotIn(edit) < 1000);

        document.apply({.windows = ClipWindows{{{}}}, .page = Page{{1, 1}}});
        QCOMPARE(document.objects().blocks().size(), blocks);
        QVERIFY(blocksOnlyIn(document.objects(), before.objects()) <= 2);
    }
};

} // namespace document_document_test

TEST_CLASS(document_document_test::DocumentTest, None)
#include "tests/app/document/document_test.moc"

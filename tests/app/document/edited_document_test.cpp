// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/edited_document.h"

#include <QTest>

#include <limits>

#include "tests/app/document/random_documents.h"
#include "tests/replaced_heap.h"
#include "tests/test_class.h"

namespace {

std::size_t allocations = 0;
std::size_t mostAllocations = std::numeric_limits<std::size_t>::max();

} // namespace

// Counts what is taken from the heap, which can be short of memory.
bool heapRefuses(std::size_t)
{
    if (allocations >= mostAllocations)
        return true;
    ++allocations;
    return false;
}

using namespace app;

namespace {

/// The changes that a document has emitted.
struct Listener : QObject {
    explicit Listener(const EditedDocument& document)
    {
        splices.reserve(100); // so that it needs no memory later
        connect(&document, &EditedDocument::changed, this, [&](const DocumentChange& change) {
            last = change;
            splices.assign(change.splices.begin(), change.splices.end());
            now = document.now();
            ++count;
        });
    }
    QString kinds() const
    {
        return QString(last.everything ? "e" : "") + (last.again ? "a" : "")
               + (last.objects ? "o" : "") + (last.containers ? "c" : "")
               + (last.windows ? "w" : "") + (last.page ? "p" : "");
    }

    int count = 0;
    DocumentChange last;
    std::vector<Splice> splices;
    Document now;
};

} // namespace

class EditedDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void anEditIsEmittedOnce()
    {
        RandomDocuments random(7);
        EditedDocument document(random.document(100));
        const Listener listener(document);
        Edit edit{.splices = {{3, 1, 2}, {10, 0, 0}, {20, 2, 1}}};
        for (int i = 0; i < 3; ++i)
            edit.objects.append(random.object());
        const auto splices = edit.splices;
        edit = document.apply(edit);
        QCOMPARE(listener.count, 1);
        QCOMPARE(listener.kinds(), QString("o"));
        QVERIFY(listener.splices == splices);
        QVERIFY(sameAddress(listener.now, document.now()));

        document.apply(edit);
        QVERIFY(listener.splices == inverse(splices));
        document.apply(
            {.containers = document.now().containers(), .windows = ClipWindows{}, .page = Page{}});
        QCOMPARE(listener.kinds(), QString("cwp"));
        QVERIFY(listener.splices.empty());
        QCOMPARE(listener.count, 3);
    }

    void anotherDocumentIsEmitted()
    {
        RandomDocuments random(8);
        const Document other = random.document(5);
        EditedDocument document(random.document(5));
        const Listener listener(document);
        document.load(other);
        QCOMPARE(listener.count, 1);
        QCOMPARE(listener.kinds(), QString("eocwp"));
        QVERIFY(sameAddress(document.now(), other));
        QVERIFY(sameAddress(listener.now, other));
    }

    // What was there is freed, if no snapshot has it, before the change is emitted.
    void whatWasIsFreedFirst()
    {
        EditedDocument document(RandomDocuments(9).document(5));
        const Shared<ObjectBlock> block = document.now().objects().blocks().front();
        bool freed = false;
        connect(&document, &EditedDocument::changed, this, [&] { freed = !block.isShared(); });
        document.apply({.page = Page{{1, 1}}});
        QVERIFY(!freed);
        document.load({});
        QVERIFY(freed);
    }

    void aSnapshotIsOneMoreOwner()
    {
        RandomDocuments random(10);
        for (const std::size_t objects : {0U, 10U, 5000U}) {
            const EditedDocument document(random.document(objects));
            const std::size_t before = allocations;
            const Document snapshot = document.snapshot();
            QCOMPARE(allocations, before);
            QVERIFY(sameAddress(snapshot, document.now()));
        }
    }

    // Whatever cannot be allocated, an edit is done or not.
    void withoutMemoryNothingChanges()
    {
        RandomDocuments random(11);
        for (int round = 0; round < 20; ++round) {
            EditedDocument document(random.document(100));
            const Edit edit = random.edit(document.now());
            Document expected = document.now();
            expected.apply(edit);
            const Listener listener(document);
            const Document before = document.snapshot();
            bool done = false;
            for (std::size_t enough = 0; !done; ++enough) {
                mostAllocations = allocations + enough;
                try {
                    document.apply(edit);
                    done = true;
                } catch (const std::bad_alloc&) {
                }
                mostAllocations = std::numeric_limits<std::size_t>::max();
                QCOMPARE(listener.count, int(done));
                QVERIFY(done || sameAddress(document.now(), before));
            }
            QVERIFY(document.now() == expected);
        }
    }
    // What listeners need memory for belongs to the edit.
    void anEditThatAListenerHasNoMemoryForIsTakenBack()
    {
        RandomDocuments random(12);
        EditedDocument document(random.document(50));
        const Listener first(document);
        int failures = 1;
        connect(&document, &EditedDocument::changed, this, [&] {
            if (failures > 0 && failures-- > 0)
                throw std::bad_alloc();
        });
        const Listener last(document);
        const Document before = document.now();
        const std::uint64_t revision = document.revision();
        Edit edit{.splices = {{3, 2, 0}}};
        edit.containers = before.containers().spliced(edit.splices);
        QVERIFY_EXCEPTION_THROWN(document.apply(edit), std::bad_alloc);
        QVERIFY(sameAddress(document.now(), before));
        QCOMPARE(document.revision(), revision);
        for (const Listener* each : {&first, &last}) {
            QCOMPARE(each->kinds(), "aocwp");
            QVERIFY(each->splices.empty() && sameAddress(each->now, before));
        }
        QCOMPARE(last.count, 1);

        failures = 2; // also while it is said that the edit was taken back
        QVERIFY_EXCEPTION_THROWN(document.apply(edit), std::bad_alloc);
        QVERIFY(sameAddress(document.now(), before));
        QCOMPARE(last.count, 1);
        document.apply({.page = Page{{1, 1}}});
        QCOMPARE(last.count, 3); // said before
        QCOMPARE(last.kinds(), "p");
        QCOMPARE(document.revision(), revision + 1);
    }
    void aDocumentThatAListenerHasNoMemoryForIsNotLoaded()
    {
        EditedDocument document(RandomDocuments(13).document(50));
        int failures = 1;
        connect(&document, &EditedDocument::changed, this, [&] {
            if (failures-- > 0)
                throw std::bad_alloc();
        });
        const Listener listener(document);
        QVERIFY_EXCEPTION_THROWN(document.load(RandomDocuments(14).document(50)), std::bad_alloc);
        QVERIFY(document.now() == Document());
        QCOMPARE(listener.kinds(), "eocwp");
        QVERIFY(sameAddress(listener.now, document.now()));
    }
};

TEST_CLASS(EditedDocumentTest, None)
#include "tests/app/document/edited_document_test.moc"

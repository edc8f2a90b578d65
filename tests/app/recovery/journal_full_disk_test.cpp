// SPDX-License-Identifier: GPL-3.0-or-later
// A journal on a disk that becomes full at any byte.
#include "app/recovery/journal.h"

#include <QSignalSpy>
#include <QTest>

#include <thread>

#include "tests/app/commands/random_commands.h"
#include "tests/app/formats/failing_disk.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/test_class.h"

namespace recovery_journal_full_disk_test {

using namespace app;

namespace {

constexpr int patience = 60'000; // milliseconds
constexpr std::chrono::milliseconds retryAfter{50};

/// One of some small steps. Step 5 adds so many lines that they are written without a copy.
void act(RecordedDrawing& drawing, int step)
{
    EditedDocument& document = drawing.document;
    Objects line = document.now().objects().slice(0, 0);
    for (int i = 0; i < (step == 5 ? 200 : 1); ++i)
        line.append(Object{Path({{double(i), 0}, {1, double(step)}}), {}});
    if (step == 4)
        drawing.history.undo();
    else if (step == 2)
        drawing.history.push(new MoveObjects(document, {0}, {1, 2}));
    else
        drawing.history.push(
            new AddObjects(document, line, document.now().containers().childrenOf(0)[0], "Add"));
}

} // namespace

class JournalFullDiskTest : public QObject {
    Q_OBJECT

    // In memory if possible: a base is synced in each of a thousand rounds.
    QTemporaryDir home_{QDir(QDir("/dev/shm").exists() ? "/dev/shm" : QDir::tempPath())
                            .filePath("clearcut-XXXXXX")};

private slots:
    void drawingGoesOnAndTheStepsBeforeAreKept()
    {
        std::size_t size = 0;
        // At each byte of the small steps, and at some of the large one.
        for (std::size_t room = 0; size == 0 || room <= size;
             room += room > 1000 && room + 500 < size ? 97 : 1) {
            RecordedDrawing drawing(Document(), home_.filePath("a"));
            drawing.journal.wait();
            const QString folder = drawing.journal.folder();
            QSignalSpy changed(&drawing.journal, &Journal::completeChanged);
            std::vector<RecordedState> states;
            states.push_back(stateOf(drawing.document.now(), drawing.history));
            const auto before = QFileInfo(logFile(folder, 1)).size();
            const disk::Failing disk(disk::Step::Write, size == 0 ? 1'000'000 : room);
            std::size_t kept = 0;
            for (int i = 0; i < 6; ++i) {
                act(drawing, i);
                states.push_back(stateOf(drawing.document.now(), drawing.history));
                if (drawing.journal.complete())
                    kept = states.size() - 1;
            }
            disk::state() = {};
            if (size == 0)
                size = std::size_t(QFileInfo(logFile(folder, 1)).size() - before);
            const QByteArray what = QByteArray::number(qulonglong(room));
            const bool full = !drawing.journal.complete();
            const QString why = drawing.journal.whyIncomplete();
            QCOMPARE(changed.count() > 0, full);
            QCOMPARE(!why.isEmpty(), full);
            if (full)
                QVERIFY2(why.contains("No space left on device. Save"), qPrintable(why));
            const auto found = replayed(folder);
            QVERIFY2(found, what);
            QVERIFY2(stateOf(*found) == states[kept], what);
            drawing.journal.discard();
        }
        QVERIFY(size > 500);
    }
    // The bytes were written, but the disk did not take them.
    void aDiskThatFailsToSyncIsSaidAndTheNextBaseMendsIt()
    {
        Journal::Limits limits;
        limits.retry = retryAfter;
        RecordedDrawing drawing(Document(), home_.filePath("c"), limits);
        drawing.journal.wait();
        QSignalSpy changed(&drawing.journal, &Journal::completeChanged);
        {
            const disk::Failing disk(disk::Step::Sync);
            act(drawing, 0);
            QVERIFY(changed.wait(patience));
            const QString why = drawing.journal.whyIncomplete();
            QVERIFY2(why.contains("Input/output error. Save the drawing."), qPrintable(why));
            QVERIFY(!drawing.journal.complete());
            std::this_thread::sleep_for(2 * retryAfter);
            act(drawing, 1); // a new base fails as well
            drawing.journal.wait();
            QVERIFY(!drawing.journal.complete());
            QVERIFY(!drawing.journal.whyIncomplete().isEmpty());
        }
        std::this_thread::sleep_for(2 * retryAfter);
        act(drawing, 3);
        drawing.journal.wait();
        QVERIFY(drawing.journal.complete());
        QVERIFY(drawing.journal.whyIncomplete().isEmpty());
        const auto found = replayed(drawing.journal.folder());
        QVERIFY(found);
        QVERIFY(stateOf(*found) == stateOf(drawing.document.now(), drawing.history));
        drawing.journal.discard();
    }
    void withoutAFolderDrawingGoesOn()
    {
        QFile file(home_.filePath("no folder"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        RecordedDrawing drawing(RandomDocuments(1).document(3), file.fileName());
        drawing.journal.wait();
        RandomCommands commands(drawing.document, 3);
        for (int i = 0; i < 20; ++i) {
            drawing.history.push(commands.next());
            QVERIFY(!drawing.journal.complete());
            QVERIFY(drawing.journal.whyIncomplete().contains("cannot be written"));
        }
    }
    // Where no step is taken, a timer tries again. Another document is in the same plight.
    void itIsSaidForEachDocumentAsLongAsItIsTrue()
    {
        const QString path = home_.filePath("later a folder");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        Journal::Limits limits;
        limits.retry = retryAfter;
        RecordedDrawing drawing(Document(), path, limits);
        const Journal& journal = drawing.journal;
        QSignalSpy changed(&journal, &Journal::completeChanged);
        act(drawing, 0);
        QVERIFY(changed.count() > 0 && !journal.whyIncomplete().isEmpty());
        drawing.history.clear();
        drawing.document.load(RandomDocuments(2).document(3));
        changed.clear();
        act(drawing, 0);
        QVERIFY(changed.count() > 0 && !journal.whyIncomplete().isEmpty());
        for (int i = 0; i < 3; ++i) {
            QVERIFY(changed.wait(patience)); // it has tried in vain
            QVERIFY(!journal.complete() && !journal.whyIncomplete().isEmpty());
        }
        QVERIFY(file.remove());
        QTRY_VERIFY_WITH_TIMEOUT(journal.complete(), patience);
        QVERIFY(journal.whyIncomplete().isEmpty());
        drawing.journal.wait();
        const auto found = replayed(journal.folder());
        QVERIFY(found && stateOf(*found) == stateOf(drawing.document.now(), drawing.history));
        drawing.journal.discard();
    }
    // The object in hand is recorded as well when the disk has room again.
    void anObjectInHandIsKeptUntilThen()
    {
        const QString path = home_.filePath("later another folder");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        Journal::Limits limits;
        limits.retry = retryAfter;
        RecordedDrawing drawing(Document(), path, limits);
        const ContainerId layer = drawing.document.now().containers().childrenOf(0)[0];
        drawing.journal.setInHand(PendingObject{{Path({{0, 0}, {1, 1}}), {}}, layer});
        QVERIFY(!drawing.journal.complete());
        QVERIFY(file.remove());
        QTRY_VERIFY_WITH_TIMEOUT(drawing.journal.complete(), patience);
        const auto found = replayed(drawing.journal.folder());
        QVERIFY(found);
        QCOMPARE(found->document.objects().size(), std::size_t(1));
        drawing.journal.discard();
    }
    void aFullDiskWhileTheFirstBaseIsWritten()
    {
        const disk::Failing disk(disk::Step::Write, 300);
        RecordedDrawing drawing(RandomDocuments(1).document(30), home_.filePath("b"));
        RandomCommands commands(drawing.document, 3);
        drawing.history.push(commands.next());
        QVERIFY(!drawing.journal.whyIncomplete().isEmpty());
        QVERIFY(!drawing.journal.complete());
    }
};

} // namespace recovery_journal_full_disk_test

TEST_CLASS(recovery_journal_full_disk_test::JournalFullDiskTest, Core)
#include "tests/app/recovery/journal_full_disk_test.moc"

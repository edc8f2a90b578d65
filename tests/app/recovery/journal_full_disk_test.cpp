// SPDX-License-Identifier: GPL-3.0-or-later
// A journal on a disk that becomes full at any byte.
#include "app/recovery/journal.h"

#include <QSignalSpy>
#include <QTest>

#include <thread>

#include "tests/app/commands/random_commands.h"
#include "tests/app/formats/failing_disk.h"
#include "tests/app/recovery/recorded_drawing.h"

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
            QSignalSpy failed(&drawing.journal, &Journal::failed);
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
            QCOMPARE(failed.count(), full ? 1 : 0);
            if (full)
                QVERIFY2(failed[0][0].toString().contains("No space left on device. Save"),
                         qPrintable(failed[0][0].toString()));
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
        QSignalSpy failed(&drawing.journal, &Journal::failed);
        {
            const disk::Failing disk(disk::Step::Sync);
            act(drawing, 0);
            QVERIFY(failed.wait(patience));
            QVERIFY2(failed[0][0].toString().contains("Input/output error. Save the drawing."),
                     qPrintable(failed[0][0].toString()));
            QVERIFY(!drawing.journal.complete());
            std::this_thread::sleep_for(2 * retryAfter);
            act(drawing, 1); // a new base fails as well
            drawing.journal.wait();
            QVERIFY(!drawing.journal.complete());
            QCOMPARE(failed.count(), 1);
        }
        std::this_thread::sleep_for(2 * retryAfter);
        act(drawing, 3);
        drawing.journal.wait();
        QVERIFY(drawing.journal.complete());
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
        QSignalSpy failed(&drawing.journal, &Journal::failed);
        drawing.journal.wait();
        QCOMPARE(failed.count(), 0); // there is nothing to lose yet
        RandomCommands commands(drawing.document, 3);
        for (int i = 0; i < 20; ++i)
            drawing.history.push(commands.next());
        QCOMPARE(failed.count(), 1);
        QVERIFY(!drawing.journal.complete());
    }
    void aFullDiskWhileTheFirstBaseIsWritten()
    {
        const disk::Failing disk(disk::Step::Write, 300);
        RecordedDrawing drawing(RandomDocuments(1).document(30), home_.filePath("b"));
        QSignalSpy failed(&drawing.journal, &Journal::failed);
        RandomCommands commands(drawing.document, 3);
        drawing.history.push(commands.next());
        QCOMPARE(failed.count(), 1);
        QVERIFY(!drawing.journal.complete());
    }
};

QTEST_GUILESS_MAIN(JournalFullDiskTest)
#include "journal_full_disk_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Journals that were cut off or changed: a valid beginning is always recovered.
#include "app/recovery/journal.h"

#include <QTest>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"

using namespace app;

namespace {

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A journal whose files a test replaces.
struct Copy {
    explicit Copy(const QString& folder)
        : base(contents(baseFile(folder, 1))), log(contents(logFile(folder, 1)))
    {
    }
    std::optional<Recovered> replayed(const QByteArray& withBase, const QByteArray& withLog) const
    {
        write(baseFile(home.path(), 1), withBase);
        write(logFile(home.path(), 1), withLog);
        journalState(home.path());
        return app::replayed(home.path());
    }
    static void write(const QString& path, const QByteArray& bytes)
    {
        QFile::remove(path); // replacing contents would wait for the disk
        QFile file(path);
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes);
    }
    QTemporaryDir home;
    QByteArray base, log;
};

} // namespace

class DamagedJournalTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;

    /// Does steps and notes the state and the size of the log after each.
    struct Noted {
        std::vector<RecordedState> states;
        std::vector<qint64> sizes;
    };
    static Noted act(RecordedDrawing& drawing, int steps)
    {
        Noted noted;
        RandomCommands commands(drawing.document, 3);
        const auto note = [&] {
            noted.states.push_back(stateOf(drawing.document.now(), drawing.history));
            noted.sizes.push_back(QFileInfo(logFile(drawing.journal.folder(), 1)).size());
        };
        drawing.journal.wait();
        note();
        for (int i = 0; i < steps; ++i) {
            if (i % 5 == 3)
                drawing.history.undo();
            else if (i % 7 == 6)
                drawing.history.setClean();
            else
                drawing.history.push(commands.next());
            note();
        }
        return noted;
    }

private slots:
    void aCutOffTailLosesOnlyItself()
    {
        RecordedDrawing drawing(RandomDocuments(1).document(4), home_.filePath("a"));
        const Noted noted = act(drawing, 12);
        const Copy copy(drawing.journal.folder());
        QVERIFY(copy.log.size() > 500);
        for (qsizetype size = 0; size <= copy.log.size(); ++size) {
            const auto found = copy.replayed(copy.base, copy.log.first(size));
            std::size_t last = 0;
            while (last + 1 < noted.sizes.size() && noted.sizes[last + 1] <= size)
                ++last;
            QVERIFY2(found && stateOf(*found) == noted.states[last],
                     qPrintable(QString::number(size)));
        }
        for (qsizetype size = 0; size < copy.base.size(); ++size)
            if (const auto found = copy.replayed(copy.base.first(size), copy.log))
                QVERIFY(stateOf(*found) == noted.states.back());
    }
    void flippedBitsLoseOnlyWhatFollows()
    {
        RecordedDrawing drawing(RandomDocuments(2).document(3), home_.filePath("b"));
        const Noted noted = act(drawing, 8);
        const Copy copy(drawing.journal.folder());
        RandomSheets random(5);
        for (int i = 0; i < 10'000; ++i) {
            QByteArray log = copy.log, base = copy.base;
            QByteArray& changed = i % 4 == 0 ? base : log;
            const auto at = qsizetype(random.below(std::size_t(changed.size())));
            changed[at] = char(changed[at] ^ (1 << random.below(8)));
            const auto found = copy.replayed(base, log);
            if (i % 4 == 0) {
                QVERIFY2(!found, qPrintable(QString::number(at)));
                continue;
            }
            std::size_t last = 0;
            while (last + 1 < noted.sizes.size() && noted.sizes[last + 1] <= at)
                ++last;
            const bool headerFits = at >= noted.sizes[0];
            QVERIFY2(found && (stateOf(*found) == noted.states[headerFits ? last : 0]),
                     qPrintable(QString::number(at)));
        }
    }
    // Bytes with a right checksum, but wrong contents: what a faulty program could have written.
    void wrongRecordsAreRefused()
    {
        RecordedDrawing drawing(RandomDocuments(4).document(10), home_.filePath("c"));
        act(drawing, 20);
        const Copy copy(drawing.journal.folder());
        const std::string bytes = copy.log.toStdString();
        RandomSheets random(6);
        int applied = 0;
        for (int i = 0; i < 1000; ++i) {
            Replay replay(*readBase(copy.base.toStdString()));
            auto frames = *openedLog(bytes);
            const auto damaged = random.below(20);
            for (std::size_t k = 0; const auto record = frames.next(); ++k) {
                std::string changed(*record);
                if (k == damaged) {
                    const auto at = random.below(changed.size());
                    changed[at] = char(changed[at] ^ (1 << random.below(8)));
                    if (random.below(4) == 0)
                        changed.resize(random.below(changed.size()));
                }
                const Document before = replay.now();
                if (!replay.follow(changed)) {
                    QVERIFY(sameAddress(replay.now(), before));
                    break;
                }
                ++applied;
            }
            QVERIFY(replay.now().containers().objects() == replay.now().objects().size());
        }
        QVERIFY(applied > 5000);
    }
};

QTEST_GUILESS_MAIN(DamagedJournalTest)
#include "damaged_journal_test.moc"

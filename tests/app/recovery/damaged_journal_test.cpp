// SPDX-License-Identifier: GPL-3.0-or-later
// Journals one of whose files was cut off or changed: all is recovered, or all before the damage.
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/recovery/journal.h"
#include "app/recovery/replay.h"

#include <QSysInfo>
#include <QTest>

#include <functional>
#include <map>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/content_of.h"
#include "tests/test_class.h"

namespace recovery_damaged_journal_test {

using namespace app;

namespace {

void write(const QString& path, const QByteArray& bytes)
{
    QFile::remove(path); // replacing contents would wait for the disk
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(bytes);
}

/// The files of a journal whose program has ended, one of which a test damages at a time.
struct Copy {
    explicit Copy(const QString& folder)
    {
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files))
            files[file.fileName()] = contentOf(file.filePath());
        files["lock"] = "999999999\n" + QCoreApplication::applicationName().toUtf8() + "\n"
                        + QSysInfo::machineHostName().toUtf8() + "\n"; // no such process
        QDir().mkdir(journal());
        for (const auto& [name, bytes] : files)
            write(path(name), bytes);
    }
    QString journal() const { return home.filePath("a.journal"); }
    QString path(const QString& name) const { return QDir(journal()).filePath(name); }
    /// What the next start recovers if this file is so.
    std::optional<Recovered> recovered(const QString& name, const QByteArray& bytes) const
    {
        write(path(name), bytes);
        std::optional<Recovered> found;
        if (name == "lock") {
            if (auto left = claimLeftovers(home.path()); left.size() == 1)
                found = recover(left[0]).value;
        } else if (known(journal())) {
            found = recover({journal(), {}, {}, nullptr}).value;
        }
        write(path(name), files.at(name));
        return found;
    }
    std::size_t size() const
    {
        std::size_t all = 0;
        for (const auto& [name, bytes] : files)
            all += std::size_t(bytes.size());
        return all;
    }
    QTemporaryDir home{QDir(QDir("/dev/shm").exists() ? "/dev/shm" : QDir::tempPath())
                           .filePath("clearcut-XXXXXX")};
    std::map<QString, QByteArray> files;
};

} // namespace

class DamagedJournalTest : public QObject {
    Q_OBJECT

    /// All steps are in a base, and a generation has few, so that there are few bytes to damage.
    static Journal::Limits shortLogs(double replay)
    {
        return {.history = 1'000'000'000, .replay = replay};
    }
    QTemporaryDir home_;

    /// The state after each step and the size of the log with it, of the newest generation.
    struct Noted {
        using Step = std::function<UndoCommand*()>;
        Noted(RecordedDrawing& drawing, Step step) : drawing_(drawing), step_(std::move(step))
        {
            drawing.journal.wait();
            note();
        }
        void act(int steps)
        {
            for (int i = 0; i < steps; ++i) {
                if (i % 5 == 3)
                    drawing_.history.undo();
                else if (i % 7 == 6)
                    drawing_.history.setClean();
                else
                    drawing_.history.push(step_());
                note();
            }
        }
        void actUntilNextGeneration()
        {
            while (isLastGeneration())
                act(1);
            drawing_.journal.wait();
            ++generation_;
            states_.clear();
            sizes_.clear();
            note();
        }
        /// Another thread may or may not have written the base of a generation that has just begun.
        bool isLastGeneration() const
        {
            return !QFile::exists(logFile(drawing_.journal.folder(), generation_ + 1));
        }
        /// What can be recovered if that file is intact only up to that byte.
        const RecordedState& until(const QString& name, qsizetype byte) const
        {
            if (name != QFileInfo(log()).fileName())
                return states_.back();
            std::size_t last = 0;
            while (last + 1 < sizes_.size() && sizes_[last + 1] <= byte)
                ++last;
            // With damage before the first record all of them are readable.
            return !truncated_ && byte < sizes_[0] ? states_.back() : states_[last];
        }
        Noted& ofTruncations()
        {
            truncated_ = true;
            return *this;
        }

    private:
        QString log() const { return logFile(drawing_.journal.folder(), generation_); }
        void note()
        {
            states_.push_back(stateOf(drawing_.document.now(), drawing_.history));
            sizes_.push_back(QFileInfo(log()).size());
        }
        RecordedDrawing& drawing_;
        Step step_;
        int generation_ = 1;
        bool truncated_ = false;
        std::vector<RecordedState> states_;
        std::vector<qint64> sizes_;
    };
    static QByteArray place(const QString& name, qsizetype at)
    {
        return (name + ' ' + QString::number(at)).toUtf8();
    }

    /// A small step, so that every truncation can be tested.
    static UndoCommand* smallStep(EditedDocument& document, int number)
    {
        if (number % 2 == 1 && !document.now().objects().empty())
            return new MoveObjects(document, {0}, {1, 2});
        Objects line = document.now().objects().slice(0, 0);
        line.append(Object{Path({{0, 0}, {1, 2}}), {}});
        return new AddObjects(document, line, document.now().containers().childrenOf(0)[0], "Add");
    }

private slots:
    void initTestCase_data()
    {
        QTest::addColumn<int>("generations");
        QTest::newRow("the first generation") << 1;
        QTest::newRow("the second") << 2;
    }
    void everyTruncationLosesOnlyTheTail()
    {
        QFETCH_GLOBAL(int, generations);
        RecordedDrawing drawing(Document(), home_.filePath("a"), shortLogs(0.0002));
        Noted noted(drawing, [&, n = 0]() mutable { return smallStep(drawing.document, n++); });
        for (int i = 1; i < generations; ++i)
            noted.actUntilNextGeneration();
        noted.act(6);
        QVERIFY(noted.isLastGeneration());
        noted.ofTruncations();
        const Copy copy(drawing.journal.folder());
        QCOMPARE(copy.files.size(), std::size_t(generations == 1 ? 4 : 5));
        for (const auto& [name, bytes] : copy.files)
            for (qsizetype size = 0; size <= bytes.size(); ++size) {
                const auto found = copy.recovered(name, bytes.first(size));
                QVERIFY2(found && stateOf(*found) == noted.until(name, size), place(name, size));
            }
    }
    void flippedBitsLoseOnlyWhatFollows()
    {
        QFETCH_GLOBAL(int, generations);
        RecordedDrawing drawing(RandomDocuments(2).document(3), home_.filePath("b"),
                                shortLogs(0.0003));
        RandomCommands commands(drawing.document, 3);
        Noted noted(drawing, [&] { return commands.next(); });
        for (int i = 1; i < generations; ++i)
            noted.actUntilNextGeneration();
        noted.act(6);
        QVERIFY(noted.isLastGeneration());
        const Copy copy(drawing.journal.folder());
        RandomSheets random(5);
        for (int i = 0; i < 5000; ++i) {
            auto at = qsizetype(random.below(copy.size()));
            auto file = copy.files.begin();
            for (; at >= file->second.size(); ++file)
                at -= file->second.size();
            QByteArray bytes = file->second;
            bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
            const auto found = copy.recovered(file->first, bytes);
            QVERIFY2(found && stateOf(*found) == noted.until(file->first, at),
                     place(file->first, at));
        }
    }
    // Bytes with a right checksum, but wrong contents: what a faulty program could have written.
    void wrongRecordsAreRefused()
    {
        QFETCH_GLOBAL(int, generations);
        if (generations > 1)
            return;
        RecordedDrawing drawing(RandomDocuments(4).document(10), home_.filePath("c"));
        RandomCommands commands(drawing.document, 3);
        Noted(drawing, [&] { return commands.next(); }).act(20);
        const Copy copy(drawing.journal.folder());
        const std::string bytes = copy.files.at("log-1").toStdString();
        RandomSheets random(6);
        int applied = 0;
        for (int i = 0; i < 1000; ++i) {
            Replay replay(*readBase(copy.files.at("base-1").toStdString()));
            auto frames = recordsOf(bytes, 0);
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

} // namespace recovery_damaged_journal_test

TEST_CLASS(recovery_damaged_journal_test::DamagedJournalTest, Core)
#include "tests/app/recovery/damaged_journal_test.moc"

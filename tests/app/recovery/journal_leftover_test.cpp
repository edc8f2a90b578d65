// SPDX-License-Identifier: GPL-3.0-or-later
// Journals as leftovers: which are offered, and what becomes of them.
#include "app/commands/add_and_remove.h"
#include "app/commands/move_objects.h"
#include "app/document/document.h"
#include "app/formats/format.h"
#include "app/recovery/replay.h"

#include <QDirIterator>
#include <QTest>

#include "tests/app/commands/random_commands.h"
#include "tests/app/recovery/recorded_drawing.h"
#include "tests/test_class.h"

namespace recovery_journal_leftover_test {

using namespace app;

namespace {

void addLine(RecordedDrawing& drawing)
{
    EditedDocument& document = drawing.document;
    Objects line = document.now().objects().slice(0, 0);
    line.append(Object{Path({{0, 0}, {1, 2}}), {}});
    drawing.history.push(
        new AddObjects(document, line, document.now().containers().childrenOf(0)[0], "Add line"));
}

} // namespace

class JournalLeftoverTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;

    /// A journal of one line, whose program has ended.
    QString left() const
    {
        RecordedDrawing drawing(Document(), home_.path());
        drawing.journal.setOrigin({{"plan", "/a/plan.svg", {}}, {}});
        addLine(drawing);
        return drawing.journal.folder();
    }
    static void damage(const QString& path, qint64 at)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        char byte = 0;
        QVERIFY(file.seek(at) && file.getChar(&byte));
        QVERIFY(file.seek(at) && file.putChar(char(byte ^ 1)));
    }
    qsizetype files() const { return QDir(home_.path()).entryList({"*.journal*"}).size(); }

private slots:
    void init() { QCOMPARE(files(), 0); }
    void cleanup()
    {
        for (const QFileInfo& each : QDir(home_.path()).entryInfoList({"*.journal*"}))
            QDir(each.filePath()).removeRecursively();
    }

    void isOfferedWithItsNameAndTime()
    {
        const QString folder = left();
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].file, folder);
        QCOMPARE(found[0].origin.name, "plan");
        QCOMPARE(found[0].origin.path, "/a/plan.svg");
        QVERIFY(std::abs(found[0].ended.secsTo(QDateTime::currentDateTime())) < 60);
        QVERIFY(claimLeftovers(home_.path()).empty()); // it has been claimed
        const auto recovered = recover(found[0]);
        QVERIFY(recovered);
        QCOMPARE(recovered.value->document.objects().size(), std::size_t(1));
        QCOMPARE(recovered.value->history.steps[0].text, "Add line");
        found.clear();
        QCOMPARE(claimLeftovers(home_.path()).size(), std::size_t(1));
    }
    void isNotOfferedWhileItsProgramRuns()
    {
        RecordedDrawing drawing(Document(), home_.path());
        addLine(drawing);
        QVERIFY(claimLeftovers(home_.path()).empty());
        QVERIFY(QFile::exists(drawing.journal.folder()));
    }
    void isRemovedWithoutUnsavedChanges()
    {
        {
            RecordedDrawing drawing(Document(), home_.path());
            addLine(drawing);
            drawing.history.setClean();
            drawing.journal.wait();
        }
        {
            RecordedDrawing drawing(Document(), home_.path());
            drawing.journal.wait();
        }
        QCOMPARE(files(), 2);
        QVERIFY(claimLeftovers(home_.path()).empty());
        QCOMPARE(files(), 0);
    }
    void isDiscarded()
    {
        left();
        auto found = claimLeftovers(home_.path());
        discard(found[0]);
        QCOMPARE(files(), 0);
    }
    void withADamagedBaseIsReadFromTheCopy()
    {
        const QString folder = left();
        damage(baseFile(folder, 1), 30);
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].origin.name, "plan");
        const auto recovered = recover(found[0]);
        QVERIFY(recovered && recovered.value->lost.isEmpty());
        QCOMPARE(recovered.value->document.objects().size(), std::size_t(1));
    }
    void withoutABaseStartsFromTheFile()
    {
        const QTemporaryDir files;
        const QString plan = files.filePath("plan.svg");
        QVERIFY(!writeFile(RandomDocuments(1).document(5), plan));
        const QDateTime time = QFileInfo(plan).lastModified();
        const Document opened = readFile(plan).value->document;
        for (const bool changed : {false, true}) {
            QString folder;
            QByteArray expected;
            {
                RecordedDrawing drawing(opened, home_.path());
                drawing.journal.setOrigin({{"plan", plan, time}, {}});
                addLine(drawing);
                drawing.history.push(new MoveObjects(drawing.document, {0}, {1, 2}));
                expected = svgOf(drawing.document.now());
                folder = drawing.journal.folder();
                drawing.journal.wait();
            }
            damage(baseFile(folder, 1), 10);
            damage(copyFile(folder, 1), 10);
            if (changed) {
                QFile file(plan);
                QVERIFY(file.open(QIODevice::ReadWrite));
                QVERIFY(file.setFileTime(time.addSecs(9), QFile::FileModificationTime));
            }
            auto found = claimLeftovers(home_.path());
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].origin.path, plan);
            const auto recovered = recover(found[0]);
            if (changed) { // its steps do not fit an empty drawing
                QVERIFY(!recovered);
                continue;
            }
            QVERIFY(recovered);
            QCOMPARE(svgOf(recovered.value->document), expected);
            QVERIFY(!recovered.value->lost.isEmpty());
            discard(found[0]);
        }
    }
    void withoutABaseAnUntitledDrawingStartsEmpty()
    {
        QString folder;
        {
            RecordedDrawing drawing(newDrawing(), home_.path());
            addLine(drawing);
            addLine(drawing);
            folder = drawing.journal.folder();
            drawing.journal.wait();
        }
        for (const QString& base : {baseFile(folder, 1), copyFile(folder, 1)})
            QVERIFY(QFile::resize(base, 3));
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        const auto recovered = recover(found[0]);
        QVERIFY(recovered);
        QCOMPARE(recovered.value->document.objects().size(), std::size_t(2));
        QVERIFY(!recovered.value->lost.isEmpty());
    }
    void thatIsDamagedIsSetAside()
    {
        const QString folder = left();
        for (const QString& file : {baseFile(folder, 1), copyFile(folder, 1), logFile(folder, 1)})
            damage(file, 30);
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        const auto recovered = recover(found[0]);
        QVERIFY(!recovered);
        QVERIFY2(recovered.error.endsWith('.'), qPrintable(recovered.error));
        const QString aside = setAside(found[0]);
        QVERIFY(QFile::exists(baseFile(aside, 1)));
        QVERIFY(claimLeftovers(home_.path()).empty());
        QVERIFY(QFile::exists(aside));
    }
    // It names no process, another one or another computer, but this process has it locked.
    void whoseLockIsDamagedIsNotOfferedWhileItsProgramRuns()
    {
        RecordedDrawing drawing(Document(), home_.path());
        addLine(drawing);
        const QString lock = QDir(drawing.journal.folder()).filePath("lock");
        for (int at = 0; at < int(QFileInfo(lock).size()); at += 3) {
            damage(lock, at);
            QVERIFY(claimLeftovers(home_.path()).empty());
        }
        QVERIFY(QFile::resize(lock, 0));
        QVERIFY(claimLeftovers(home_.path()).empty());
    }
    // Nothing unsaved is known, but the damaged end may have been a step.
    void withADamagedEndIsNeverDiscarded()
    {
        const QString folder = left();
        QFile log(logFile(folder, 1));
        QVERIFY(log.open(QIODevice::ReadWrite));
        const QByteArray bytes = log.readAll();
        for (qint64 at = 50; at < bytes.size(); at += 7) {
            damage(log.fileName(), at);
            QCOMPARE(claimLeftovers(home_.path()).size(), std::size_t(1));
            damage(log.fileName(), at);
        }
    }
    // A state folder may hold anything, and links lead anywhere.
    void thatIsSomeoneElsesIsLeftAlone()
    {
        const QTemporaryDir elsewhere;
        const auto write = [](const QString& path) {
            QDir().mkpath(QFileInfo(path).path());
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        };
        const auto everything = [](const QString& folder) {
            QStringList all;
            const auto filter =
                QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot;
            for (QDirIterator each(folder, filter, QDirIterator::Subdirectories); each.hasNext();)
                all << each.next();
            all.sort();
            return all;
        };
        const QString victim = elsewhere.filePath("victim.journal");
        for (const char* name :
             {"thesis.txt", "folder/deep.txt", "lock", "base-0", "base-x", "log"})
            write(victim + '/' + name);
        write(elsewhere.filePath("base"));
        const auto in = [this](const char* path) { return QDir(home_.path()).filePath(path); };
        QVERIFY(QFile::link(victim, in("evil.journal")));
        QVERIFY(QFile::link(in("nowhere"), in("lost.journal")));
        write(in("notes.journal/notes.txt"));
        write(in("hidden.journal/.config"));
        write(in("nested.journal/base-1/thesis.txt"));
        write(in("linked.journal/notes.txt"));
        for (const char* link : {"linked.journal/base-1", "linked.journal/log-1"})
            QVERIFY(QFile::link(elsewhere.filePath("base"), in(link)));
        write(in("file.journal"));
        const QStringList before = everything(home_.path()), there = everything(elsewhere.path());
        QVERIFY(claimLeftovers(home_.path()).empty());
        QCOMPARE(everything(home_.path()), before);
        QCOMPARE(everything(elsewhere.path()), there);
        for (const char* name : {"evil.journal", "lost.journal", "file.journal"})
            QVERIFY(QFile::remove(in(name)));
    }
    void isRemovedWithoutWhatIsNotItsOwn()
    {
        const QString folder = left();
        const QTemporaryDir elsewhere;
        QFile notes(folder + "/notes.txt");
        QVERIFY(notes.open(QIODevice::WriteOnly));
        QVERIFY(QDir(folder).mkpath("copy-7/kept"));
        QVERIFY(QFile::link(elsewhere.path(), folder + "/log-9"));
        QFile unfinished(folder + "/base-2.aBcDeF"); // of a process that was killed
        QVERIFY(unfinished.open(QIODevice::WriteOnly));
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        discard(found[0]);
        QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 (QStringList{"copy-7", "log-9", "notes.txt"}));
        QVERIFY(QDir(folder).exists("copy-7/kept") && QDir(elsewhere.path()).exists());
        QVERIFY(claimLeftovers(home_.path()).empty());
    }
    // The beginning of a journal, without a base or a log.
    void thatHasOnlyBegunIsRemoved()
    {
        for (const char* name : {"empty.journal", "begun.journal"})
            QVERIFY(QDir(home_.path()).mkdir(name));
        QFile unfinished(home_.filePath("begun.journal/base-1.aBcDeF"));
        QVERIFY(unfinished.open(QIODevice::WriteOnly));
        QVERIFY(claimLeftovers(home_.path()).empty());
        QCOMPARE(files(), 0);
    }
    void standsBesideSvgFilesByTime()
    {
        const QString svg = QDir(home_.path()).filePath("old.svg");
        QVERIFY(!writeLeftover(Document(), {"old", {}, {}}, svg));
        QTest::qWait(20);
        left();
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].origin.name, "plan");
        QCOMPARE(found[1].origin.name, "old");
        QVERIFY(recover(found[1]));
        discard(found[1]);
    }
};

} // namespace recovery_journal_leftover_test

TEST_CLASS(recovery_journal_leftover_test::JournalLeftoverTest, Core)
#include "tests/app/recovery/journal_leftover_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/file_watch.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace session_file_watch_test {

using namespace app;

namespace {

constexpr int patience = 20'000; // milliseconds

/// A file that is watched.
struct Watched {
    Watched()
    {
        write("ours");
        watch.follow(path, time());
    }
    QDateTime time() const { return QFileInfo(path).lastModified(); }
    void write(const QByteArray& bytes)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        touch(file);
    }
    /// As programs do that never leave half a file.
    void replace(const QByteArray& bytes)
    {
        QSaveFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        QVERIFY(file.commit());
        QFile written(path);
        QVERIFY(written.open(QIODevice::ReadWrite));
        touch(written);
    }
    /// Clocks of file systems are coarse.
    void touch(QFile& file)
    {
        file.flush();
        QVERIFY(file.setFileTime(QDateTime::fromSecsSinceEpoch(1'700'000'000 + ++writes),
                                 QFile::FileModificationTime));
    }
    static void rest() { QTest::qWait(int(3 * FileWatch::rest.count())); }

    QTemporaryDir folder;
    QString path = folder.filePath("plan.svg");
    int writes = 0;
    FileWatch watch;
    QSignalSpy changed{&watch, &FileWatch::changed}, removed{&watch, &FileWatch::removed};
};

} // namespace

class FileWatchTest : public QObject {
    Q_OBJECT

private slots:
    void everyChangeIsSaid()
    {
        Watched file;
        for (int times = 1; times <= 3; ++times) {
            file.write("theirs");
            QTRY_COMPARE_WITH_TIMEOUT(file.changed.count(), times, patience);
        }
        QCOMPARE(file.removed.count(), 0);
    }
    void aReplacedFileIsAChangeEachTime()
    {
        Watched file;
        for (int times = 1; times <= 3; ++times) {
            file.replace("theirs");
            QTRY_COMPARE_WITH_TIMEOUT(file.changed.count(), times, patience);
        }
        file.write("in place");
        QTRY_COMPARE_WITH_TIMEOUT(file.changed.count(), 4, patience);
        QCOMPARE(file.removed.count(), 0);
    }
    void deletingAndMovingAreSaidOnce()
    {
        Watched file;
        QVERIFY(QFile::rename(file.path, file.folder.filePath("elsewhere.svg")));
        QTRY_COMPARE_WITH_TIMEOUT(file.removed.count(), 1, patience);
        file.write("again");
        QTRY_COMPARE_WITH_TIMEOUT(file.changed.count(), 1, patience);
        QVERIFY(QFile::remove(file.path));
        QTRY_COMPARE_WITH_TIMEOUT(file.removed.count(), 2, patience);
        Watched::rest();
        QCOMPARE(file.removed.count(), 2);
        QCOMPARE(file.changed.count(), 1);
    }
    void aChangeJustBeforeIsSaid()
    {
        Watched file;
        const QDateTime opened = file.time();
        file.watch.pause();
        file.write("theirs");
        file.watch.follow(file.path, opened);
        QTRY_COMPARE_WITH_TIMEOUT(file.changed.count(), 1, patience);
    }
    void whatTheProgramItselfWritesIsNotSaid()
    {
        Watched file;
        file.watch.pause();
        file.replace("ours");
        file.watch.follow(file.path, file.time());
        Watched::rest();
        QCOMPARE(file.changed.count() + file.removed.count(), 0);
    }
    void otherFilesOfTheFolderDoNotMatter()
    {
        Watched file;
        QFile other(file.folder.filePath("other.svg"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.close();
        QVERIFY(other.remove());
        Watched::rest();
        QCOMPARE(file.changed.count() + file.removed.count(), 0);
    }
};

} // namespace session_file_watch_test

TEST_CLASS(session_file_watch_test::FileWatchTest, Core)
#include "tests/app/session/file_watch_test.moc"

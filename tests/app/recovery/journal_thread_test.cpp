// SPDX-License-Identifier: GPL-3.0-or-later
// Appended bytes reach the disk by themselves. What the clock says is printed, not tested: other
// programs decide how long a thread or a disk waits.
#include "app/recovery/journal_thread.h"
#include "app/recovery/log_file.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <semaphore>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace recovery_journal_thread_test {

using namespace app;

static_assert(LogSync::within <= std::chrono::milliseconds(500),
              "half of the second is for the disk");

namespace {

constexpr std::chrono::seconds patience{60}; // against a hang

std::counting_semaphore<1000> syncs{0};
std::binary_semaphore mayEnd{0};
std::atomic<std::int64_t> synced = 0; ///< bytes of the file that was synced last
std::atomic<bool> diskHangs = false;

} // namespace

/// Goes before the C library's function.
extern "C" int fdatasync(int file)
{
    struct stat status {};
    const bool known = ::fstat(file, &status) == 0;
    const int result = int(::syscall(SYS_fdatasync, file));
    synced = known ? status.st_size : -1;
    syncs.release();
    if (diskHangs.exchange(false))
        mayEnd.acquire();
    return result;
}

class JournalThreadTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;
    std::shared_ptr<LogFile> log_;
    static void noFailure(const std::shared_ptr<LogFile>&, const QString&) {}

private slots:
    void init()
    {
        QString error;
        log_ = LogFile::create(home_.filePath("log"), {}, error);
        QVERIFY2(log_, qPrintable(error));
        synced = 0;
    }
    // The thread that appended is blocked here: nothing else asks for the sync.
    void everyAppendedByteIsSyncedWithinASecond()
    {
        LogSync sync(noFailure);
        QElapsedTimer clock;
        for (std::int64_t size = 5; size <= 15; size += 5) {
            clock.start();
            QVERIFY(!log_->append("abcde"));
            sync.appended(log_);
            QVERIFY(syncs.try_acquire_for(patience));
            qInfo("synced after %lld ms", clock.elapsed());
            QCOMPARE(synced.load(), size);
        }
    }
    void whatIsAppendedDuringASyncIsSyncedNext()
    {
        LogSync sync(noFailure);
        diskHangs = true;
        QVERIFY(!log_->append("abcde"));
        sync.appended(log_);
        QVERIFY(syncs.try_acquire_for(patience));
        QVERIFY(!log_->append("fgh"));
        sync.appended(log_);
        mayEnd.release();
        QVERIFY(syncs.try_acquire_for(patience));
        QCOMPARE(synced.load(), std::int64_t(8));
    }
    void manyAppendsAreOneSync()
    {
        LogSync sync(noFailure);
        for (int i = 0; i < 100; ++i) {
            QVERIFY(!log_->append("a"));
            sync.appended(log_);
        }
        while (synced < 100)
            QVERIFY(syncs.try_acquire_for(patience));
        QVERIFY(!syncs.try_acquire());
    }
    void aSlowDiskDelaysNoAppending()
    {
        LogSync sync(noFailure);
        diskHangs = true;
        QVERIFY(!log_->append("a"));
        sync.appended(log_);
        QVERIFY(syncs.try_acquire_for(patience));
        for (int i = 0; i < 1000; ++i) { // would wait for ever otherwise
            QVERIFY(!log_->append("a"));
            sync.appended(log_);
        }
        mayEnd.release();
    }
};

} // namespace recovery_journal_thread_test

TEST_CLASS(recovery_journal_thread_test::JournalThreadTest, None)
#include "tests/app/recovery/journal_thread_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/signal_watch.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <csignal>
#include <fcntl.h>
#include <functional>
#include <pthread.h>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace recovery_signal_watch_test {

using app::SignalWatch;

namespace {

/// A forked process cannot start threads under ThreadSanitizer.
#ifdef __SANITIZE_THREAD__
constexpr bool forksMayStartThreads = false;
#else
constexpr bool forksMayStartThreads = true;
#endif

} // namespace

class SignalWatchTest : public QObject {
    Q_OBJECT

private slots:
    void anotherProgramInheritsNothing()
    {
        const std::set<int> before = pipes();
        const SignalWatch watch([](int) {});
        std::set<int> writeEnds;
        for (const int file : pipes())
            if (!before.contains(file)) {
                QVERIFY(fcntl(file, F_GETFD) & FD_CLOEXEC);
                if ((fcntl(file, F_GETFL) & O_ACCMODE) == O_WRONLY)
                    writeEnds.insert(file);
            }
        QCOMPARE(writeEnds.size(), std::size_t(1));
        QVERIFY(fcntl(*writeEnds.begin(), F_GETFL) & O_NONBLOCK); // a handler does not wait
    }
    // A handler in another thread may be about to write.
    void thePipeStaysOpenAndIsUsedAgain()
    {
        {
            const SignalWatch watch([](int) {});
        }
        const std::set<int> first = pipes();
        for (int i = 0; i < 20; ++i) {
            const SignalWatch watch([](int) {});
            QVERIFY(pipes() == first);
        }
        QVERIFY(pipes() == first);
    }
    void aSecondWatchSeesItsSignal()
    {
        if (!forksMayStartThreads)
            QSKIP("ThreadSanitizer ends a forked process that starts a thread");
        const int status = inAnotherProcess([] {
            {
                const SignalWatch first([](int) { _exit(1); });
            }
            const SignalWatch second([](int signal) { _exit(signal == SIGTERM ? 42 : 2); });
            raise(SIGTERM);
            pause();
        });
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 42);
    }
    // 70,000 signals are more than a pipe holds.
    void manySignalsDoNotBlock()
    {
        if (!forksMayStartThreads)
            QSKIP("ThreadSanitizer ends a forked process that starts a thread");
        const int status = inAnotherProcess([] {
            const SignalWatch watch([](int) {
                for (;;)
                    pause(); // as if writing the file took long
            });
            for (int i = 0; i < 70'000; ++i)
                raise(SIGTERM);
            _exit(42);
        });
        QVERIFY2(WIFEXITED(status), strsignal(WTERMSIG(status)));
        QCOMPARE(WEXITSTATUS(status), 42);
    }
    void withoutAThreadSignalsEndTheProcessAsEver()
    {
        if (!forksMayStartThreads)
            QSKIP("ThreadSanitizer ends a forked process that starts a thread");
        const int status = inAnotherProcess([] {
            pthread_attr_t attributes;
            pthread_attr_init(&attributes);
            pthread_attr_setstacksize(&attributes, std::size_t(1) << 55); // more than there is
            pthread_setattr_default_np(&attributes);
            const SignalWatch watch([](int) { _exit(1); });
            raise(SIGTERM);
            _exit(2);
        });
        QVERIFY2(WIFSIGNALED(status), qPrintable(QString::number(WEXITSTATUS(status))));
        QCOMPARE(WTERMSIG(status), SIGTERM);
    }

private:
    static std::set<int> pipes()
    {
        std::set<int> all;
        for (const QFileInfo& file :
             QDir("/proc/self/fd").entryInfoList(QDir::Files | QDir::System))
            if (QByteArray target(64, '\0');
                readlink(qPrintable(file.filePath()), target.data(), 64) > 0
                && target.startsWith("pipe:"))
                all.insert(file.fileName().toInt());
        return all;
    }
    /// How the process ended. One that hangs is ended by SIGALRM.
    static int inAnotherProcess(const std::function<void()>& work)
    {
        const pid_t child = fork();
        if (child == 0) {
            alarm(20);
            work();
            _exit(3);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return status;
    }
};

} // namespace recovery_signal_watch_test

TEST_CLASS(recovery_signal_watch_test::SignalWatchTest, Core)
#include "tests/app/recovery/signal_watch_test.moc"

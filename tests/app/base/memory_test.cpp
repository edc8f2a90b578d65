// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/memory.h"

#include <QTest>

#include <fstream>
#include <memory>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace base_memory_test {

namespace {

constexpr std::uint64_t megabyte = 1'000'000;

/// The exit code of a process that may use some more bytes of addresses.
template <class Act>
int withMore(std::uint64_t bytes, const Act& act)
{
    const pid_t child = fork();
    if (child == 0) {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        rlimit limit{};
        ::getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = pages * std::uint64_t(::sysconf(_SC_PAGESIZE)) + bytes;
        ::setrlimit(RLIMIT_AS, &limit);
        _exit(act());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    void freeMemoryIsPartOfTheSystems()
    {
        std::ifstream file("/proc/meminfo");
        std::string word;
        std::uint64_t kilobytes = 0;
        file >> word >> kilobytes;
        QVERIFY(word == "MemTotal:" && kilobytes > 0);
        QVERIFY(app::freeMemory() > 10 * megabyte);
        QVERIFY(app::freeMemory() < kilobytes * 1024);
    }
    void aLimitOfTheProcessCounts()
    {
        const auto isLittle = [] { return int(app::freeMemory() <= 100 * megabyte); };
        QCOMPARE(withMore(100 * megabyte, isLittle), 1);
        QCOMPARE(withMore(400 * megabyte, isLittle), 0);
    }
    void aWatchSeesThatLittleIsLeft()
    {
        const auto isEnoughAfter = [](std::uint64_t taken) {
            app::MemoryWatch watch;
            const auto block = std::make_unique_for_overwrite<char[]>(taken);
            for (int i = 0; i < 1'000'000; ++i)
                if (!watch.isEnough())
                    return 0;
            return block ? 1 : 2;
        };
        QCOMPARE(withMore(400 * megabyte, [&] { return isEnoughAfter(10 * megabyte); }), 1);
        QCOMPARE(withMore(400 * megabyte, [&] { return isEnoughAfter(370 * megabyte); }), 0);
    }
    void whatDoesNotFitIsSaidWithNumbers()
    {
        QCOMPARE(app::memoryFault(0), QString());
        const QString fault = app::memoryFault(3'000'000'000'000'000);
        QVERIFY2(fault.startsWith("it needs about 3000000.0 GB of memory, and ")
                     || fault.startsWith("it needs about 3,000,000.0 GB of memory, and "),
                 qPrintable(fault));
        QVERIFY2(fault.endsWith(" GB are free. Close other programs, or split the file."),
                 qPrintable(fault));
    }
};

} // namespace base_memory_test

TEST_CLASS(base_memory_test::MemoryTest, None)
#include "tests/app/base/memory_test.moc"

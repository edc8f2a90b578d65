// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/child_process.h"

#include <QTest>

#include <algorithm>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace judge_children_test {

using namespace app::plug_in;

namespace {

/// Processes that wait until they are killed, which they are when this goes.
class Waiting {
public:
    explicit Waiting(std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            start();
    }
    ~Waiting()
    {
        for (const pid_t one : started) {
            ::kill(one, SIGKILL);
            ::waitpid(one, nullptr, 0);
        }
    }
    Q_DISABLE_COPY_MOVE(Waiting)

    std::vector<pid_t> started; ///< in rising order

private:
    void start()
    {
        const pid_t one = ::fork();
        if (one == 0)
            for (;;)
                ::pause();
        started.push_back(one);
        std::ranges::sort(started);
    }
};

std::vector<pid_t> sorted(std::vector<pid_t> some)
{
    std::ranges::sort(some);
    return some;
}

} // namespace

class ChildrenTest : public QObject {
    Q_OBJECT

private slots:
    void theScanFindsAllAndNoOther()
    {
        QCOMPARE(scannedChildren(), std::vector<pid_t>());
        for (const std::size_t count : {1, 5}) {
            const Waiting children(count);
            QCOMPARE(sorted(scannedChildren()), children.started);
            QCOMPARE(sorted(ownChildren()), children.started);
        }
        QCOMPARE(scannedChildren(), std::vector<pid_t>());
    }

    /// The supervisor waits for what has ended, so that it must not be overlooked.
    void endedChildrenAreStillFound()
    {
        const Waiting child(1);
        QCOMPARE(::kill(child.started.front(), SIGKILL), 0);
        siginfo_t how{};
        QCOMPARE(::waitid(P_PID, id_t(child.started.front()), &how, WEXITED | WNOWAIT), 0);
        QCOMPARE(scannedChildren(), child.started);
    }

    void theListSaysTheSame()
    {
        const Waiting children(3);
        const auto listed = listedChildren();
        if (!listed)
            QSKIP("this system lists no children (CONFIG_PROC_CHILDREN)");
        QCOMPARE(sorted(*listed), children.started);
    }
};

} // namespace judge_children_test

TEST_CLASS(judge_children_test::ChildrenTest, None)
#include "tests/app/judge/children_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Long work at a terminal: progress, and Ctrl+C.
#include <QDir>
#include <QTest>

#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <vector>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_interrupt_test {

namespace {

/// Squares of which each covers a part of all below it. Without an end they take a minute.
QByteArray stackedSquares(int count)
{
    QByteArray svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 400 400'>";
    for (int i = 0; i < count; ++i)
        svg += "<path d='M" + QByteArray::number(i * 0.01) + ',' + QByteArray::number(i * 0.01)
               + "h100v100h-100z' fill='#fff' stroke='#000'/>";
    return svg + "</svg>";
}

/// What a program at a terminal of its own has printed, and how it ended.
struct AtTerminal {
    QByteArray printed;
    int code = -1; ///< -1: by a signal
};

/// What is typed is not printed, and drops nothing that is.
void makeQuiet()
{
    termios terminal{};
    ::tcgetattr(STDIN_FILENO, &terminal);
    terminal.c_lflag &= ~tcflag_t(ECHO);
    terminal.c_lflag |= NOFLSH;
    ::tcsetattr(STDIN_FILENO, TCSANOW, &terminal);
}

/// Types Ctrl+C when the program has printed `sign`.
AtTerminal interrupted(const QStringList& arguments, const QByteArray& sign)
{
    QByteArrayList texts{CLEARCUT_BINARY};
    for (const QString& argument : arguments)
        texts << argument.toUtf8();
    std::vector<char*> pointers;
    for (QByteArray& text : texts)
        pointers.push_back(text.data());
    pointers.push_back(nullptr);
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
        makeQuiet();
        ::execv(pointers[0], pointers.data());
        ::_exit(127);
    }
    AtTerminal ended;
    bool typed = false;
    char some[256];
    for (ssize_t n = 0; (n = ::read(terminal, some, sizeof some)) > 0;) { // an error at its end
        ended.printed += QByteArray(some, n);
        if (!typed && ended.printed.contains(sign))
            typed = ::write(terminal, "\x03", 1) == 1;
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(terminal);
    if (WIFEXITED(status))
        ended.code = WEXITSTATUS(status);
    return ended;
}

} // namespace

class InterruptTest : public QObject {
    Q_OBJECT

private slots:
    void removingCoveredLinesTellsItsProgressAndCanBeInterrupted()
    {
        QTemporaryDir folder;
        const QString in = folder.filePath("stack.svg"), out = folder.filePath("out.svg");
        writeText(in, stackedSquares(20'000));
        const AtTerminal ended =
            interrupted({"clip", in, "--page", "--occlude", "-o", out}, " s left");
        QCOMPARE(ended.code, 130);
        QVERIFY2(ended.printed.endsWith("\r\x1b[K"), ended.printed.constData()); // erased
        const QDir::Filters all = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
        QCOMPARE(QDir(folder.path()).entryList(all), QStringList{"stack.svg"});
    }
};

} // namespace command_line_interrupt_test

TEST_CLASS(command_line_interrupt_test::InterruptTest, Core)
#include "tests/app/command_line/interrupt_test.moc"

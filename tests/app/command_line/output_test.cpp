// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command.h"

#include <QDir>
#include <QTest>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_output_test {

// Where the output of commands goes when the disk is full, a pipe has no reader, or a stream is
// closed.

namespace {

/// Standard output becomes a pipe whose reader has gone: `| head` after its last line.
void loseTheReader()
{
    int ends[2];
    if (::pipe(ends) == 0) {
        ::close(ends[0]);
        ::dup2(ends[1], STDOUT_FILENO);
        ::close(ends[1]);
    }
}

} // namespace

class OutputTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const QString& name) const { return folder_.filePath(name); }

    /// What each command prints, so that none is forgotten; IN is a drawing.
    static std::map<std::string_view, std::vector<QStringList>> printing()
    {
        return {{"clip",
                 {{"IN", "-o", "-", "--to", "svg"},
                  {"MANY", "-o", "-", "--to", "csv"},
                  {"IN", "-o", "-", "--to", "pdf"},
                  {"IN", "-o", "-", "--to", "png"}}},
                {"convert", {{"IN", "-o", "-", "--to", "svg"}}},
                {"compare", {{"IN", "-a", "md", "-f", "csv"}}},
                {"info", {{"IN"}}},
                {"trace",
                 {{"--line", "-160,-30,70,130", "-a", "md", "-f", "text"},
                  {"--line", "-160,-30,70,130", "-a", "md", "-f", "json"}}},
                {"costmap", {{"-a", "md", "--measure", "comparisons", "--size", "8x6", "-o", "-"}}},
                {"algorithms", {{}, {"-f", "json"}}},
                {"bench", {{"-n", "100", "-r", "1", "-a", "md"}}},
                {"judge", {{PLUG_INS "/example.so"}}},
                {"lesson", {{"check", SOURCE_DIR "/resources/lessons/outcodes.md"}}},
                {"help", {{}, {"snapping"}}}};
    }

    QStringList given(std::string_view key, QStringList arguments) const
    {
        arguments.prepend(QString::fromUtf8(key.data(), qsizetype(key.size())));
        arguments.replaceInStrings(QRegularExpression("^IN$"), path("a.csv"));
        arguments.replaceInStrings(QRegularExpression("^MANY$"), path("many.csv"));
        return arguments.replaceInStrings(QRegularExpression("^FOLDER$"), folder_.path());
    }

private slots:
    void initTestCase()
    {
        writeText(path("a.csv"), "0,0,9,9\n1,2,3,4\n");
        writeText(path("many.csv"), QByteArray("0,0,9,9\n").repeated(20'000));
    }

    void aReaderThatGoesIsNoError_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto all = printing();
        QTest::newRow("--help") << QStringList{"--help"};
        QTest::newRow("--version") << QStringList{"--version"};
        for (const app::Command& command : app::commands()) {
            QVERIFY2(all.contains(command.key),
                     qPrintable(QStringLiteral("printing() lacks a call of clearcut %1")
                                    .arg(QLatin1StringView(command.key))));
            QStringList help = given(command.key, {"--help"});
            QTest::newRow(qPrintable(help.join(u' '))) << help;
            for (const QStringList& arguments : all.at(command.key))
                QTest::newRow(qPrintable(given(command.key, arguments).join(u' ')))
                    << given(command.key, arguments);
        }
    }
    void aReaderThatGoesIsNoError()
    {
        QFETCH(QStringList, arguments);
        const auto usual = clearcut(arguments), run = clearcutAfter(loseTheReader, arguments);
        QCOMPARE(usual.code, 0);
        QVERIFY(!usual.out.isEmpty());
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, "");
        static const QRegularExpression time("[0-9.,]+ (ms|s)\\b");
        const auto timeless = [](const QByteArray& text) {
            return QString::fromUtf8(text).replace(time, "TIME");
        };
        QCOMPARE(timeless(run.err), timeless(usual.err));
    }

    // What was asked for besides the output that nobody reads is done.
    void filesAreWrittenWithoutAReader()
    {
        const QString report = path("r.html");
        QCOMPARE(clearcutAfter(loseTheReader,
                               {"bench", "-n", "100", "-r", "1", "-a", "md", "--report", report})
                     .code,
                 0);
        QVERIFY(contentOf(report).trimmed().endsWith("</html>"));
    }

    // But output that could not be written otherwise is one.
    void aClosedStreamIsAnErrorAndNoFileIsWrittenInto()
    {
        const auto without = [](int stream) { return [stream] { ::close(stream); }; };
        const auto noOutput = clearcutAfter(without(STDOUT_FILENO), given("info", {"IN"}));
        QCOMPARE(noOutput.code, 1);
        QCOMPARE(noOutput.err,
                 "clearcut info: Cannot write standard output: Bad file descriptor.\n");
        const auto noInput = clearcutAfter(without(STDIN_FILENO), {"info", "-", "--from", "csv"});
        QCOMPARE(noInput.code, 1);
        QVERIFY2(noInput.err.startsWith("clearcut info: Cannot read standard input: "),
                 noInput.err);
        QCOMPARE(noInput.err.count('\n'), 1);
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
            const QStringList clip{"clip", path("a.csv"), "-o", path("cut.svg")};
            QVERIFY(QFile::remove(path("cut.svg")) || !QFile::exists(path("cut.svg")));
            QCOMPARE(clearcutAfter(without(stream), clip).code, 0);
            const QByteArray cut = contentOf(path("cut.svg"));
            QVERIFY2(cut.startsWith("<?xml") && cut.endsWith("</svg>\n"), cut);
        }
    }

    void aFullDiskLeavesTheOldFile_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const auto row = [](const QString& line) {
            QTest::newRow(qPrintable(line)) << line.split(u' ');
        };
        for (const char* ending : {"svg", "csv", "pdf", "png"}) {
            row(QStringLiteral("clip IN -o old.%1").arg(QLatin1StringView(ending)));
            row(QStringLiteral("convert IN -o old.%1").arg(QLatin1StringView(ending)));
        }
        for (const char* ending : {"gif", "svg", "png", "pdf", "json", "txt"})
            row(QStringLiteral("trace --line -160,-30,70,130 --step 1 -a md -o old.%1 -q")
                    .arg(QLatin1StringView(ending)));
        for (const char* ending : {"png", "csv"})
            row(QStringLiteral("costmap -a md --measure comparisons --size 8x6 -o old.%1")
                    .arg(QLatin1StringView(ending)));
        row("algorithms -o old.json");
        row("bench -n 100 -r 1 -a md -o old.csv");
        row("bench -n 100 -r 1 -a md --report old.html");
        row("bench -n 100 -r 1 -a md --report old.pdf");
        row("--theme light --screenshot old.png");
    }
    void aFullDiskLeavesTheOldFile()
    {
        QFETCH(QStringList, arguments);
        arguments.replaceInStrings(QRegularExpression("^IN$"), path("a.csv"));
        const QString old = path(arguments.filter("old.").front());
        arguments.replaceInStrings(QRegularExpression("^old"), path("old"));
        const auto usual = clearcut(arguments);
        QVERIFY2(usual.code == 0, usual.err);
        const qsizetype size = contentOf(old).size();
        QVERIFY(size > 0);
        for (const qsizetype room : {qsizetype(0), size / 2}) {
            writeText(old, "old");
            const auto run = clearcutAfter(
                [room] {
                    const rlimit limit{rlim_t(room), RLIM_INFINITY};
                    ::setrlimit(RLIMIT_FSIZE, &limit);
                },
                arguments);
            QCOMPARE(run.code, 1);
            QVERIFY2(run.err.contains("Cannot write ") && run.err.endsWith("File too large.\n"),
                     run.err);
            QCOMPARE(contentOf(old), "old");
        }
        QVERIFY(QFile::remove(old));
        QCOMPARE(QDir(folder_.path()).entryList({"old*"}, QDir::Files | QDir::Hidden),
                 QStringList());
    }

    void aPictureThatMayNotBeSoLargeIsSaid()
    {
        const QString picture = path("picture.png");
        const auto run = clearcutAfter(
            [] {
                const rlimit limit{500, RLIM_INFINITY};
                ::setrlimit(RLIMIT_FSIZE, &limit);
            },
            {"--screenshot", picture, path("a.csv")});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.endsWith("picture.png: File too large.\n"), run.err);
        QVERIFY(!QFile::exists(picture));
    }

    // A real one, where it can be had without being root: in a name space of its own.
    void aRealFullDisk()
    {
        const QString script =
            "cd " + folder_.path()
            + "; mkdir -p disk; mount -t tmpfs -o size=64k full disk || exit 99; cp many.csv "
              "big.csv; "
              "echo old > disk/a.svg; $clearcut clip big.csv -q -o disk/a.svg; echo $?; "
              "cat disk/a.svg; ls -A disk; head -c 61440 /dev/zero > disk/filler; "
              "$clearcut clip big.csv -q -o disk/a.svg; echo $?; cat disk/a.svg; ls -A disk";
        const auto run = runProgram(
            "unshare", {"-rm", "/bin/bash", "-c", "clearcut='" CLEARCUT_BINARY "'; " + script});
        if (run.code == 99 || run.err.startsWith("unshare"))
            QSKIP("no file system can be mounted here");
        QCOMPARE(run.out, "1\nold\na.svg\n1\nold\na.svg\nfiller\n");
        QCOMPARE(run.err, QByteArray("clearcut clip: Cannot write disk/a.svg: No space left on "
                                     "device.\n")
                              .repeated(2));
    }

    // Latin-1: Qt would read and write other names.
    void namesThatAreNotUtf8AreSaid_data()
    {
        QTest::addColumn<QString>("script");
        for (const char* script :
             {"clip caf$'\\xe9'.svg -o x.svg", "clip a.csv -o caf$'\\xe9'.svg",
              "convert a.csv --output=caf$'\\xe9'.svg", "info caf$'\\xe9'.svg",
              "judge caf$'\\xe9'.svg", "judge --save-example caf$'\\xe9'",
              "trace --line -1,-3,7,1 -a md -o caf$'\\xe9'/", "algorithms -o caf$'\\xe9'.csv",
              "caf$'\\xe9'.svg", "--screenshot caf$'\\xe9'.png"})
            QTest::newRow(script) << QString::fromLatin1(script);
    }
    void namesThatAreNotUtf8AreSaid()
    {
        QFETCH(QString, script);
        const auto run = inShell(
            "cd " + folder_.path()
            + "; echo '<svg xmlns=\"http://www.w3.org/2000/svg\"/>' > caf$'\\xe9'.svg; $clearcut "
            + script);
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("its name is not UTF-8. Give it another name.\n"), run.err);
        QCOMPARE(run.err.count('\n'), 1);
        QVERIFY(!run.err.contains("written") && run.out.isEmpty());
        const auto names = inShell("cd " + folder_.path() + "; printf '%q ' caf*").out;
        QCOMPARE(names, "$'caf\\351.svg' ");
    }

    // One sentence, and no core. No DISPLAY answers at :9999.
    void aDisplayThatDoesNotAnswer_data()
    {
        QTest::addColumn<QString>("environment");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("X") << "DISPLAY=:9999" << QByteArray("the display “:9999” (DISPLAY)");
        QTest::newRow("X by name") << "DISPLAY=:9999 QT_QPA_PLATFORM=xcb"
                                   << QByteArray("the platform “xcb” (QT_QPA_PLATFORM)");
        QTest::newRow("no platform") << "QT_QPA_PLATFORM=nonsense"
                                     << QByteArray("the platform “nonsense” (QT_QPA_PLATFORM)");
        QTest::newRow("Wayland") << "WAYLAND_DISPLAY=none XDG_RUNTIME_DIR=/tmp"
                                 << QByteArray("the display “none” (WAYLAND_DISPLAY)");
        QTest::newRow("frame buffer")
            << "QT_QPA_PLATFORM=linuxfb:fb=/nonexistent"
            << QByteArray("the platform “linuxfb:fb=/nonexistent” (QT_QPA_PLATFORM)");
        QTest::newRow("empty") << "DISPLAY= WAYLAND_DISPLAY="
                               << QByteArray("There is no display for the editor.");
    }
    void aDisplayThatDoesNotAnswer()
    {
        QFETCH(QString, environment);
        QFETCH(QByteArray, named);
        const auto run = inShell("ulimit -c 0; " + environment + " $clearcut");
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.startsWith("clearcut: ") && run.err.contains(named), run.err);
        QVERIFY(run.err.contains("clearcut clip IN -o OUT"));
        QCOMPARE(run.err.count('\n'), 1);
    }
};

} // namespace command_line_output_test

TEST_CLASS(command_line_output_test::OutputTest, Core)
#include "tests/app/command_line/output_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/unfinished.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/terminal.h"
#include "app/formats/format.h"
#include "app/tables/table.h"
#include "clipping/algorithm.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/app/command_line/program.h"
#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace command_line_usage_test {

namespace {

/// Whether a process has a handler for a signal: before that, the signal would just end it.
bool isCaught(qint64 process, int signal)
{
    for (const QByteArray& line :
         contentOf(QStringLiteral("/proc/%1/status").arg(process)).split('\n'))
        if (line.startsWith("SigCgt:"))
            return ((line.mid(7).trimmed().toULongLong(nullptr, 16) >> (signal - 1)) & 1) != 0;
    return false;
}

/// The keys of all drawing formats, or of those that can be read: "svg, csv".
QByteArray formatKeys(bool readable)
{
    QByteArrayList keys;
    for (const app::Format& format : app::formats())
        if (!readable || format.read)
            keys << QByteArray(format.key.data(), qsizetype(format.key.size()));
    return keys.join(", ");
}

/// The keys of the drawing formats that can be written.
QByteArray writableKeys()
{
    QByteArrayList keys;
    for (const app::Format& format : app::formats())
        if (format.write)
            keys << QByteArray(format.key.data(), qsizetype(format.key.size()));
    return keys.join(", ");
}

/// The keys of all formats of tables: "text or csv or json".
QByteArray tableKeys()
{
    QStringList keys;
    for (const app::TableFormat& format : app::tableFormats())
        keys << format.key;
    return keys.join(QStringLiteral(" or ")).toUtf8();
}

} // namespace

class UsageTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const QString& name) const { return folder_.filePath(name); }

private slots:
    void init() { writeText(path("a.csv"), "0,0,9,9\n1,2,3,4\n"); }

    void helpAndVersionGoToStandardOutput()
    {
        for (const QStringList& help : {QStringList{"--help"}, QStringList{"-h"}}) {
            const auto run = clearcut(help);
            QCOMPARE(run.code, 0);
            QCOMPARE(run.err, "");
            for (const app::Command& command : app::commands()) {
                const QString key = QLatin1StringView(command.key);
                QVERIFY(run.out.contains(key.toUtf8()));
                const auto more = clearcut({key, "--help"});
                QCOMPARE(more.code, 0);
                QCOMPARE(more.err, "");
                const QByteArray text = more.out.simplified().replace("| ", "|"); // lines joined
                for (const app::Option& option : command.options)
                    QVERIFY(text.contains(
                        "--" + option.names.last().toUtf8()
                        + (option.value.isEmpty() ? "" : " " + option.value.toUtf8())));
            }
        }
        QVERIFY(clearcut({"--version"}).out.startsWith("clearcut 0."));
        QCOMPARE(clearcut({"-V"}).out, clearcut({"--version"}).out);
    }

    // In a terminal of 80 columns no line is broken, and what explains an option has half of it.
    void everyHelpFitsATerminal_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("clearcut") << QStringList{"--help"};
        for (const app::Command& command : app::commands())
            QTest::newRow(command.key.data())
                << QStringList{QLatin1StringView(command.key), "--help"};
    }
    void everyHelpFitsATerminal()
    {
        QFETCH(QStringList, arguments);
        const auto run = clearcut(arguments);
        QVERIFY(!run.out.isEmpty());
        bool options = false;
        for (const QByteArray& line : run.out.split('\n')) {
            const QString text = QString::fromUtf8(line);
            QVERIFY2(text.size() <= 80, line.constData());
            if (!text.startsWith(u' '))
                options = text.startsWith("Options");
            const auto first = text.size() - QStringView(text).trimmed().size();
            QVERIFY2(!options || text.contains(QRegularExpression("^ +-")) || first <= 40,
                     line.constData());
        }
    }

    void longListsOfChoicesAreBroken()
    {
        QStringList choices;
        for (int i = 0; i < 40; ++i)
            choices << QStringLiteral("choice%1").arg(i);
        const QString list = choices.join(u'|');
        const QString text = app::aligned({{"--list " + list, "What it means."}});
        for (const QString& line : text.split(u'\n'))
            QVERIFY2(line.size() <= 80, qPrintable(line));
        QVERIFY(text.simplified().remove(u' ').contains(list));
        const QString word(100, u'x'); // cannot be broken
        QVERIFY(app::aligned({{word, "What it means."}}).contains(word));
    }

    // What a refusal says is the most stands in the help.
    void limitsStandInTheHelp_data()
    {
        QTest::addColumn<QString>("command");
        QTest::addColumn<QByteArray>("limit");
        const auto row = [](const char* command, const char* limit) {
            QTest::addRow("%s, %s", command, limit) << QString(command) << QByteArray(limit);
        };
        for (const char* reads : {"clip", "convert", "info", "compare"}) {
            row(reads, "svg: at most elements nested 520 deep; 10,000,000 points, or one for each "
                       "byte of a larger file; 1,000 layers");
            row(reads, "csv: at most 1,000 layers");
        }
        for (const char* writes : {"clip", "convert"}) {
            row(writes, "png: at most 32,767 pixels a side and 150,000,000 in all");
            row(writes, "0 to 30");
        }
        row("compare", "0 to 1000000000");
        row("trace", "64 to 8192");
        row("costmap", "up to 4096 a side");
        row("costmap", "at most 1e150");
        row("bench", "4,000,000,000 lines and 10,000 runs");
    }
    void limitsStandInTheHelp()
    {
        QFETCH(QString, command);
        QFETCH(QByteArray, limit);
        const auto run = clearcut({command, "--help"});
        QVERIFY2(run.out.simplified().contains(limit), run.out.constData());
    }

    void commandsAndHelpMakeACommandLine()
    {
        QVERIFY(app::isCommandLine({"clip"}));
        QVERIFY(app::isCommandLine({"drawing.svg", "--help"}));
        QVERIFY(!app::isCommandLine({}));
        QVERIFY(!app::isCommandLine({"drawing.svg"}));
        QVERIFY(!app::isCommandLine({"drawing.svg", "clip"}));
        QVERIFY(!app::isCommandLine({"./clip"}));
        QVERIFY(!app::isCommandLine({"--", "clip"}));
        QVERIFY(!app::isCommandLine({"--", "--help"}));
    }

    void typesThatAreNotReadAreNamed()
    {
        for (const char* name : {"plan.eps", "plan"})
            writeText(path(name), "0\nSECTION\n");
        const auto error = [&](const QString& name) {
            const auto run = clearcut({"convert", path(name), "-o", path("x.svg")});
            return run.code == 2 ? run.err : "exit code " + QByteArray::number(run.code);
        };
        const QByteArray readable = formatKeys(true);
        const QByteArray eps = error("plan.eps"), none = error("plan");
        QVERIFY2(eps.contains("plan.eps: Clearcut does not read files of the type eps. It reads "
                              + readable + "; --from says which if the name does not."),
                 eps);
        QVERIFY2(none.contains("plan: its name does not show its type. Give it with --from and one "
                               "of "
                               + readable + "."),
                 none);
        QCOMPARE(app::readFile(path("plan.eps")).error,
                 "Cannot open " + path("plan.eps")
                     + ": Clearcut does not read this type of file. It reads " + readable + ".");
    }

    // NOLINTNEXTLINE(readability-function-size): a table, a row for each wrong usage
    void wrongUsageExitsWith2_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const QStringList& arguments, const QByteArray& sentence) {
            QTest::newRow(qPrintable(arguments.join(u' '))) << arguments << sentence;
        };
        const QByteArray all = formatKeys(false), readable = formatKeys(true);
        const QByteArray writable = writableKeys();
        const QStringList clip{"clip", "A", "-o", "x.svg"};
        row({"clip"}, "An argument is missing: clip INPUT -o OUTPUT");
        row({"clip", "A"}, "Name the output: -o FILE");
        row(clip + QStringList{"B"}, "The argument “B” is one too many");
        row(clip + QStringList{"--nonsense"}, "There is no option “--nonsense”.\n");
        row(clip + QStringList{"-w"}, "Missing value after “-w”");
        row(clip + QStringList{"-w", "1,2,3"}, "--window 1,2,3: give four lengths");
        row(clip + QStringList{"-w", "1,2,3,nan"}, "give four lengths");
        row(clip + QStringList{"-w", "1,2,3,4ell"}, "give four lengths");
        row(clip + QStringList{"-w", "1,2,3,4%"}, "give four lengths");
        row(clip + QStringList{"-w", "0in,0in,1e308in,1in"}, "The window is too large");
        row(clip + QStringList{"--page", "--margin=-1e308in"}, "The window is too large");
        row(clip + QStringList{"-w", "1e308,0,1e309,4"},
            "--window 1e308,0,1e309,4: “1e309” is too large");
        row(clip + QStringList{"-w", "0mm,0mm,-1e999mm,4mm"}, "“-1e999mm” is too large");
        row(clip + QStringList{"-w", "1,2,3,1e999ell"}, "give four lengths");
        row(clip + QStringList{"-w", "1,2,0,4"},
            "The window is inverted: its left edge is beyond its right edge.");
        row(clip + QStringList{"-w", "1,2,3,1"},
            "The window is inverted: its top edge is beyond its bottom edge.");
        row(clip + QStringList{"--page", "-w", "1,2,3,4"}, "not both");
        row(clip + QStringList{"--margin", "1"}, "--margin needs --page");
        row(clip + QStringList{"--page", "--margin", "1e6"},
            "--margin 1e6 is too large: nothing of the page is left.");
        row(clip + QStringList{"-a", "nobody"}, "There is no algorithm “nobody”");
        row(clip + QStringList{"-a", "md,md"}, "Name it with -a");
        row(clip + QStringList{"--form", "new"}, "--form new: give corrected or published");
        row(clip + QStringList{"--form", "published"}, "“Exact” has no published form");
        row(clip + QStringList{"--keep", "both"}, "--keep both: give inside or outside");
        row(clip + QStringList{"--tolerance", "0"}, "--tolerance must be greater than 0");
        row(clip + QStringList{"--tolerance", "x"}, "--tolerance x: give a length");
        row(clip + QStringList{"--precision", "-1"},
            "--precision -1: give a whole number from 0 to 30");
        row(clip + QStringList{"--dpi", "0"}, "--dpi 0: give a number greater than 0");
        row(clip + QStringList{"--from", "unknown"}, "--from unknown: give " + all + ".");
        row(clip + QStringList{"--from", "png"},
            "Clearcut does not read files of the type png. It reads " + readable + ";");
        row({"clip", "A", "-o", "x.unknown"},
            "x.unknown: Clearcut does not write files of the type unknown. It writes " + writable
                + ";");
        row({"clip", "-", "-o", "x.svg"},
            "clip: - (standard input): give its type with --from and one of " + readable + ".");
        for (const char* command : {"clip", "convert"})
            row({command, "A", "-o", "-"}, command
                                               + QByteArray(": -o - (standard output): give its "
                                                            "type with --to and one of ")
                                               + writable + ".");
        row({"info"}, "An argument is missing: info INPUT");
        row({"algorithms", "x"}, "The argument “x” is one too many");
        row({"algorithms", "--format", "unknown"}, "--format unknown: give " + tableKeys());
        row({"bench", "--lines", "0"}, "--lines 0: give a whole number from 1 to");
        row({"bench", "--lines", "1.5"}, "--lines 1.5: give a whole number from 1 to");
        row({"bench", "--lines", "1e99"}, "--lines 1e99: give a whole number from 1 to");
        row({"bench", "--qick"}, "There is no option “--qick”. Did you mean “--quick”?");
        row({"bench", "--scene", "foo"}, " or file:PATH.");
        row({"bench", "--scene", "file:"}, " or file:PATH.");
        row({"bench", "--runs", "ten"}, "--runs ten: give a whole number from 1 to");
        row({"bench", "-a", "md,,cs"}, "There is no algorithm “”");
        row({"bench", "--format", "unknown"}, "--format unknown: give " + tableKeys());
        row({"bench", "--scene", "moon"}, "--scene moon: give paper or ");
        row({"bench", "--space", "0,0,5cm,5"}, "--space 0,0,5cm,5: give four numbers without");
        row({"bench", "--window=-960,-75,100,75"},
            "the space must extend beyond it on all four sides");
        row({"bench", "--measure", "clip,sleep"}, "--measure clip,sleep: give clip, draw, total");
        row({"bench", "--form", "published", "-a", "exact"}, "None of these algorithms");
        row({"bench", "--paper", "table3"}, "--paper table3: give table1 or table2 or all");
        row({"bench", "--paper", "all", "-a", "cs"}, "--paper chooses the algorithms itself");
        row({"bench", "--precision", "half"}, "--precision half: give double or single");
        row({"bench", "--precision", "single", "--form", "both"}, "leave out --form");
        row({"bench", "--precision", "single", "--paper", "all"}, "leave out --paper");
        row({"bench", "--precision", "single", "--measure", "accuracy"}, "leave out “accuracy”");
        row({"bench", "--draw-with", "ink"}, "--draw-with ink: give auto or opengl or raster");
        row({"bench", "--report", "r.unknown"}, "--report r.unknown: give a name that ends with .");
        row({"bench", "--charts", "c"}, "--charts c: give a name that ends with .");
        row({"bench", "--report", "r.html", "--measure", "classes"}, "need clip, draw or total");
        row({"bench", "--against-paper"}, "--against-paper needs --paper");
    }
    void wrongUsageExitsWith2()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, sentence);
        arguments.replaceInStrings(QRegularExpression("^A$"), path("a.csv"));
        arguments.replaceInStrings("x.svg", path("x.svg"));
        const auto run = clearcut(arguments);
        QCOMPARE(run.code, 2);
        QCOMPARE(run.out, "");
        QVERIFY2(run.err.contains(sentence), run.err.constData());
        QVERIFY(run.err.endsWith("--help” says more.\n"));
        QCOMPARE(run.err.count('\n'), 2);
        QVERIFY(!QFile::exists(path("x.svg")));
    }

    void badFilesGetOneSentenceAndExitWith1_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const char* name, const char* script, const char* sentence) {
            QTest::newRow(name) << QString::fromUtf8(script) << QByteArray(sentence);
        };
        row("missing", "$clearcut clip no.svg -o x.svg",
            "Cannot open no.svg: there is no such file.");
        row("missing info", "$clearcut info no.svg", "Cannot open no.svg: there is no such file.");
        row("folder", "$clearcut clip . -o x.svg",
            "Cannot open .: it is a folder. Name a file in it.");
        row("compressed", "printf '\\x1f\\x8b\\x08' > a.svgz; $clearcut info a.svgz",
            "Cannot open a.svgz: it is compressed (.svgz) and damaged");
        row("compressed, clip", "printf '\\x1f\\x8b\\x08' > a.svgz; $clearcut clip a.svgz -o x.svg",
            "Cannot open a.svgz: it is compressed (.svgz) and damaged");
        row("folder out", "mkdir -p f.svg; $clearcut clip a.csv -o f.svg", "Cannot write f.svg: ");
        row("no such folder", "$clearcut clip a.csv -o no/x.svg",
            "Cannot write no/x.svg: No such file or directory.");
        row("bad row", "echo 1,2,x | $clearcut clip - --from csv -o x.svg",
            "Cannot read standard input: line 1 has “x” where");
        row("not XML", "$clearcut clip a.csv --from svg -o x.svg", "Cannot open a.csv: ");
        row("endless", "head -c 30000000 /dev/zero | $clearcut clip - --from csv -o x.svg",
            "Cannot read standard input: line 1 is too long for CSV.");
        row("full disk", "$clearcut clip a.csv -o - --to svg > /dev/full",
            "Cannot write standard output: No space left on device.");
        row("full disk, table", "$clearcut algorithms > /dev/full",
            "Cannot write standard output: No space left on device.");
        row("full disk, picture", "$clearcut clip a.csv -o - --to png > /dev/full",
            "Cannot write standard output: ");
        row("full device", "$clearcut clip a.csv --to svg -o /dev/full",
            "Cannot write /dev/full: No space left on device.");
        row("closed output", "$clearcut clip a.csv -o - --to svg >&-",
            "Cannot write standard output: ");
        row("huge picture", "$clearcut clip a.csv -o x.png --dpi 1e9",
            "Cannot write x.png: the picture would have ");
    }
    void badFilesGetOneSentenceAndExitWith1()
    {
        QFETCH(QString, script);
        QFETCH(QByteArray, sentence);
        const auto run = inShell("cd " + folder_.path() + "; " + script);
        QCOMPARE(run.code, 1);
        QCOMPARE(run.out, "");
        QVERIFY2(run.err.contains(": " + sentence), run.err.constData());
        QCOMPARE(run.err.count('\n'), 1);
        QVERIFY(!QFile::exists(path("x.svg")));
    }

    void anUnreadableFile()
    {
        QFile::setPermissions(path("a.csv"), {});
        if (QFile file(path("a.csv")); file.open(QIODevice::ReadOnly))
            QSKIP("root reads everything");
        const auto run = clearcut({"clip", path("a.csv"), "-o", path("x.svg")});
        QFile::setPermissions(path("a.csv"), QFile::ReadOwner | QFile::WriteOwner);
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("Permission denied"));
    }

    void anExistingFileIsLostOnlyToAWholeOne()
    {
        const QStringList clip{"clip", path("a.csv"), "-q", "-o", path("old.svg")};
        QCOMPARE(clearcut(clip).code, 0);
        const auto size = contentOf(path("old.svg")).size();
        writeText(path("old.svg"), "old");
        // A limit on file sizes is a full disk that needs no disk; full_disk_test tries each byte.
        for (const qsizetype full : {qsizetype(0), qsizetype(1), size / 2, size - 1}) {
            const auto run = clearcutAfter(
                [full] {
                    const rlimit limit{rlim_t(full), RLIM_INFINITY};
                    ::setrlimit(RLIMIT_FSIZE, &limit);
                },
                clip);
            QCOMPARE(run.code, 1);
            QVERIFY2(run.err.endsWith("old.svg: File too large.\n"), run.err.constData());
            QCOMPARE(contentOf(path("old.svg")), "old");
            QCOMPARE(QDir(folder_.path()).entryList({"old*"}), QStringList{"old.svg"});
        }
        QCOMPARE(
            inShell(
                "cd " + folder_.path()
                + "; chmod 640 old.svg; $clearcut clip a.csv -q -o old.svg && stat -c %a old.svg")
                .out,
            "640\n");
    }

    void aDeviceIsNotReplaced()
    {
        QCOMPARE(inShell("cd " + folder_.path()
                         + "; mkfifo pipe.svg; cat pipe.svg & $clearcut clip a.csv -q -o pipe.svg; "
                           "wait; test -p pipe.svg")
                     .out.count("<line"),
                 2);
    }

    void controlCEndsWith130AndLeavesTheFile()
    {
        writeText(path("old.csv"), "old");
        QProcess process;
        process.start(CLEARCUT_BINARY, {"clip", "-", "--from", "csv", "-o", path("old.csv")});
        QVERIFY(process.waitForStarted());
        process.write("1,2,3,4\n");
        QVERIFY(process.waitForBytesWritten());
        QTRY_VERIFY(isCaught(process.processId(), SIGINT)); // it may wait for more input
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(contentOf(path("old.csv")), "old");
    }

    // Where the file system has unnamed files there is nothing to remove; so a named one is made.
    void controlCLeavesNothingHalf()
    {
        writeText(path("out.svg"), "old");
        QFile half(path("out.svg.AbCdEf")), other(path("out.svg2.AbCdEf"));
        QVERIFY(half.open(QIODevice::WriteOnly) && other.open(QIODevice::WriteOnly));
        const pid_t child = ::fork();
        if (child == 0) {
            app::answerSignals();
            const app::Unfinished guard(path("out.svg"));
            ::raise(SIGINT);
            ::_exit(0);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 130);
        QVERIFY(!half.exists());
        QVERIFY(other.exists());
        QCOMPARE(contentOf(path("out.svg")), "old");
    }

    void missingMemoryIsReported()
    {
        if (!memoryCanBeLimited)
            QSKIP("the sanitizer itself takes more memory than is left here");
        const auto run = inShell("ulimit -v 220000; yes 1,2,3,4 | $clearcut info - --from csv");
        QCOMPARE(run.code, 1);
        // Seen before it is gone, or where an allocation fails.
        QVERIFY2(run.err == "clearcut info: There is not enough memory for this.\n"
                     || (run.err.startsWith("clearcut info: Cannot read standard input: line ")
                         && run.err.endsWith(" does not fit into the memory that is free. Close "
                                             "other programs, or split the file.\n")),
                 run.err.constData());
    }

    void unknownWordIsReported_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QByteArray>("sentence");
        QTest::addColumn<int>("code");
        const auto row = [](const char* line, const QByteArray& sentence, int code) {
            QTest::newRow(line) << QString(line).split(u' ') << "clearcut: " + sentence + '\n'
                                << code;
        };
        const QByteArray nearest = "There is no file or command “clap”. Did you mean “clip”? "
                                   "clearcut --help lists all commands.";
        row("clap a.svg -o b.svg", nearest, 2);
        row("--theme dark clap", nearest, 2);
        row("Converted",
            "There is no file or command “Converted”. Did you mean “convert”? clearcut --help "
            "lists all commands.",
            2);
        row("xyzzy", "There is no file or command “xyzzy”. clearcut --help lists all commands.", 2);
        row("--theme dark clip a.svg", "The command “clip” must come first. Try clearcut --help.",
            2);
        row("no.svg", "Cannot open no.svg: there is no such file.", 1);
        row("file:///no/where.svg", "Cannot open /no/where.svg: there is no such file.", 1);
        row("no/where", "Cannot open no/where: there is no such file.", 1);
    }
    void unknownWordIsReported()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QByteArray, sentence);
        QFETCH(int, code);
        const auto without = clearcut(arguments);
        QCOMPARE(without.err, sentence);
        QCOMPARE(without.code, code);
        const auto with = inShell("QT_QPA_PLATFORM=offscreen $clearcut " + arguments.join(u' '));
        QCOMPARE(with.err, sentence);
        QCOMPARE(with.code, code);
    }

    void algorithmsAreListed()
    {
        const auto lines = clearcut({"algorithms", "--format", "csv"}).out.trimmed().split('\n');
        QCOMPARE(lines[0], "key,abbreviation,name,year,idea");
        QCOMPARE(std::size_t(lines.size()), clipping::algorithms().size() + 1);
        const QByteArray text = clearcut({"algorithms"}).out;
        for (const auto& algorithm : clipping::algorithms())
            QVERIFY(text.contains(QByteArray(algorithm.key.data(), qsizetype(algorithm.key.size()))
                                  + ' '));
    }

    void benchIsRepeatable()
    {
        const QStringList usual{"bench",    "--lines", "20000", "--runs", "2",
                                "--format", "csv",     "-a",    "md,MD"};
        const auto run = clearcut(usual);
        QCOMPARE(run.code, 0);
        const auto lines = run.out.trimmed().split('\n');
        QVERIFY(lines[0].startsWith("algorithm,form,rank,letters,median_ns,ratio_fastest,p_fastest,"
                                    "spread_ns,mean_ns,low_ns,high_ns,visible,lost,shown,"
                                    "checksum,scene,lines,seed,"));
        QCOMPARE(lines.size(), 5); // two forms, twice
        const auto columns = lines[0].split(',');
        const auto field = [&](const QByteArray& line, const char* name) {
            static const QRegularExpression quoted("\"[^\"]*\""); // "-960,-720,960,720"
            const auto bare = QString::fromUtf8(line).replace(quoted, "quoted").toUtf8();
            return bare.split(',').value(columns.indexOf(name));
        };
        const int visible = field(lines[1], "visible").toInt();
        QVERIFY(visible > 3000 && visible < 3500); // 16.4 %
        QCOMPARE(field(lines[1], "lines"), "20000");
        QCOMPARE(field(clearcut({"bench", "-n", "2e4", "-r", "1", "-f", "csv", "-a", "md"})
                           .out.split('\n')
                           .value(1),
                       "lines"),
                 "20000");
        QCOMPARE(field(lines[1], "runs"), "2");
        QCOMPARE(field(lines[1], "seed"), "1");
        const auto checksum = [&](const QStringList& arguments) {
            return field(clearcut(arguments).out.split('\n').value(1), "checksum");
        };
        QCOMPARE(checksum(usual).size(), 16);
        QCOMPARE(checksum(usual), field(lines[1], "checksum"));
        QVERIFY(checksum(usual + QStringList{"--seed", "2"}) != field(lines[1], "checksum"));
    }

    // A clipped line takes 2 to 50 ns, so twenty million take about a second.
    void benchQuickIsLittleWork()
    {
        QElapsedTimer timer;
        timer.start();
        const auto run =
            clearcut({"bench", "--quick", "-a", "cs,lb,cb,nln,skala,kwc,md", "--format", "json"});
        qInfo("%lld ms", timer.elapsed());
        QCOMPARE(run.code, 0);
        const QJsonObject table = QJsonDocument::fromJson(run.out).array()[0].toObject();
        const QJsonObject facts = table["facts"].toObject();
        const auto fact = [&](const char* name) { return facts[name].toVariant().toLongLong(); };
        QCOMPARE(fact("lines"), 100'000);
        const qint64 rows = table["rows"].toArray().size();
        QCOMPARE(rows, 14); // both forms of seven
        const qint64 clipped = fact("lines") * (fact("runs") + fact("warmup")) * rows;
        QVERIFY2(clipped > 1'000'000 && clipped <= 40'000'000,
                 qPrintable(QString::number(clipped)));
    }

    void benchPrintsThePapersTables()
    {
        const auto run = clearcut({"bench", "--paper", "all", "--against-paper", "-n", "5000",
                                   "--runs", "2", "--form", "both", "--format", "json"});
        QCOMPARE(run.err, "");
        QStringList keys;
        const QJsonArray tables = QJsonDocument::fromJson(run.out).array();
        for (const QJsonValue table : tables)
            keys << table["table"].toString();
        QStringList expected;
        for (const char* table : {"table1", "table2"}) {
            expected << QString("%1-paper").arg(table);
            for (const char* form : {"corrected", "published"})
                for (const char* measure : {"clip", "draw", "total"}) {
                    expected << QString("%1-%2-%3").arg(table, measure, form);
                    expected << expected.back() + "-against-paper";
                }
        }
        QCOMPARE(keys, expected);
        const auto usual = clearcut({"bench", "--paper", "table1", "--quick"}).out;
        QVERIFY(usual.contains("Exec. "));
        for (const char* name : {"Clipping only", "Drawing only", "Total"})
            QCOMPARE(usual.count("Table 1, " + QByteArray(name)
                                 + ": seconds for 100,000 lines, "
                                   "algorithms published\n"),
                     1);
        QVERIFY(usual.contains("KWC loses 133 of the 16,523 visible lines"));
    }

    void tablesGoToFilesByTheirEndings()
    {
        const QString file = path("times.tex");
        const QStringList usual{
            "bench", "-n", "1000", "-a", "md", "--measure", "classes,operations,accuracy"};
        const auto run = clearcut(usual + QStringList{"-o", file});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out, "");
        QCOMPARE(contentOf(file).count("\\begin{tabular}"), 3);
        QCOMPARE(clearcut(usual + QStringList{"-o", path("no/times.tex")}).code, 1);
        QVERIFY(clearcut({"algorithms", "-f", "markdown"}).out.startsWith("| key |"));
    }

    void benchTakesADrawing()
    {
        writeText(path("three.csv"), "0,0,9,9\n1,2,3,4\n-5,-5,-6,-6\n");
        const auto run = clearcut({"bench", "-a", "exact", "--runs", "1", "--window", "0,0,5,5",
                                   "-v", "--scene", "file:" + path("three.csv")});
        QCOMPARE(run.err, "");
        QVERIFY2(run.out.contains("lines:      3\n"), run.out.constData());
        const auto lines = run.out.split('\n');
        QVERIFY2(std::ranges::any_of(lines,
                                     [](const QByteArray& line) {
                                         return line.startsWith("exact ")
                                                && line.simplified().split(' ').contains("2");
                                     }), // visible
                 run.out.constData());
    }

    void benchSaysAtWhichWindowOfADrawing()
    {
        const auto said = [&](const QByteArray& windows) {
            writeText(path("drawing.svg"),
                      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:c='urn:clearcut:1' "
                      "width='20mm' height='10mm' viewBox='0 0 20 10'><metadata>"
                          + windows + "</metadata><path d='M0 0h9' stroke='red'/></svg>");
            return clearcut({"bench", "-a", "exact", "--runs", "1", "--scene",
                             "file:" + path("drawing.svg")})
                .err;
        };
        QCOMPARE(said({}), "Window (the page): 0,0,20,10 in the drawing's coordinates.\n");
        QCOMPARE(said("<c:window xmin='1' ymin='1' xmax='3' ymax='4'/>"),
                 "Window (saved in the drawing): 1,1,3,4 in the drawing's coordinates.\n");
    }

    void tablesFitATerminal_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("algorithms") << QStringList{"algorithms"};
        QTest::newRow("bench") << QStringList{
            "bench", "-n",        "500",
            "-r",    "2",         "--form",
            "both",  "--measure", "clip,draw,total,classes,operations,accuracy"};
        QTest::newRow("paper") << QStringList{"bench", "--paper", "all", "-n",
                                              "500",   "-r",      "2",   "--against-paper"};
        QTest::newRow("compare") << QStringList{
            "compare", SOURCE_DIR "/resources/samples/rosette.svg", "-a", "kwc:published"};
    }
    void tablesFitATerminal()
    {
        QFETCH(QStringList, arguments);
        const auto run = clearcut(arguments);
        QVERIFY(run.out.count('\n') > 3);
        for (const QByteArray& line : run.out.split('\n'))
            QVERIFY2(QString::fromUtf8(line).size() <= 80, line.constData());
    }

    // 60 bytes a line and 95 MB besides; the limit leaves 95 bytes a line.
    void millionsOfLinesTakeLittleMemory()
    {
        if (!memoryCanBeLimited)
            QSKIP("the sanitizer itself takes more memory than is left here");
        const auto run = inShell("ulimit -v 380000; $clearcut bench -n 3000000 -r 1 -a exact "
                                 "--measure clip,draw -f csv");
        QCOMPARE(run.err, "");
        QCOMPARE(run.code, 0);
    }

    void infoSaysWhatThereIs()
    {
        const auto run = clearcut({"info", SOURCE_DIR "/tests/app/formats/data/groups.svg"});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.out.contains("page    0,0,240,160, on paper 120mm × 80mm\n"),
                 run.out.constData());
        QVERIFY(run.out.contains("unit    0.5mm\n"));
        QVERIFY(run.out.contains("“Locked”: shapes 5, lines 85, locked\n"));
    }

    void infoSaysWhatAPageWithoutASizeMeans()
    {
        const auto page = [](const QByteArray& attributes) {
            const auto out =
                clearcut({"info", "-", "--from", "svg"},
                         "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + "/>")
                    .out;
            const auto begin = out.indexOf("  page ");
            return out.mid(begin, out.indexOf('\n', begin) - begin);
        };
        QCOMPARE(page("viewBox='0 0 30 20'"),
                 "  page    0,0,30,20, without a size on paper: a unit counts as a pixel");
        QCOMPARE(page("viewBox='0 0 30 20' width='60mm'"),
                 "  page    0,0,30,20, on paper 60mm × 40mm");
    }

    void infoListsWindowsAndContainers()
    {
        const auto run = clearcut(
            {"info", "-", "--from", "svg"},
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:clearcut='urn:clearcut:1' "
            "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' width='9' height='9'>"
            "<metadata><clearcut:window name='Frame' xmin='1' ymin='1' xmax='8' ymax='8' "
            "keep='outside'/><clearcut:window xmin='2' ymin='2' xmax='3' ymax='3' "
            "operation='cut-out' visible='no'/></metadata>"
            "<g inkscape:groupmode='layer' inkscape:label='Town'><path d='M0 0h9'/>"
            "<g id='houses' display='none'><path d='M0 0h9v9'/><path d='M0 0h9'/></g></g></svg>");
        QVERIFY2(run.out.contains("  window  “Frame”: 1,1,8,8, adds\n"
                                  "  window  2,2,3,3, cuts out, hidden\n"
                                  "  keep    outside\n"),
                 run.out.constData());
        QVERIFY2(run.out.contains("  layer   “Town”: shapes 3, lines 4\n"
                                  "  group     “houses”: shapes 2, lines 3, hidden\n"),
                 run.out.constData());
        const auto none = clearcut({"info", "-", "--from", "csv"}, "1,2,3,4\n");
        QVERIFY2(none.out.contains("  window  none\n"), none.out.constData());
    }

    void infoMeasures()
    {
        const auto run =
            clearcut({"info", "-", "--from", "svg"},
                     "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='50mm' "
                     "viewBox='-100 -50 200 100'><path d='M-80 0h60v10'/><rect width='20' "
                     "height='10' display='none'/><path d='M0 0C0 0 30 0 30 0'/></svg>");
        for (const char* line : {"length  160, on paper 80mm\n", "shapes  3, hidden 1\n",
                                 "paths   3, closed 1, curves 1\n", "bounds  -80,0,30,10\n",
                                 "in mm   10mm,25mm,65mm,30mm from the paper's top left corner\n"})
            QVERIFY2(run.out.contains(line), run.out.constData());
        QVERIFY(clearcut({"info", path("a.csv")}).out.contains("mm from the origin\n"));
    }

    // What is calculated has rounding errors; a clip window is a number of the file.
    void infoLeavesOutRoundingErrors()
    {
        const auto run = clearcut(
            {"info", "-", "--from", "svg"},
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:c='urn:clearcut:1' width='9in' "
            "height='9in'><metadata><c:window xmin='0.1' ymin='0' xmax='0.30000000000000004' "
            "ymax='9'/><c:window xmin='0' ymin='0' xmax='1' ymax='1' "
            "angle='0.5235987755982988rad'/></metadata><path transform='scale(1.1)' "
            "d='M0 0L490.87 3'/></svg>");
        for (const char* line : {"bounds  0,0,539.957,3.3\n", "page    0,0,864,864, ",
                                 "0.1,0,0.30000000000000004,9, adds\n", "turned by 30°, adds\n"})
            QVERIFY2(run.out.contains(line), run.out.constData());
        const auto third = clearcut({"info", "-", "--from", "csv"}, "0,0,0.3333333333333333,1\n");
        QVERIFY2(third.out.contains("bounds  0,0,0.3333333333333333,1\n"), third.out.constData());
    }
};

} // namespace command_line_usage_test

TEST_CLASS(command_line_usage_test::UsageTest, Core)
#include "tests/app/command_line/usage_test.moc"

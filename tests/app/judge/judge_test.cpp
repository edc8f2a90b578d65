// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/ulps.h"
#include "app/experiment/ranking.h"
#include "app/judge/example_files.h"
#include "app/judge/judge.h"
#include "app/judge/points.h"
#include "app/judge/race_check.h"
#include "app/judge/signal_text.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <limits>
#include <set>
#include <unistd.h>

#include "tests/sanitizer.h"
#include "tests/test_class.h"

namespace judge_judge_test {

using namespace app::plug_in;
using app::Table;

namespace {

QString pathOf(const QString& sample) { return QStringLiteral(PLUG_INS "/%1.so").arg(sample); }

Case caseOf(const QString& sample)
{
    return {.library = pathOf(sample),
            .program = CLEARCUT_BINARY,
            .randomLines = 2000,
            .race = Case::Race::No};
}

/// It is gone, or nobody has asked yet how it ended.
bool isGone(int process)
{
    QFile stat(QStringLiteral("/proc/%1/stat").arg(process));
    return !stat.open(QIODevice::ReadOnly) || stat.readAll().contains(") Z ");
}

/// The numbers of processes that have this library loaded: their command lines name it.
QStringList running(const QString& library)
{
    QStringList found;
    for (const QString& number : QDir("/proc").entryList(QDir::Dirs)) {
        QFile line(QStringLiteral("/proc/%1/cmdline").arg(number));
        if (line.open(QIODevice::ReadOnly)
            && line.readAll().contains(QByteArray("judge-child\0", 12))
            && (line.seek(0), line.readAll().contains(library.toLocal8Bit()))
            && !isGone(number.toInt()))
            found << number;
    }
    return found;
}

Verdict verdictOn(const Case& which)
{
    auto verdict = judge(which);
    return verdict ? *verdict : Verdict{};
}

} // namespace

/// Libraries that do one thing wrong, each in a child process of the real program.
class JudgeTest : public QObject {
    Q_OBJECT

private slots:
    void theExamplePasses()
    {
        const auto verdict = verdictOn(caseOf("example"));
        QVERIFY2(verdict.passed(), qPrintable(sentence(verdict)));
        QCOMPARE(verdict.name, "Liang-Barsky, the example");
        QCOMPARE(verdict.judged(), verdict.lines());
        QVERIFY(verdict.lines() > 20'000);
        QVERIFY(!verdict.fault());
        QVERIFY(verdict.mostOff < 4);
        QVERIFY2(sentence(verdict).startsWith("Passed: Liang-Barsky, the example is right on all"),
                 qPrintable(sentence(verdict)));
    }

    void wrongLibrariesGetTheRightVerdict_data()
    {
        QTest::addColumn<Fault>("fault");
        QTest::addColumn<QString>("category"); // of the first finding
        QTest::newRow("lost_corner") << Fault::Lost << "corners";
        QTest::newRow("endless_loop") << Fault::DidNotEnd << "regions";
        QTest::newRow("cohen_sutherland") << Fault::DidNotEnd << "near-corners";
        QTest::newRow("not_a_number") << Fault::NotANumber << "corners";
        QTest::newRow("crash") << Fault::Crashed << "regions";
        QTest::newRow("outside") << Fault::Outside << "regions";
        QTest::newRow("reversed") << Fault::Turned << "regions";
        QTest::newRow("invented") << Fault::Invented << "regions";
        QTest::newRow("single") << Fault::Off << "regions";
        QTest::newRow("beyond_visible") << Fault::WroteBeyond << "regions";
        QTest::newRow("blind") << Fault::Nonsense << "nonsense";
        QTest::newRow("leaving") << Fault::LeftProgram << "corners";
        QTest::newRow("greedy") << Fault::Crashed << "regions";
        QTest::newRow("large_file") << Fault::Crashed << "regions";
        QTest::newRow("fickle") << Fault::Changed << "again";
        QTest::newRow("finite_only") << Fault::Nonsense << "nonsense";
    }
    void wrongLibrariesGetTheRightVerdict()
    {
        QFETCH(Fault, fault);
        QFETCH(QString, category);
        if (!memoryCanBeLimited && QTest::currentDataTag() == QByteArray("greedy"))
            QSKIP("memory cannot be limited here");
        const auto verdict = verdictOn(caseOf(QTest::currentDataTag()));
        QVERIFY(!verdict.unusable && !verdict.passed());
        QVERIFY2(verdict.fault() == fault, qPrintable(sentence(verdict)));
        QVERIFY(!verdict.findings.empty());
        const Finding& first = verdict.findings.front();
        QCOMPARE(categories()[first.category].key, category);
        QVERIFY(sentence(verdict).contains(infoOf(fault).sentence));
        for (const FaultInfo& info : faults()) // and for none that is worse than a wrong picture
            if (info.fault < Fault::Lost && info.fault != fault)
                QCOMPARE(verdict.byFault[std::size_t(info.fault)], 0u);
    }

    void theLineThatItHangsInIsNamed()
    {
        const auto verdict = verdictOn(caseOf("endless_loop"));
        for (const Finding& one : verdict.findings) {
            QCOMPARE(one.fault, Fault::DidNotEnd);
            QVERIFY(one.question.line.a.x < one.question.window.min.x);
            QVERIFY(one.question.line.b.x < one.question.window.min.x);
        }
        QVERIFY(verdict.judged() < verdict.lines());
        QVERIFY(verdict.categories[2].judged > 0); // the others are asked about, too
    }

    void theLineThatItCrashesOnIsNamed()
    {
        const auto verdict = verdictOn(caseOf("crash"));
        QVERIFY(verdict.findings.size() > 1); // it was started again
        for (const Finding& one : verdict.findings) {
            QVERIFY(one.question.line.a.x < one.question.window.min.x);
            QVERIFY(one.question.line.b.x > one.question.window.max.x);
            QVERIFY2(one.more.contains("SIGSEGV"), qPrintable(one.more));
        }
        QVERIFY(sentence(verdict).contains("SIGSEGV"));
    }

    void nothingThatItStartedIsLeft_data()
    {
        QTest::addColumn<int>("processes"); // that say their numbers
        QTest::newRow("forking") << 1;
        QTest::newRow("daemon") << 3;
    }
    void nothingThatItStartedIsLeft()
    {
        QFETCH(int, processes);
        const auto verdict = verdictOn(caseOf(QTest::currentDataTag()));
        QCOMPARE(verdict.fault(), Fault::Crashed);
        const QStringList numbers = verdict.printed.split('\n', Qt::SkipEmptyParts);
        QVERIFY2(numbers.size() >= processes, qPrintable(verdict.printed));
        for (const QString& number : numbers) {
            QVERIFY2(number.toInt() > 0, qPrintable(verdict.printed));
            QVERIFY2(isGone(number.toInt()), qPrintable(number));
        }
        QVERIFY2(running(pathOf(QTest::currentDataTag())).isEmpty(),
                 qPrintable(running(pathOf(QTest::currentDataTag())).join(' ')));
    }

    /// The system does not count root's processes, so that it is not root who starts them here. The
    /// other user may not read the folder of this build.
    void aForkBombIsLimited()
    {
        QTemporaryDir folder;
        const QString program = folder.filePath("clearcut"),
                      library = folder.filePath("fork_bomb.so");
        QVERIFY(QFile::copy(CLEARCUT_BINARY, program) && QFile::copy(pathOf("fork_bomb"), library));
        constexpr auto forAll = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner
                                | QFile::ReadOther | QFile::ExeOther;
        for (const QString& path : {folder.path(), program, library})
            QVERIFY(QFile::setPermissions(path, forAll));
        QProcess process;
        process.setChildProcessModifier([] {
            constexpr unsigned nobody = 65534;
            if (::getuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0))
                ::_exit(99);
        });
        process.start(program, {"judge", library, "--no-race"});
        QVERIFY2(process.waitForFinished(120'000), qPrintable(process.errorString()));
        const QString out = process.readAllStandardOutput();
        QVERIFY2(process.exitCode() == 3, qPrintable(out + process.readAllStandardError()));
        const QString printed = out.section("It printed: ", 1).section('\n', 0, 0);
        if (!isSanitized) // forking takes so long then that the judge's clock ends it
            QVERIFY2(printed.toInt() > 0 && printed.toInt() < 300, qPrintable(out.left(2000)));
        QVERIFY2(running(library).isEmpty(), qPrintable(running(library).join(' ')));
    }

    /// Only the corner is to blame.
    void theLostCornerIsACorner()
    {
        const auto verdict = verdictOn(caseOf("lost_corner"));
        for (const Finding& one : verdict.findings) {
            QCOMPARE(one.fault, Fault::Lost);
            const auto& [corner, same] = *one.expected;
            const auto& w = one.question.window;
            QCOMPARE(corner, same);
            QVERIFY((corner.x == w.min.x || corner.x == w.max.x)
                    && (corner.y == w.min.y || corner.y == w.max.y));
        }
        QCOMPARE(verdict.categories.back().wrong, 0u);
    }

    void unusableLibrariesHaveAReason_data()
    {
        QTest::addColumn<Unusable>("why");
        QTest::addColumn<QString>("words");
        QTest::newRow("nobody") << Unusable::NoFile << "There is no file";
        QTest::newRow("not_a_plug_in") << Unusable::NoFunction << "no function clearcut_clip";
        QTest::newRow("of_tomorrow") << Unusable::OtherVersion << "made for version 2";
        QTest::newRow("crash_while_loading") << Unusable::Broken << "SIGABRT";
    }
    void unusableLibrariesHaveAReason()
    {
        QFETCH(Unusable, why);
        QFETCH(QString, words);
        const auto verdict = verdictOn(caseOf(QTest::currentDataTag()));
        QCOMPARE(verdict.unusable, why);
        QVERIFY2(sentence(verdict).contains(words), qPrintable(sentence(verdict)));
        QVERIFY(!verdict.passed());
    }

    void otherFilesAreNotLoadable()
    {
        QTemporaryDir folder;
        auto which = caseOf("any");
        which.library = folder.filePath("noise.so");
        QFile noise(which.library);
        QVERIFY(noise.open(QIODevice::WriteOnly) && noise.write(QByteArray(4096, '\0')) == 4096);
        noise.close();
        const auto verdict = verdictOn(which);
        QCOMPARE(verdict.unusable, Unusable::NotLoadable);
        QVERIFY2(verdict.more.contains("invalid ELF header"), qPrintable(verdict.more));
    }

    void sourceFilesGetTheCompilerCommand_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("C") << "mine.c";
        QTest::newRow("C++") << "mine.cpp";
        QTest::newRow("C++, another ending") << "mine.cc";
        QTest::newRow("a blank and a quote") << "it's mine.c";
        QTest::newRow("object file") << "mine.o";
    }
    /// And the command line that is told makes a library that passes.
    void sourceFilesGetTheCompilerCommand()
    {
        QFETCH(QString, name);
        QTemporaryDir folder;
        QVERIFY(writeExample(folder.path(), Existing::Replace).value);
        auto which = caseOf("any");
        which.library = folder.filePath(name);
        if (name.endsWith(".o"))
            QCOMPARE(QProcess::execute("cc", {"-c", "-std=c99", "-O2", "-fPIC", "-o", which.library,
                                              folder.filePath("example.c")}),
                     0);
        else
            QVERIFY(QFile::copy(folder.filePath("example.c"), which.library));
        const auto verdict = verdictOn(which);
        QCOMPARE(verdict.unusable, Unusable::NotCompiled);
        QVERIFY2(sentence(verdict).contains(" first") && !sentence(verdict).contains("ELF"),
                 qPrintable(sentence(verdict)));
        const QString command = remarks(verdict).value(0);
        QCOMPARE(QProcess::execute("/bin/sh", {"-c", command}), 0);
        which.library = folder.filePath(QFileInfo(name).completeBaseName() + ".so");
        QVERIFY2(verdictOn(which).passed(), qPrintable(command));
    }

    void otherFilesAreNamed()
    {
        QTemporaryDir folder;
        const auto said = [&](const QByteArray& content, const QString& name) {
            QFile file(folder.filePath(name));
            if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
                return QString();
            file.close();
            auto which = caseOf("any");
            which.library = file.fileName();
            const auto verdict = verdictOn(which);
            return sentence(verdict) + verdict.command;
        };
        QVERIFY(said("", "a.so").contains("is empty"));
        QVERIFY(said("# Notes", "a.md").contains("is a text"));
        QVERIFY(said("!<arch>\n", "a.a").contains("static library"));
        // Without the header beside it, that is fetched first.
        QVERIFY(said("int a;", "a.c").contains("--save-example " + folder.path() + " && cc "));
    }

    void slowAndTalkativeOnesAreRight()
    {
        for (const char* sample : {"slow", "talkative"}) {
            auto which = caseOf(sample);
            which.seconds = 600; // no clock decides
            const auto verdict = verdictOn(which);
            QVERIFY2(verdict.passed(), qPrintable(sentence(verdict)));
            QCOMPARE(verdict.printed.startsWith("clipping "), which.library == pathOf("talkative"));
        }
    }

    void slowLibrariesAreNotCalledWrong()
    {
        auto which = caseOf("example");
        which.seconds = 0;
        const auto verdict = verdictOn(which);
        QCOMPARE(verdict.wrong(), 0u);
        QVERIFY(!verdict.passed());
        QVERIFY2(sentence(verdict).startsWith("Too slow"), qPrintable(sentence(verdict)));
    }

    /// Also of one that sleeps, and so takes no processor time.
    void slowLibrariesLearnWhatWasTested()
    {
        auto which = caseOf("sleepy");
        which.seconds = 1;
        std::vector<app::Progress> steps;
        const auto verdict =
            judge(which, {{}, [&](const app::Progress& now) { steps.push_back(now); }});
        QVERIFY(verdict && verdict->wrong() == 0 && !verdict->passed());
        QVERIFY(verdict->judged() > 0 && verdict->judged() < verdict->lines());
        for (std::size_t i = 0; i + 1 < verdict->categories.size(); ++i) // each has had its share
            QVERIFY2(verdict->categories[i].judged > 0
                         && degreeOf(verdict->categories[i]).key == "unfinished",
                     qPrintable(categories()[i].key));
        QVERIFY2(sentence(*verdict).contains("that were tested within 1 s"),
                 qPrintable(sentence(*verdict)));
        QVERIFY(steps.size() >= 10);
        for (std::size_t i = 1; i < steps.size(); ++i)
            QVERIFY(steps[i].share >= steps[i - 1].share && steps[i].share <= 1);
    }

    void whatWasFoundBeforeACrashIsKept()
    {
        QTemporaryDir folder;
        qputenv("LOADS_ONCE", folder.filePath("mark").toLocal8Bit());
        const auto verdict = verdictOn(caseOf("loads_once"));
        QVERIFY(!verdict.unusable);
        QCOMPARE(verdict.fault(), Fault::Crashed);
        QVERIFY(verdict.byFault[std::size_t(Fault::Lost)] > 100);
        QVERIFY(std::ranges::any_of(verdict.findings,
                                    [](const Finding& one) { return one.fault == Fault::Lost; }));
        QVERIFY2(remarks(verdict).join(' ').contains("could not be loaded again"),
                 qPrintable(remarks(verdict).join(' ')));
        QVERIFY2(verdict.notReloaded.contains("SIGABRT"), qPrintable(verdict.notReloaded));
    }

    void theFileThatIsTooLargeIsToldByName()
    {
        const auto verdict = verdictOn(caseOf("large_file"));
        QVERIFY2(sentence(verdict).contains("(SIGXFSZ)"), qPrintable(sentence(verdict)));
    }

    void aTextbooksAlgorithmIsToldWhatItPasses()
    {
        const auto verdict = verdictOn(caseOf("finite_only"));
        const Score score = scoreOf(verdict);
        QCOMPARE(score.right + 1, score.categories);
        QVERIFY(score.points > score.most - fullPoints && score.points < score.most);
        for (std::size_t i = 0; i < verdict.categories.size(); ++i)
            QCOMPARE(pointsOf(verdict.categories[i]) == fullPoints,
                     categories()[i].key != u"nonsense");
        QVERIFY2(remarks(verdict).front().startsWith("It passes everything but “Invalid input”: "),
                 qPrintable(remarks(verdict).front()));
    }

    /// Who keeps no line is right on most, and gets no points for it.
    void theSkeletonGetsNoPointsForKeepingNothing()
    {
        const auto verdict = verdictOn(caseOf("skeleton"));
        QCOMPARE(verdict.fault(), Fault::Lost);
        for (std::size_t i = 0; i < verdict.categories.size(); ++i)
            QCOMPARE(pointsOf(verdict.categories[i]),
                     categories()[i].asked == Asked::Again || categories()[i].key == u"nonsense"
                         ? fullPoints
                         : 0);
    }

    void errorsInTheRaceCount_data()
    {
        QTest::addColumn<Fault>("fault");
        QTest::newRow("race_cheat") << Fault::Lost;
        QTest::newRow("race_later") << Fault::Lost; // and changed, where it was right at first
        QTest::newRow("race_crash") << Fault::Crashed;
    }
    void errorsInTheRaceCount()
    {
        QFETCH(Fault, fault);
        auto which = caseOf(QTest::currentDataTag());
        QVERIFY(verdictOn(which).passed()); // when asked
        which.race = Case::Race::Yes;
        const auto verdict = verdictOn(which);
        QVERIFY(!verdict.passed());
        QVERIFY2(verdict.fault() == fault,
                 qPrintable(sentence(verdict) + remarks(verdict).join(' ')));
        QCOMPARE(verdict.categories.size(), categories().size());
        QCOMPARE(verdict.categories.back().wrong, verdict.wrong());
        QVERIFY2(sentence(verdict).contains("In the race"), qPrintable(sentence(verdict)));
        if (!verdict.times)
            return;
        // How many lines are raced depends on the time that they take.
        QVERIFY(verdict.wrong() > 0 && !verdict.findings.empty());
        for (const Finding& one : verdict.findings)
            QVERIFY((one.fault == fault || one.fault == Fault::Changed) && one.expected
                    && !one.got);
        QCOMPARE(verdict.byFault[std::size_t(Fault::Changed)] > 0,
                 QTest::currentDataTag() == QByteArray("race_later"));
        for (const QStringList& row : raceTable(*verdict.times).rows)
            QCOMPARE(row[1] == "wrong", row[0] == ownKey);
    }

    /// Nothing is known of lines that it sleeps on, so that it does not pass.
    void sleepingInTheRaceDoesNotPass()
    {
        auto which = caseOf("race_sleep");
        QVERIFY(verdictOn(which).passed()); // when asked
        which.race = Case::Race::Yes;
        which.raceSleep = 1; // it sleeps for an hour
        const auto verdict = verdictOn(which);
        QVERIFY2(!verdict.passed() && verdict.wrong() == 0, qPrintable(sentence(verdict)));
        QVERIFY(verdict.hasRace() && !verdict.times);
        QCOMPARE(verdict.categories.back().judged, 0u);
        QCOMPARE(degreeOf(verdict.categories.back()).key, "untested");
        QVERIFY2(sentence(verdict).startsWith("Not finished: ")
                     && remarks(verdict).contains("It was not timed, because it slept in the "
                                                  "race."),
                 qPrintable(sentence(verdict) + remarks(verdict).join(' ')));
    }

    void anEndAfterTheFindingsIsAFault()
    {
        auto which = caseOf("race_leaving");
        QVERIFY(verdictOn(which).passed()); // when asked
        which.race = Case::Race::Yes;
        which.raceSleep = 300; // it waits for another process
        const auto verdict = verdictOn(which);
        const QString told = sentence(verdict) + remarks(verdict).join(' ');
        QVERIFY2(!verdict.passed() && verdict.fault() == Fault::LeftProgram, qPrintable(told));
        QVERIFY(verdict.hasRace() && !verdict.times);
        QVERIFY2(verdict.categories.back().judged > 1, qPrintable(told)); // its findings came
        QCOMPARE(verdict.wrong(), 1u);
        QVERIFY2(told.contains("In the race") && told.contains("exit code 7")
                     && told.contains("It was not timed: "),
                 qPrintable(told));
    }

    void theRoundingOfTheRaceIsTold()
    {
        auto which = caseOf("race_rounding");
        QVERIFY(verdictOn(which).mostOff < 4); // when asked
        which.race = Case::Race::Yes;
        const auto verdict = verdictOn(which);
        QVERIFY2(verdict.passed() && verdict.times, qPrintable(sentence(verdict)));
        QVERIFY2(verdict.mostOff > 15 && verdict.mostOff <= verdict.contract.ulps,
                 qPrintable(QString::number(verdict.mostOff)));
        QVERIFY(verdict.categories.back().outside > 0);
        QVERIFY2(remarks(verdict).front().contains(QString::number(verdict.mostOff, 'g', 3)),
                 qPrintable(remarks(verdict).front()));
    }

    void racesFindingsGoThroughThePipeUnchanged()
    {
        RaceFindings found;
        found.lines = 5;
        found.visible = 2;
        found.wrongVisible = 1;
        found.outside = 1;
        found.mostOff = 0.1;
        found.byFault[std::size_t(Fault::Lost)] = 1;
        found.first.push_back({Fault::Lost,
                               {{{0.1, 1e-300}, {-0.0, 3}}, {{1, 2}, {3, 4}}},
                               {{1, 2, std::numeric_limits<double>::quiet_NaN(), 4}, 1, 0}});
        const auto back = raceFindingsOf(jsonOf(found));
        QVERIFY(back.has_value());
        QCOMPARE(jsonOf(*back), jsonOf(found));
        QCOMPARE(back->wrong(), 1u);
        for (const char* bad : {"", "0.5", "{}", R"({"checked":1,"faults":[1]})"})
            QVERIFY(!raceFindingsOf(bad).has_value());
    }

    void everySignalHasAName()
    {
        QCOMPARE(signalName(SIGXFSZ), "SIGXFSZ");
        QCOMPARE(signalName(SIGSEGV), "SIGSEGV");
        std::set<QString> names;
        for (int signal = 1; signal < NSIG; ++signal) {
            names.insert(signalName(signal));
            QVERIFY2(signalName(signal).startsWith("SIG") && signalName(signal).size() > 5,
                     qPrintable(signalName(signal)));
            QVERIFY2(signalText(signal).contains(signalName(signal)),
                     qPrintable(signalText(signal)));
        }
        QCOMPARE(int(names.size()), NSIG - 1);
    }

    /// Rounding in ulps, and what cannot be rounding in the coordinates' own unit.
    void errorsCanBeRead()
    {
        const auto text = [](double off) {
            Finding one{Fault::Off, 0, {{{0, 0}, {200, 100}}, {{-50, -50}, {50, 50}}}, {}, {}};
            one.ulps = off / app::ulpFor(one.question.line, one.question.window);
            return errorText(one);
        };
        QCOMPARE(text(0), "");
        QCOMPARE(text(3 * 0x1p-45), "3 ulps");
        QCOMPARE(text(65 * 0x1p-45), "65 ulps");
        QCOMPARE(text(84.6), "84.6 units");
        QCOMPARE(text(std::numeric_limits<double>::infinity()), "infinitely far");
        const auto verdict = verdictOn(caseOf("outside")); // by half a window
        const Table terminal = findingTable(verdict, Reader::Terminal);
        QCOMPARE(terminal.names.back(), "error");
        for (const QStringList& row : terminal.rows)
            QVERIFY2(row.back().endsWith(" units"), qPrintable(row.back()));
        QVERIFY2(!terminal.rows[0].back().contains('e'), qPrintable(terminal.rows[0].back()));
        const Table file = findingTable(verdict);
        QVERIFY(file.names.endsWith("distance") && file.names.contains("ulps"));
    }

    void theStricterContractLooksAtEveryBit()
    {
        auto which = caseOf("example");
        which.contract.strictness = Strictness::Clearcuts;
        const auto verdict = verdictOn(which);
        QVERIFY(verdictOn(caseOf("example")).outside() > 0);
        QCOMPARE(verdict.fault(), Fault::Outside);
    }

    void theSeedChangesTheLines()
    {
        auto other = caseOf("single");
        other.seed = 2;
        const auto one = verdictOn(caseOf("single")), two = verdictOn(other);
        QVERIFY(one.findings.front().question.line != two.findings.front().question.line);
        QVERIFY(verdictOn(other).findings.front().question.line
                == two.findings.front().question.line);
    }

    /// Times are not judged here: only that everybody was timed, and was right.
    void everyRowIsRaced()
    {
        auto which = caseOf("example");
        which.race = Case::Race::Yes;
        const auto verdict = verdictOn(which);
        QVERIFY2(verdict.times.has_value(), qPrintable(verdict.noTimes));
        const auto& contenders = verdict.times->contenders;
        QCOMPARE(contenders.size(), clipping::algorithms().size() + 1);
        QCOMPARE(contenders.front().key, ownKey);
        for (const Contender& one : contenders) {
            QCOMPARE(one.found.visible, contenders.front().found.visible);
            QCOMPARE(one.found.lost + one.found.shown, 0u);
            QVERIFY(one.times.size() == app::usualRounds(contenders.size())
                    && one.times.front() > 0);
            QVERIFY(one.byClass.front() > 0 && one.byClass.back() > 0);
        }
        QCOMPARE(raceTable(*verdict.times).rows.size(), contenders.size());
        QCOMPARE(classTable(*verdict.times).rows.size(), contenders.size());
    }

    void timesGoThroughThePipeUnchanged()
    {
        Times times{{{"yours", {3, 4}, {1, 2, 3, 4}, {5, 6, 7, 0}}, {"exact", {1, 2}, {}, {}}},
                    {0.25, 0.25, 0.25, 0.25},
                    {{"seed", "1"}}};
        const auto back = timesOf(jsonOf(times));
        QVERIFY(back.has_value());
        QCOMPARE(jsonOf(*back), jsonOf(times));
        QCOMPARE(ratioOf(*back, 1), 3.5 / 1.5);
        for (const char* bad :
             {"", "{}", "0.5", "[1]", R"({"contenders":[{},{}]})",
              R"({"contenders":[{"key":"yours","times":[1]},{"key":"lb","times":[1]}]})"})
            QVERIFY(!timesOf(bad).has_value());
    }

    void itCanBeStopped()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!judge(caseOf("slow"), {stop.get_token(), {}}).has_value());
    }

    /// The one command in the head of the example.
    void theExampleIsCompiledAsItSays()
    {
        QTemporaryDir folder;
        const auto written = writeExample(folder.path(), Existing::Keep);
        QVERIFY2(written.value.has_value(), qPrintable(written.error));
        for (const char* name : {"example", "skeleton"}) {
            QFile example(folder.filePath(name + QString(".c")));
            QVERIFY(example.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(example.readAll());
            const QString line = text.section("*   cc ", 1).section(" &&", 0, 0);
            QVERIFY(line.contains("-shared"));
            QProcess compiler;
            compiler.setWorkingDirectory(folder.path());
            compiler.start("cc", QProcess::splitCommand(line + " -Wall -Wextra -Werror"));
            if (!compiler.waitForFinished(60'000) || compiler.error() == QProcess::FailedToStart)
                QSKIP("there is no cc here");
            QVERIFY2(compiler.exitCode() == 0, compiler.readAllStandardError().constData());
            auto which = caseOf("example");
            which.library = folder.filePath(name + QString(".so"));
            const auto verdict = verdictOn(which);
            QVERIFY(!verdict.unusable);
            QCOMPARE(verdict.passed(), name == QByteArray("example"));
        }
        QVERIFY(!writeExample("/nowhere/at/all", Existing::Keep).value);
    }

    void changedSkeletonsAreKept()
    {
        QTemporaryDir folder;
        QVERIFY(writeExample(folder.path(), Existing::Keep).value);
        QCOMPARE(writeExample(folder.path(), Existing::Keep).value->kept, QStringList());
        QFile mine(folder.filePath("skeleton.c"));
        QVERIFY(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
        mine.close();
        const auto again = writeExample(folder.path(), Existing::Keep);
        QCOMPARE(again.value->kept, QStringList{mine.fileName()});
        QCOMPARE(again.value->written.size(), exampleNames().size() - 1);
        QCOMPARE(QFileInfo(mine).size(), 4);
        QVERIFY(writeExample(folder.path(), Existing::Replace).value->kept.isEmpty());
        QVERIFY(QFileInfo(mine).size() > 4);
    }
};

} // namespace judge_judge_test

TEST_CLASS(judge_judge_test::JudgeTest, Gui)
#include "tests/app/judge/judge_test.moc"

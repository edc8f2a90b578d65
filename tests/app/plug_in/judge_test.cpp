// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plug_in/example_files.h"
#include "app/plug_in/judge.h"

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/sanitizer.h"

using namespace app::plug_in;

namespace {

QString pathOf(const QString& sample) { return QStringLiteral(PLUG_INS "/%1.so").arg(sample); }

Case caseOf(const QString& sample)
{
    return {.library = pathOf(sample),
            .program = CLEARCUT_BINARY,
            .randomLines = 2000,
            .race = Case::Race::No};
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

    void wrongOnesAreCaughtForTheRightReason_data()
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
    }
    void wrongOnesAreCaughtForTheRightReason()
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
        QElapsedTimer taken;
        taken.start();
        const auto verdict = verdictOn(caseOf("endless_loop"));
        QVERIFY(taken.elapsed() < 60'000); // some seconds, on any machine
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

    void nothingThatItStartedIsLeft()
    {
        const auto verdict = verdictOn(caseOf("forking"));
        QCOMPARE(verdict.fault(), Fault::Crashed);
        const int left = verdict.printed.section('\n', 0, 0).toInt();
        QVERIFY2(left > 0, qPrintable(verdict.printed));
        // It is gone, or nobody has asked yet how it ended.
        const auto gone = [left] {
            QFile stat(QStringLiteral("/proc/%1/stat").arg(left));
            return !stat.open(QIODevice::ReadOnly) || stat.readAll().contains(") Z ");
        };
        QTRY_VERIFY(gone());
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

    void whatCannotBeUsedSaysWhy_data()
    {
        QTest::addColumn<Unusable>("why");
        QTest::addColumn<QString>("words");
        QTest::newRow("nobody") << Unusable::NoFile << "There is no file";
        QTest::newRow("not_a_plug_in") << Unusable::NoFunction << "no function clearcut_clip";
        QTest::newRow("of_tomorrow") << Unusable::OtherVersion << "made for version 2";
        QTest::newRow("crash_while_loading") << Unusable::Broken << "SIGABRT";
    }
    void whatCannotBeUsedSaysWhy()
    {
        QFETCH(Unusable, why);
        QFETCH(QString, words);
        const auto verdict = verdictOn(caseOf(QTest::currentDataTag()));
        QCOMPARE(verdict.unusable, why);
        QVERIFY2(sentence(verdict).contains(words), qPrintable(sentence(verdict)));
        QVERIFY(!verdict.passed());
    }

    void whatIsNoLibraryIsNotLoadable()
    {
        auto which = caseOf("any");
        which.library = QStringLiteral(SOURCE_DIR "/README.md");
        const auto verdict = verdictOn(which);
        QCOMPARE(verdict.unusable, Unusable::NotLoadable);
        QVERIFY2(verdict.more.contains("invalid ELF header"), qPrintable(verdict.more));
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

    void whatTakesTooLongIsNotCalledWrong()
    {
        auto which = caseOf("example");
        which.seconds = 0;
        const auto verdict = verdictOn(which);
        QCOMPARE(verdict.wrong(), 0u);
        QVERIFY(!verdict.passed());
        QVERIFY2(sentence(verdict).startsWith("Too slow"), qPrintable(sentence(verdict)));
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
            QVERIFY(one.times.size() == 10 && one.times.front() > 0);
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
        const auto written = writeExample(folder.path());
        QVERIFY2(written.value.has_value(), qPrintable(written.error));
        QFile example(folder.filePath("example.c"));
        QVERIFY(example.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(example.readAll());
        const QString line = text.section("*   cc ", 1).section(" &&", 0, 0);
        QVERIFY(line.contains("-shared"));
        QProcess compiler;
        compiler.setWorkingDirectory(folder.path());
        compiler.start("cc", QProcess::splitCommand(line));
        if (!compiler.waitForFinished(60'000) || compiler.error() == QProcess::FailedToStart)
            QSKIP("there is no cc here");
        QCOMPARE(compiler.exitCode(), 0);
        auto which = caseOf("example");
        which.library = folder.filePath("example.so");
        QVERIFY(verdictOn(which).passed());
        QVERIFY(!writeExample("/nowhere/at/all").value);
    }
};

QTEST_MAIN(JudgeTest)
#include "judge_test.moc"

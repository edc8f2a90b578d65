// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/category.h"
#include "app/judge/points.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_judge_test {

/// `clearcut judge`, as people call it.
class JudgeCommandTest : public QObject {
    Q_OBJECT

    static QString sample(const char* name)
    {
        return QStringLiteral(PLUG_INS "/%1.so").arg(QLatin1StringView(name));
    }

private slots:
    void passingLibraryExitsWith0()
    {
        const auto run = clearcut({"judge", sample("example")});
        QCOMPARE(run.err, "");
        QCOMPARE(run.code, 0);
        QVERIFY2(run.out.contains("Passed: Liang-Barsky, the example"), run.out.constData());
        QVERIFY(run.out.contains("Race on the paper's scene"));
    }

    void wrongLibraryExitsWith3()
    {
        const auto run = clearcut({"judge", sample("lost_corner"), "--no-race"});
        QCOMPARE(run.code, 3);
        QVERIFY2(run.out.contains("loses visible lines"), run.out.constData());
        QVERIFY(!run.out.contains("Race"));
    }

    void theVerdictIsFirstAndLastAndFitsATerminal()
    {
        for (const QStringList& more : {QStringList{"--no-race"}, QStringList{}}) {
            const char* library = more.isEmpty() ? "example" : "lost_corner";
            const auto run = clearcut(QStringList{"judge", sample(library)} + more);
            const QString out = QString::fromUtf8(run.out);
            const QString verdict = out.section("\n\n", 0, 0) + '\n';
            QVERIFY2(verdict.startsWith("Passed: ") || verdict.startsWith("Wrong: "),
                     qPrintable(out));
            QVERIFY2(out.endsWith("\n\n" + verdict), qPrintable(out));
            for (const QString& line : out.split('\n'))
                QVERIFY2(line.size() <= 80, qPrintable(line));
        }
        QCOMPARE(QJsonDocument::fromJson(
                     clearcut({"judge", sample("lost_corner"), "--no-race", "-f", "json"}).out)
                     .array()
                     .size(),
                 3);
    }

    void unloadableLibraryExitsWith1()
    {
        for (const char* name : {"not_a_plug_in", "of_tomorrow", "nobody", "crash_while_loading"}) {
            const auto run = clearcut({"judge", sample(name)});
            QCOMPARE(run.code, 1);
            QCOMPARE(run.out, "");
            QVERIFY2(run.err.startsWith("clearcut judge: ") && run.err.count('\n') == 1,
                     run.err.constData());
        }
    }

    void jsonHoldsTheVerdict()
    {
        const auto run =
            clearcut({"judge", sample("crash"), "--format", "json", "--seed", "3", "--no-race"});
        QCOMPARE(run.code, 3);
        const auto tables = QJsonDocument::fromJson(run.out).array();
        QCOMPARE(tables.size(), 3);
        const auto verdict = tables[0]["rows"][0].toObject();
        QCOMPARE(verdict["outcome"].toString(), "wrong");
        QCOMPARE(verdict["fault"].toString(), "crashed");
        QVERIFY(verdict["judged"].toInt() < verdict["lines"].toInt());
        QCOMPARE(tables[2]["rows"][0]["category"].toString(), "regions");
        QVERIFY(tables[2]["rows"][0]["got"].toString().contains("SIGSEGV"));
    }

    void errorInTheRaceExitsWith3()
    {
        const auto run = clearcut({"judge", sample("race_cheat")});
        QCOMPARE(run.code, 3);
        QVERIFY2(run.out.startsWith("Wrong: ") && run.out.contains("In the race ("),
                 run.out.constData());
    }

    void sourceCodeExitsWith1AndTheCompilerCommand()
    {
        const auto run = clearcut({"judge", SOURCE_DIR "/resources/plug_in/example.c"});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("compile it first. cc -std=c99 -O2 -shared -fPIC -o "),
                 run.err.constData());
    }

    void theTimeIsABudget()
    {
        const auto run = clearcut({"judge", sample("sleepy"), "--seconds", "1"});
        QCOMPARE(run.code, 3);
        QVERIFY2(run.out.startsWith("Too slow: ")
                     && run.out.simplified().contains("tested within 1 s"),
                 run.out.constData());
        QCOMPARE(clearcut({"judge", sample("sleepy"), "--seconds", "0"}).code, 2);
    }

    void pointsAreInTheJson()
    {
        const auto run =
            clearcut({"judge", sample("finite_only"), "--no-race", "--format", "json"});
        const auto tables = QJsonDocument::fromJson(run.out).array();
        const auto verdict = tables[0]["rows"][0].toObject();
        const auto categories = app::plug_in::categories().size() - 1; // without the race
        QCOMPARE(verdict["most_points"].toInt(), app::plug_in::fullPoints * int(categories));
        int points = 0;
        for (const QJsonValue row : tables[1]["rows"].toArray()) {
            points += row["points"].toInt();
            QCOMPARE(row["degree"].toString() == "right", row["category"].toString() != "nonsense");
        }
        QCOMPARE(verdict["points"].toInt(), points);
        QVERIFY(tables[2]["rows"][0].toObject().contains("ulps"));
    }

    void strictIsStricter()
    {
        QCOMPARE(clearcut({"judge", sample("example"), "--no-race", "--strict"}).code, 3);
        QCOMPARE(clearcut({"judge", sample("example"), "--no-race"}).code, 0);
    }

    void theExampleIsWritten()
    {
        QTemporaryDir folder;
        QCOMPARE(clearcut({"judge", "--save-example", folder.path()}).code, 0);
        for (const char* name : {"example.c", "skeleton.c"})
            QVERIFY(contentOf(folder.filePath(name)).contains("int clearcut_clip(const double "));
        QVERIFY(
            contentOf(folder.filePath("clearcut_algorithm.h")).contains("CLEARCUT_ABI_VERSION"));
        QCOMPARE(clearcut({"judge", "--save-example", "/nowhere/at/all"}).code, 1);
    }

    /// The internal command alone loads libraries.
    void theChildSaysWhatItIs()
    {
        const auto run = clearcut({"judge-child", "answer", sample("not_a_plug_in")});
        QCOMPARE(run.out.split('\n').value(1), "no-function "); // after its number
        QVERIFY(run.out.split('\n').front().toInt() > 0);
        QVERIFY(clearcut({"judge-child", "answer", "/nowhere.so"}).out.contains("\nnot-loadable "));
        QVERIFY(!clearcut({"--help"}).out.contains("judge-child"));
    }
};

} // namespace command_line_judge_test

TEST_CLASS(command_line_judge_test::JudgeCommandTest, Gui)
#include "tests/app/command_line/judge_test.moc"

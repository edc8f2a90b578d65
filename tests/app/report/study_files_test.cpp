// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_plan.h"
#include "app/report/study_files.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace report_study_files_test {

namespace {

app::Study smallStudy()
{
    for (const app::Command& command : app::commands())
        if (command.key == "bench") {
            const app::ParsedArguments given{
                command, {"--paper", "table1", "--lines", "100", "--runs", "2"}};
            return *app::study(
                app::parsedPlan(given, app::parsedWanted(given, QStringLiteral("clip"))));
        }
    qFatal("no bench");
}

} // namespace

class StudyFilesTest : public QObject {
    Q_OBJECT

private slots:
    void itWritesTheFilesThatItNames()
    {
        const app::Study study = smallStudy();
        for (const app::StudyFile& row : notEmpty(app::studyFiles())) {
            const QTemporaryDir folder;
            const QString path = folder.filePath("out." + row.ending);
            const auto written = row.write(study, path, {});
            QVERIFY2(written, qPrintable(written.error));
            QCOMPARE(*written.value, row.paths(study, path));
            for (const QString& file : *written.value)
                QVERIFY2(QFile::exists(file), qPrintable(file));
        }
    }
    void aStopRequestLeavesOutTheOtherFiles()
    {
        const app::Study study = smallStudy();
        std::stop_source stop;
        stop.request_stop();
        for (const app::StudyFile& row : notEmpty(app::studyFiles())) {
            const QTemporaryDir folder;
            const auto written =
                row.write(study, folder.filePath("out." + row.ending), stop.get_token());
            QVERIFY(written && written.value->isEmpty());
            QVERIFY(QDir(folder.path()).isEmpty());
        }
    }
};

} // namespace report_study_files_test

TEST_CLASS(report_study_files_test::StudyFilesTest, Gui)
#include "tests/app/report/study_files_test.moc"

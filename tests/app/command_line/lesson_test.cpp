// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_lesson_test {

/// `clearcut lesson`, as people call it.
class LessonTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    void checkNamesFileLineAndFault()
    {
        const QByteArray good =
            "# T\n:: look cs line -160,-30 70,130 window -100,-75 100,75\nText.\n";
        writeText(folder_.filePath("good.md"), good + ":: ask part\n");
        writeText(folder_.filePath("bad.md"),
                  QByteArray(good).replace("70,130", "0,0") + ":: ask part\n");
        const auto run = clearcut({"lesson", "check", folder_.path()});
        QCOMPARE(run.code, 3);
        QCOMPARE(run.err, "");
        QCOMPARE(run.out, folder_.filePath("bad.md").toUtf8()
                              + ":4: “:: ask part” needs a line that the window cuts twice.\n"
                              + folder_.filePath("good.md").toUtf8()
                              + ": no fault (pages: 1, questions: 1).\n");
        QCOMPARE(clearcut({"lesson", "check", folder_.filePath("good.md"),
                           SOURCE_DIR "/resources/lessons"})
                     .code,
                 0);
    }
    void exportWritesOnePage()
    {
        const QString page = folder_.filePath("page.html");
        QCOMPARE(clearcut({"lesson", "export", "outcodes", "-o", page}).code, 0);
        const auto printed = clearcut(
            {"lesson", "export", "-f", "html", SOURCE_DIR "/resources/lessons/outcodes.md"});
        QCOMPARE(printed.code, 0);
        QVERIFY(printed.out.startsWith("<!DOCTYPE html>") && printed.out.size() < 300'000);
        QCOMPARE(contentOf(page), printed.out);
        const auto none = clearcut({"lesson", "export", "nothing"});
        QCOMPARE(none.code, 1);
        QVERIFY2(none.err.contains("or one of why-clip, outcodes, "), none.err);
        for (const char* name : {"2", "outcodes"})
            QCOMPARE(clearcut({"lesson", "export", name}).out,
                     clearcut({"lesson", "export", "outcodes"}).out);
        QCOMPARE(clearcut({"lesson", "export", "outcodes", "-o", "/nowhere/x.html"}).code, 1);
        QCOMPARE(clearcut({"lesson", "play", "outcodes"}).code, 2);
        QCOMPARE(clearcut({"lesson", "check"}).code, 2);
    }
};

} // namespace command_line_lesson_test

TEST_CLASS(command_line_lesson_test::LessonTest, Core)
#include "tests/app/command_line/lesson_test.moc"

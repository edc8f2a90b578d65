// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_places.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace lessons_lesson_places_test {

using namespace app;

class LessonPlacesTest : public QObject {
    Q_OBJECT

private slots:
    /// The folder in it may be on a medium that is not mounted now.
    void aForgottenFolderTakesItsFilesButNoFolder()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
        const QString all = folder.filePath("all"), inIt = all + "/usb", beside = all + "-2/b.md";
        keepLessonPlaces(settings, {all + "/a.md", inIt, all, all + "/B.MD", beside});
        QCOMPARE(lessonPlaces(settings).size(), 5);
        forgetLessonPlace(settings, all);
        QCOMPARE(lessonPlaces(settings), QStringList({inIt, beside}));
    }
    void theLastTwelveAreKeptAndNothingElseIsRead()
    {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
        settings.setValue("lessons/opened", QStringList{"relative.md", "/" + QString(5000, 'x')});
        QCOMPARE(lessonPlaces(settings), QStringList());
        QStringList paths;
        for (int i = 0; i < 20; ++i)
            paths << QString("/l/%1.md").arg(i);
        keepLessonPlaces(settings, paths + QStringList{"/l/./15.md"});
        QCOMPARE(lessonPlaces(settings), paths.mid(8, 7) + paths.last(4) + QStringList{"/l/15.md"});
    }
};

} // namespace lessons_lesson_places_test

TEST_CLASS(lessons_lesson_places_test::LessonPlacesTest, Core)
#include "tests/app/lessons/lesson_places_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/opened_lessons.h"
#include "ui/lessons/lesson_panel.h"

#include <QAbstractButton>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_opened_lessons_test {

using namespace ui;

namespace {

const QByteArray lessonText =
    "# Own & only\n> Sentence.\n:: look cs line -160,-30 70,130 window -100,-75 100,75\n"
    "Text.\n:: ask part\nTold.\n";

/// A window, and a folder with a lesson and with a file that is none.
struct School : TestWindow {
    QTemporaryDir folder;

    School()
    {
        answers->answer = Questions::Answer::DontSave;
        write("a.md", lessonText);
        write("b.md", "nothing");
        show();
    }
    void write(const QString& name, const QByteArray& text) const
    {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write");
    }
    app::Course& course() const { return window->session().course; }
    LessonPanel* lessons() const { return window->findChild<LessonPanel*>(); }
    QAbstractButton* lessonButton() const
    {
        for (auto* button : lessons()->findChildren<QAbstractButton*>())
            if (button->text() == "1  Own & only" && button->isVisible())
                return button;
        return nullptr;
    }
    bool says(const QString& text) const
    {
        const auto labels = lessons()->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
    /// Whether the list shows the folder's lesson and what is wrong with the other file.
    bool showsFolder() const
    {
        return lessons() && lessonButton() && says(QDir(folder.path()).dirName())
               && says("b.md:1: ");
    }
};

} // namespace

class OpenedLessonsTest : public QObject {
    Q_OBJECT

private slots:
    void aFolderIsOpenedByTheMenu()
    {
        School school;
        school.answers->directory = school.folder.path();
        school.run("open-lessons");
        QTRY_VERIFY(school.showsFolder());
        school.lessonButton()->click();
        QCOMPARE(school.course().lesson()->title, "Own & only");
        QVERIFY(school.course().asks());
        school.course().choose(school.course().question()->right);
        QVERIFY(school.course().atEnd());
        QVERIFY(school.says("Passed") || school.says("Not passed"));
        QVERIFY(school.says("Lesson 1"));
        const QString key = school.course().lesson()->key;
        QCOMPARE(QSettings().value("lessons/right/" + key).toInt(), 1);
    }
    void aFolderIsDropped()
    {
        const School school;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(school.folder.path())});
        QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(school.window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(school.window.get(), &event);
        QVERIFY(event.isAccepted());
        QTRY_VERIFY(school.showsFolder());
    }
    void filesAreOpened()
    {
        School school;
        school.answers->lessons = {school.folder.filePath("a.md"), school.folder.filePath("b.md")};
        school.run("open-lesson-files");
        QTRY_VERIFY(school.showsFolder());
    }
    void theNextRunHasTheLessons()
    {
        const School school;
        QVERIFY(QDir(school.folder.path()).mkdir("again"));
        const QString folder = school.folder.filePath("again");
        school.write("again/a.md", QByteArray(lessonText).replace("Own & only", "Again"));
        QSettings().setValue("lessons/opened",
                             QStringList{"/nowhere", "relative", folder, QString(9000, u'x')});
        school.window->showLessons();
        QTRY_VERIFY(school.says("again"));
        QVERIFY(!school.says("nowhere"));
        school.window->openLessons({school.folder.path()});
        QTRY_VERIFY(school.showsFolder());
        QCOMPARE(QSettings().value("lessons/opened").toStringList(),
                 QStringList({"/nowhere", folder, school.folder.path()}));
    }
    void aFolderIsTakenOutOfTheList()
    {
        const School school;
        school.window->openLessons({school.folder.path()});
        QTRY_VERIFY(school.showsFolder());
        const auto others = app::openedLessons().size() - 1;
        QVERIFY(QSettings().value("lessons/opened").toStringList().contains(school.folder.path()));
        const auto folders = school.lessons()->findChildren<QAbstractButton*>("close-folder");
        const auto name = QDir(school.folder.path()).dirName();
        const auto close = std::ranges::find_if(folders, [&](const QAbstractButton* button) {
            return button->toolTip().contains(name);
        });
        QVERIFY(close != folders.end());
        (*close)->click();
        QTRY_COMPARE(app::openedLessons().size(), others);
        QVERIFY(!school.says(name));
        QVERIFY(!QSettings().value("lessons/opened").toStringList().contains(school.folder.path()));
        QVERIFY(QFile::exists(school.folder.filePath("a.md")));
        school.window->openLessons({school.folder.path()});
        QTRY_VERIFY(school.showsFolder());
    }
    void nothingChosenChangesNothing()
    {
        School school;
        const int before = app::lessonOpenings();
        school.run("open-lessons");
        school.run("open-lesson-files");
        QCoreApplication::processEvents();
        QVERIFY(!school.window->showsLessons());
        QCOMPARE(app::lessonOpenings(), before);
    }
    void aListThatIsOpenGetsTheLessons()
    {
        School school;
        school.window->showLessons();
        school.window->openLessons({school.folder.path()});
        QTRY_VERIFY(school.showsFolder());
        school.write("c.md", QByteArray(lessonText).replace("Own & only", "Third"));
        school.window->openLessons({school.folder.path()});
        QTRY_VERIFY(app::openedLessons().back().lessons.size() == 2 && school.showsFolder());
    }
};

} // namespace lessons_opened_lessons_test

TEST_CLASS(lessons_opened_lessons_test::OpenedLessonsTest, Widgets)
#include "tests/ui/lessons/opened_lessons_test.moc"

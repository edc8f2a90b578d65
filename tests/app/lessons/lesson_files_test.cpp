// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"
#include "app/lessons/opened_lessons.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace lessons_lesson_files_test {

namespace {

const QByteArray good =
    "# Title\n> Sentence.\n:: version 1\n"
    ":: look cs line -160,-30 70,130 window -100,-75 100,75\nText.\n:: ask part\n";

struct Folder {
    QTemporaryDir at;

    QString path(const QString& name) const { return at.filePath(name); }
    QString write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write");
        return path(name);
    }
};

app::LessonFile readOne(const QString& path)
{
    auto files = app::readLessonFiles({path});
    return files.size() == 1 ? files.front() : app::LessonFile{.path = QStringLiteral("several")};
}

} // namespace

class LessonFilesTest : public QObject {
    Q_OBJECT

private slots:
    void aFolderIsReadInTheOrderOfItsNames()
    {
        const Folder folder;
        for (const char* name : {"b.md", "a.md", "README.md", "notes.txt", ".hidden.md"})
            folder.write(QString::fromUtf8(name), good);
        const auto files = app::readLessonFiles({folder.at.path()});
        QCOMPARE(files.size(), std::size_t(2));
        QVERIFY(files[0].path.endsWith("/a.md") && files[1].path.endsWith("/b.md"));
        QVERIFY(files[0].lesson && files[0].faults.empty());
        QCOMPARE(files[0].lesson->title, "Title");
    }
    void aFaultHasNameAndLine()
    {
        const Folder folder;
        const auto file = readOne(folder.write("lesson.md", good + "---\nMore.\n:: dance\n"));
        QVERIFY(!file.lesson);
        QCOMPARE(file.sentences().size(), 1);
        QVERIFY2(file.sentences()[0].contains("/lesson.md:9: “:: dance” is no instruction."),
                 qPrintable(file.sentences()[0]));
    }
    void hostileFilesAreOneSentence_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("part");
        QTest::newRow("binary") << QByteArray("\x7f"
                                              "ELF\0\1\2",
                                              7)
                                << "no text in UTF-8";
        QTest::newRow("nul") << good + QByteArray("\0", 1) << "no text in UTF-8";
        QTest::newRow("latin-1") << good + "caf\xe9"
                                 << "no text in UTF-8";
        QTest::newRow("empty") << QByteArray() << "This is no lesson";
        QTest::newRow("large") << QByteArray(1'000'001, 'x') << "at most 1,000 kB";
        QTest::newRow("version") << ":: version 7\n" + good << "version 7";
        QTest::newRow("next") << good + ":: next lesson.md\n"
                              << "“:: next” is no instruction";
        QTest::newRow("include") << good + ":: include lesson.md\n"
                                 << "“:: include” is no";
    }
    void hostileFilesAreOneSentence()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, part);
        const Folder folder;
        const auto file = readOne(folder.write("lesson.md", bytes));
        QVERIFY(!file.lesson);
        QVERIFY2(file.sentences().join(u' ').contains(part),
                 qPrintable(file.sentences().join(u' ')));
    }
    void hostilePlacesAreOneSentence()
    {
        const Folder folder;
        const auto refused = [](const QString& path, const char* part) {
            const auto file = readOne(path);
            return !file.lesson && file.sentences().size() == 1
                   && file.sentences()[0].contains(part);
        };
        QVERIFY(refused(folder.path("none.md"), "no such file"));
        QCOMPARE(::symlink("loop.md", QFile::encodeName(folder.path("loop.md"))), 0);
        QVERIFY(refused(folder.path("loop.md"), "leads nowhere"));
        QCOMPARE(::mkfifo(QFile::encodeName(folder.path("pipe.md")), 0600), 0);
        QVERIFY(refused(folder.path("pipe.md"), "neither a file nor a folder"));
        QCOMPARE(::symlink("/dev/zero", QFile::encodeName(folder.path("zero.md"))), 0);
        QVERIFY(refused(folder.path("zero.md"), "neither a file nor a folder"));
        QFile sparse(folder.path("sparse.md"));
        QVERIFY(sparse.open(QIODevice::WriteOnly) && sparse.resize(100'000'000));
        QVERIFY(refused(folder.path("sparse.md"), "at most 1,000 kB"));
        QVERIFY(QDir(folder.at.path()).mkdir("empty"));
        QVERIFY(refused(folder.path("empty"), "no lesson"));
        // All of them in one folder, with one good lesson, which is not lost.
        QCOMPARE(::symlink(".", QFile::encodeName(folder.path("same.md"))), 0);
        folder.write("good.md", good);
        const auto files = app::readLessonFiles({folder.at.path()});
        QCOMPARE(std::ranges::count_if(files, [](const auto& f) { return f.lesson.has_value(); }),
                 1);
        for (const auto& file : files)
            QVERIFY2(file.lesson.has_value() != (file.faults.size() == 1), qPrintable(file.path));
    }
    void aPictureLiesBesideTheFile()
    {
        const Folder folder;
        const auto with = [&](const char* name) {
            return readOne(folder.write(
                "lesson.md",
                QByteArray(good).replace("Text.", QByteArray(":: picture ") + name + "\nText.")));
        };
        QImage image(40, 30, QImage::Format_RGB32);
        image.fill(Qt::red);
        QVERIFY(image.save(folder.path("a picture.png")));
        const auto right = with("a picture.png");
        QVERIFY(right.lesson && right.faults.empty());
        QCOMPARE(right.lesson->pages[0].picture, folder.path("a picture.png"));
        folder.write("fake.png", "not a picture");
        for (const char* bad : {"missing.png", "fake.png", "../x.png", "/dev/zero", "nothing"}) {
            const auto file = with(bad);
            QVERIFY2(file.lesson && file.lesson->pages[0].picture.isEmpty(), bad);
            QCOMPARE(file.faults.size(), std::size_t(1));
            QCOMPARE(file.faults[0].line, 5);
        }
    }
    // Results stay when the text is mended or the file moves, and are never another lesson's.
    void resultsBelongToTitleAndQuestions()
    {
        const Folder folder;
        const auto key = [&](const QString& name, const QByteArray& text) {
            return readOne(folder.write(name, text)).lesson.value_or(app::Lesson{}).key;
        };
        const QString first = key("a.md", good);
        QVERIFY(first.startsWith("file-"));
        QCOMPARE(key("b.md", QByteArray(good).replace("Text.", "A better text.")), first);
        QVERIFY(key("c.md", QByteArray(good).replace("Title", "Other")) != first);
        QVERIFY(key("d.md", QByteArray(good).replace("130", "131")) != first);
        QVERIFY(key("e.md", QByteArray(good).replace("ask part", "ask visible")) != first);
        for (const app::Lesson& lesson : app::lessons())
            QVERIFY(!lesson.key.startsWith("file-"));
    }
    void openedLessonsStandUnderTheirFolder()
    {
        const Folder folder;
        folder.write("a.md", good);
        folder.write("b.md", QByteArray(good).replace("Title", "Second"));
        folder.write("c.md", "nothing");
        const auto first = app::addOpenedLessons(app::readLessonFiles({folder.at.path()}));
        QVERIFY(first);
        const app::LessonGroup& group = app::openedLessons().back();
        QCOMPARE(group.heading, QDir(folder.at.path()).dirName());
        QCOMPARE(group.lessons.size(), std::size_t(2));
        QCOMPARE(group.lessons[0], *first);
        QVERIFY(!group.notes.isEmpty() && group.notes[0].startsWith("c.md:1: "));
        QCOMPARE(app::lessonAt(*first)->title, "Title");
        QCOMPARE(app::lessonAfter(*first), std::optional(*first + 1));
        QCOMPARE(app::lessonAfter(*first + 1), std::nullopt);
        QCOMPARE(app::placeOfLesson(*first + 1), std::size_t(2));
        QCOMPARE(app::lessonAt(*first + 100), nullptr);
        // The same lesson again, changed while someone is in it.
        app::Microscope microscope;
        app::Course course(microscope);
        course.begin(*first);
        folder.write("a.md", QByteArray(good).replace("Title", "New title") + "---\nMore.\n");
        const auto again = app::addOpenedLessons(app::readLessonFiles({folder.path("a.md")}));
        QCOMPARE(app::openedLessons().back().lessons,
                 std::vector<std::size_t>({*again, *first + 1}));
        QCOMPARE(course.lesson()->title, "Title");
        QCOMPARE(course.pages(), std::size_t(1));
        course.begin(*again);
        QCOMPARE(course.lesson()->title, "New title");
        QVERIFY(course.asks());
    }
};

} // namespace lessons_lesson_files_test

TEST_CLASS(lessons_lesson_files_test::LessonFilesTest, Core)
#include "tests/app/lessons/lesson_files_test.moc"

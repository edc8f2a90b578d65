// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_page.h"
#include "ui/lessons/lesson_export.h"

#include <QAction>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_lesson_export_test {

using namespace ui;

/// The button of a lesson that exports it, without its file dialog.
class LessonExportTest : public QObject {
    Q_OBJECT

    TestWindow stage_;
    QTemporaryDir folder_;
    std::unique_ptr<LessonExport> exports_;
    PreparedAnswers* answers_ = nullptr;

    app::Course& course() { return stage_.window->session().course; }
    /// What is told of an export to a path; nothing: Kind::Done without a sentence.
    Message exported(const QString& path)
    {
        answers_->save = path;
        QSignalSpy told(exports_.get(), &LessonExport::told);
        exports_->ask();
        if (!QTest::qWaitFor([&] { return !exports_->busy(); }, 60000) || told.isEmpty())
            return {};
        return told.front().front().value<Message>();
    }

private slots:
    void initTestCase() { stage_.show(); }
    void init()
    {
        exports_ = std::make_unique<LessonExport>(*stage_.window, course());
        auto answers = std::make_unique<PreparedAnswers>(*stage_.window);
        answers_ = answers.get();
        exports_->setQuestions(std::move(answers));
        course().begin(1);
    }

    void thePageIsThatOfTheCommand()
    {
        const QString path = folder_.filePath("outcodes.html");
        QCOMPARE(exported(path).kind, Message::Kind::Done);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), *app::lessonHtml(app::lessons()[1]).value);
    }
    void theButtonOfTheLessonAsks()
    {
        stage_.window->showLessons();
        stage_.window->disconnect(SIGNAL(lessonExportWanted())); // which would open a dialog
        QSignalSpy wanted(stage_.window.get(), &MainWindow::lessonExportWanted);
        auto* button = stage_.window->findChild<QToolButton*>("export-lesson-button");
        QVERIFY(button && button->isVisible());
        button->click();
        QCOMPARE(wanted.count(), 1);
    }
    void cancellingWritesNothing() { QVERIFY(exported({}).sentence.isEmpty()); }
    void anUnwritableFileIsReported()
    {
        const QString path = folder_.filePath("none/page.html");
        const Message told = exported(path);
        QCOMPARE(told.kind, Message::Kind::Warning);
        QVERIFY2(told.sentence.startsWith("Cannot write " + path), qPrintable(told.sentence));
    }
    void thereIsNothingToExportWithoutALesson()
    {
        const auto* action = stage_.window->findChild<QAction*>("export-lesson");
        QVERIFY(action);
        QTRY_VERIFY(action->isEnabled());
        course().end();
        QTRY_VERIFY(!action->isEnabled());
        QVERIFY(exported(folder_.filePath("no.html")).sentence.isEmpty());
        QVERIFY(!QFile::exists(folder_.filePath("no.html")));
    }
};

} // namespace lessons_lesson_export_test

TEST_CLASS(lessons_lesson_export_test::LessonExportTest, Widgets)
#include "tests/ui/lessons/lesson_export_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/questions.h"

#include <QDir>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/formats/failing_disk.h"
#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace dialogs_questions_test {

using namespace ui;

namespace {

/// The text of the question's default button, which Return presses.
template <class Ask>
QString answeredByReturn(Ask ask)
{
    QString button = "no question";
    QTimer::singleShot(0, qApp, [&] {
        auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return;
        button = box->defaultButton()->text();
        QTest::keyClick(box->defaultButton(), Qt::Key_Return);
        if (box->isVisible()) // Return presses the default button
            box->defaultButton()->click();
    });
    ask();
    return button;
}

} // namespace

class QuestionsTest : public QObject {
    Q_OBJECT

private slots:
    // Return alone never confirms what cannot be undone.
    void returnNeverOverwrites()
    {
        QWidget window;
        Questions questions(window);
        bool answer = true;
        QCOMPARE(answeredByReturn([&] { answer = questions.overwriteFiles({"/a/b.svg"}, 2); }),
                 "Cancel");
        QVERIFY(!answer);
        auto changed = Questions::ChangedFile::Overwrite;
        QCOMPARE(answeredByReturn([&] { changed = questions.aboutChangedFile("/a/b.svg"); }),
                 "Cancel");
        QCOMPARE(changed, Questions::ChangedFile::Cancel);
        answer = true;
        QCOMPARE(answeredByReturn([&] { answer = questions.trustLibrary("/a/b.so"); }), "Cancel");
        QVERIFY(!answer);
    }

    void onlyWhatCanBeReadIsOffered()
    {
        QWidget window;
        Questions questions(window);
        QStringList filters;
        QTimer::singleShot(0, qApp, [&] {
            auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog) {
                filters = dialog->nameFilters();
                dialog->reject();
            }
        });
        QVERIFY(questions.fileToOpen(QDir::tempPath()).isEmpty());
        qsizetype read = 0;
        for (const app::Format& format : app::formats())
            read += format.read != nullptr;
        QCOMPARE(filters.size(), 1 + read);
        QVERIFY(filters[0].contains("*.svg") && filters[0].contains("*.csv"));
        QVERIFY(!filters.join(u' ').contains("*.pdf"));
    }

    void aFullDiskKeepsTheOldFileAndTheUnsavedMark()
    {
        TestWindow test;
        const QString file = test.twoLines();
        test.show();
        test.open(file);
        app::Session& session = test.window->session();
        const app::Shape line{
            {{{1, 2}, {{{3, 4}}}, false}}, {.stroke = app::Colour{}}, {}, 0, false};
        session.history.push(addShapes(session.document, {line}, "Draw line"));
        QVERIFY(test.window->isWindowModified());
        const auto read = [&] { return contentOf(file); };
        const QByteArray old = read();
        const QString other = test.path("other.svg");
        QVERIFY(!app::writeFile(test.window->session().now(), other));
        const auto size = std::size_t(QFileInfo(other).size());
        QVERIFY(size > 100 && QFile::remove(other));
        QString told;
        connect(&test.window->files(), &Files::told, this,
                [&](const Message& message) { told = message.sentence; });
        const auto refuses = [&](const QString& circumstances) {
            told.clear();
            const bool saved = test.saved();
            disk::state() = {};
            QVERIFY2(!saved && read() == old && test.window->isWindowModified()
                         && told.startsWith("Cannot write " + file),
                     qPrintable(circumstances + u' ' + told));
        };
        for (std::size_t room = 0; room < size && !QTest::currentTestFailed(); ++room) {
            const disk::Failing failing(disk::Step::Write, room);
            refuses(QStringLiteral("full at byte %1 of %2").arg(room).arg(size));
        }
        for (const auto step : {disk::Step::Sync, disk::Step::Rename}) {
            const disk::Failing failing(step);
            refuses(step == disk::Step::Sync ? "fsync" : "rename");
        }
        QVERIFY(test.saved());
        QVERIFY(!test.window->isWindowModified());
        QVERIFY(read() != old);
    }
};

} // namespace dialogs_questions_test

TEST_CLASS(dialogs_questions_test::QuestionsTest, Widgets)
#include "tests/ui/dialogs/questions_test.moc"

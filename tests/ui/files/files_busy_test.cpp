// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>

#include <sys/stat.h>

#include "tests/ui/files/busy_desk.h"

using namespace ui;

class FilesBusyTest : public QObject {
    Q_OBJECT

private slots:
    void aSecondSaveFollowsTheFirst()
    {
        const Desk desk;
        QSignalSpy saves(&desk.files(), &Files::recentChanged);
        disk::Slow slow;
        desk.type(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(slow.begun());
        desk.type(Qt::Key_S, Qt::ControlModifier);
        desk.type(Qt::Key_L); // the drawing waits too
        QCOMPARE(saves.count(), 0);
        QVERIFY(desk.window->canvas().tool() != "line" && desk.window->isWindowModified());
        slow.finish();
        QTRY_COMPARE(saves.count(), 2);
        QTRY_COMPARE(desk.window->canvas().tool(), std::string_view("line"));
        QVERIFY(!desk.window->isWindowModified());
        QCOMPARE(desk.savedWindow(), middle);
    }
    void aFileDroppedDuringASaveIsOpenedAfterIt()
    {
        const Desk desk;
        disk::Slow slow;
        desk.files().save();
        QTRY_VERIFY(slow.begun());
        desk.drop(desk.otherFile());
        QTest::qWait(20);
        QCOMPARE(desk.files().name(), "two.svg");
        slow.finish();
        QTRY_COMPARE(desk.files().name(), "other.svg");
        QCOMPARE(desk.answers->asked, 0); // nothing was unsaved any more
        QCOMPARE(desk.savedWindow(), middle);
    }
    void aFileThatIsOpenedDuringAnotherFollowsIt()
    {
        Desk desk;
        desk.answers->answer = Questions::Answer::DontSave;
        const QString pipe = desk.path("pipe.svg");
        QCOMPARE(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
        QSignalSpy loaded(&desk.session(), &app::Session::loaded);
        desk.files().open(pipe); // lasts until somebody writes to it
        desk.files().open(desk.otherFile());
        QTest::qWait(20);
        QCOMPARE(desk.files().name(), "two.svg");
        QFile feed(pipe);
        QVERIFY(feed.open(QIODevice::WriteOnly));
        feed.write("<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'/>");
        feed.close();
        QTRY_VERIFY(!desk.files().busy());
        QCOMPARE(loaded.count(), 2);
        QCOMPARE(desk.files().name(), "other.svg");
    }
    void cancellingAnOpenLeavesTheDrawing()
    {
        const Desk desk;
        desk.answers->answer = Questions::Answer::DontSave;
        const QString pipe = desk.path("pipe.svg");
        QCOMPARE(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
        desk.files().open(pipe);
        clickCancel();
        QTRY_VERIFY(!desk.files().busy());
        QCOMPARE(desk.files().name(), "two.svg");
        QCOMPARE(app::firstWindow(desk.session().now().windows()), middle);
        desk.answers->answer = Questions::Answer::Cancel;
        QVERIFY(desk.saved()); // although a thread still reads
        QFile feed(pipe);
        QVERIFY(feed.open(QIODevice::WriteOnly)); // it ends
    }
    void aCropIsThatOfTheDrawingItChanges()
    {
        const Desk desk;
        desk.files().crop();
        desk.change(small); // before the result arrives
        desk.files().wait();
        QCOMPARE(desk.session().scene.lines().size(), std::size_t(1));
        QCOMPARE(desk.session().scene.lines()[0], (clipping::Segment{{40, 50}, {60, 50}}));
        desk.session().history.undo();
        QCOMPARE(desk.session().scene.lines().size(), std::size_t(2));
    }
};

QTEST_MAIN(FilesBusyTest)
#include "files_busy_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_window.h"
#include "ui/files/files.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>

#include <sys/stat.h>

#include "tests/app/document/sheet.h"
#include "tests/ui/files/slow_disk.h"
#include "tests/ui/test_window.h"

using namespace ui;

namespace {

const clipping::Window middle{{25, 25}, {75, 75}}, small{{40, 40}, {60, 60}};

/// A window with a changed drawing of two lines, which is slow to save.
struct Desk : TestWindow {
    explicit Desk(const QString& drawing = {})
    {
        TestWindow::open(drawing.isEmpty() ? twoLines() : drawing);
        show();
        change(middle);
    }
    app::Session& session() const { return window->session(); }
    Files& files() const { return window->files(); }
    void change(const clipping::Window& clip) const
    {
        session().history.push(new app::SetWindow(session().document, clip));
    }
    /// As the system sends it.
    void type(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        QTest::keyClick(window->windowHandle(), key, with);
    }
    void drop(const QString& file) const
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window.get(), &enter);
        QDropEvent event(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window.get(), &event);
    }
    QString otherFile() const
    {
        return file("other.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' "
                                 "height='9mm'><path d='M0 0L5 5' stroke='#000'/></svg>");
    }
    clipping::Window savedWindow(const char* name = "two.svg") const
    {
        return app::sheetOf(app::readFile(path(name)).value->document).window;
    }
};

QWidget* waitingDialog()
{
    QWidget* modal = QApplication::activeModalWidget();
    return qobject_cast<WaitingDialog*>(modal);
}

void clickCancel()
{
    QTRY_VERIFY(waitingDialog());
    QTest::mouseClick(waitingDialog()->findChild<QPushButton*>(), Qt::LeftButton);
}

} // namespace

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
    void closingWaitsForTheSave()
    {
        const Desk desk;
        disk::Slow slow;
        desk.files().save();
        QTRY_VERIFY(slow.begun());
        QVERIFY(!desk.window->close());
        QVERIFY(!desk.window->close());
        QTest::qWait(20);
        QVERIFY(desk.window->isVisible());
        slow.finish();
        QTRY_VERIFY(!desk.window->isVisible());
        QCOMPARE(desk.answers->asked, 0);
        QCOMPARE(desk.savedWindow(), middle);
    }
    void theWindowStaysIfItCannotBeSaved()
    {
        const Desk desk;
        desk.answers->answer = Questions::Answer::Save;
        {
            disk::Slow slow;
            QVERIFY(!desk.window->close());
            QTRY_VERIFY(slow.begun());
            slow.fail();
            QTRY_VERIFY(desk.window->message().startsWith("Cannot write"));
        }
        QTRY_VERIFY(!desk.files().busy());
        QVERIFY(desk.window->isVisible() && desk.window->isWindowModified());
        QVERIFY(!desk.window->close());
        QTRY_VERIFY(!desk.window->isVisible());
        QCOMPARE(desk.answers->asked, 2);
        QCOMPARE(desk.savedWindow(), middle);
    }
    void destroyingTheWindowWaitsForTheSave()
    {
        Desk desk;
        const QString file = desk.path("two.svg");
        disk::Slow slow;
        desk.files().save();
        QTRY_VERIFY(slow.begun());
        std::thread later([&slow] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            slow.finish();
        });
        desk.window.reset();
        later.join();
        QCOMPARE(desk.savedWindow(), middle);
    }
    void aChangeDuringASaveIsUnsaved()
    {
        const Desk desk;
        disk::Slow slow;
        desk.files().save();
        QTRY_VERIFY(slow.begun());
        desk.change(small);
        slow.finish();
        desk.files().wait();
        QCOMPARE(desk.savedWindow(), middle);
        QVERIFY(desk.window->isWindowModified());
        QVERIFY(!desk.window->close());
        QCOMPARE(desk.answers->asked, 1);
        desk.session().history.undo();
        QVERIFY(!desk.window->isWindowModified());
    }
    void aCancelledSaveLeavesTheOldFile()
    {
        QByteArray many = "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'>";
        for (int i = 0; i < 5000; ++i) // more than what is written as a whole
            many += "<path stroke='#000' d='M" + QByteArray::number(i) + " 0L5 5'/>";
        TestWindow folder;
        const Desk desk(folder.file("two.svg", many + "</svg>"));
        const auto content = [&] {
            QFile file(desk.session().path());
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = content();
        disk::Slow slow;
        std::optional<bool> saved;
        desk.files().save([&](bool yes) { saved = yes; });
        clickCancel();
        QVERIFY(waitingDialog() && !saved);
        slow.finish();
        QTRY_COMPARE(saved, std::optional(false));
        QVERIFY(!waitingDialog() && content() == before);
        QVERIFY(desk.window->isWindowModified());
        QCOMPARE(desk.window->message(), "");
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
    void mayCloseAnswersOnce_data()
    {
        QTest::addColumn<bool>("changed");
        QTest::addColumn<int>("answer");
        QTest::addColumn<bool>("atOnce");
        QTest::addColumn<bool>("may");
        using Answer = Questions::Answer;
        QTest::addRow("unchanged") << false << int(Answer::Cancel) << true << true;
        QTest::addRow("Don't save") << true << int(Answer::DontSave) << true << true;
        QTest::addRow("Cancel") << true << int(Answer::Cancel) << true << false;
        QTest::addRow("Save") << true << int(Answer::Save) << false << true;
    }
    void mayCloseAnswersOnce()
    {
        QFETCH(bool, changed);
        QFETCH(int, answer);
        QFETCH(bool, atOnce);
        QFETCH(bool, may);
        const Desk desk;
        if (!changed)
            desk.session().history.undo();
        desk.answers->answer = Questions::Answer(answer);
        std::vector<bool> said;
        desk.files().mayClose([&](bool yes) { said.push_back(yes); });
        QCOMPARE(said.size(), std::size_t(atOnce));
        QTRY_VERIFY(!desk.files().busy());
        QTest::qWait(20);
        QCOMPARE(said, std::vector{may});
    }
};

QTEST_MAIN(FilesBusyTest)
#include "files_busy_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>

#include <fcntl.h>
#include <sys/stat.h>

#include "tests/test_class.h"
#include "tests/ui/files/busy_desk.h"

namespace files_files_busy_test {

using namespace ui;

namespace {

/// A file that takes long to read: until somebody writes to it.
class Pipe {
public:
    explicit Pipe(const QString& where) : path(where) { ::mkfifo(name(), 0600); }
    ~Pipe() { ::close(::open(name(), O_RDWR)); } // the end for whoever still reads
    Q_DISABLE_COPY_MOVE(Pipe)

    void write(const QByteArray& content) const
    {
        const int file = ::open(name(), O_WRONLY); // waits for the reader
        QCOMPARE(::write(file, content.constData(), std::size_t(content.size())), content.size());
        ::close(file);
    }
    const QString path;

private:
    const char* name() const { return name_.constData(); }
    const QByteArray name_ = path.toLocal8Bit();
};

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
        const Pipe pipe(desk.path("pipe.svg"));
        QSignalSpy loaded(&desk.session(), &app::Session::loaded);
        desk.files().open(pipe.path);
        desk.files().open(desk.otherFile());
        QTest::qWait(20);
        QCOMPARE(desk.files().name(), "two.svg");
        pipe.write("<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm'/>");
        QTRY_VERIFY(!desk.files().busy());
        QCOMPARE(loaded.count(), 2);
        QCOMPARE(desk.files().name(), "other.svg");
    }
    void cancellingAnOpenLeavesTheDrawing()
    {
        const Desk desk;
        desk.answers->answer = Questions::Answer::DontSave;
        const Pipe pipe(desk.path("pipe.svg"));
        desk.files().open(pipe.path);
        clickCancel();
        QTRY_VERIFY(!desk.files().busy());
        QCOMPARE(desk.files().name(), "two.svg");
        QCOMPARE(desk.session().comparedAt(), middle);
        desk.answers->answer = Questions::Answer::Cancel;
        QVERIFY(desk.saved()); // although a thread still reads
    }
    void aCropIsThatOfTheDrawingItChanges()
    {
        const Desk desk;
        desk.files().cutPermanently(app::permanentCut("crop"));
        desk.change(small); // before the result arrives
        desk.files().wait();
        QCOMPARE(desk.session().scene.lines().size(), std::size_t(1));
        QCOMPARE(desk.session().scene.lines()[0], (clipping::Segment{{40, 50}, {60, 50}}));
        desk.session().history.undo();
        QCOMPARE(desk.session().scene.lines().size(), std::size_t(2));
    }
};

} // namespace files_files_busy_test

TEST_CLASS(files_files_busy_test::FilesBusyTest, Widgets)
#include "tests/ui/files/files_busy_test.moc"

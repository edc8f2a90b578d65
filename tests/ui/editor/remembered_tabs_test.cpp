// SPDX-License-Identifier: GPL-3.0-or-later
// The tabs of the last run, each of which is read when it is first shown.
#include "tests/test_class.h"
#include "tests/ui/editor/test_desk.h"

namespace editor_remembered_tabs_test {

using namespace ui;

namespace {

/// Ends the program's window, and begins with the next one in the same home.
struct NextStart : TestDesk {
    explicit NextStart(bool opensFile = false) { begin(opensFile); }
    void begin(bool opensFile = false)
    {
        shown = desk->restoreTabs(!opensFile);
        if (!shown.isEmpty())
            open(shown);
    }
    /// The same settings, another window.
    void restart(bool opensFile = false)
    {
        desk.reset();
        desk = std::make_unique<Desk>(Backend::Raster);
        QObject::connect(desk.get(), &Desk::made, [this](MainWindow& window) { prepare(window); });
        prepare(desk->current());
        desk->resize(1280, 800);
        static_cast<QWidget&>(*desk).show();
        QVERIFY(QTest::qWaitForWindowExposed(desk.get()));
        begin(opensFile);
    }
    int readDrawings() const
    {
        int read = 0;
        for (int i = 0; i < desk->count(); ++i)
            read += desk->isRead(i);
        return read;
    }
    void settle() const
    {
        QTRY_VERIFY([this] {
            for (int i = 0; i < desk->count(); ++i)
                if (desk->isRead(i) && desk->at(i).files().busy())
                    return false;
            return true;
        }());
        QCoreApplication::processEvents();
    }
    void openThree()
    {
        for (const char* name : {"one.svg", "two.svg", "three.svg"})
            desk->current().files().open(file(name)), settle();
    }
    QString shown;
};

} // namespace

class RememberedTabsTest : public QObject {
    Q_OBJECT

private slots:
    void onlyTheShownDrawingIsRead()
    {
        NextStart t;
        t.openThree();
        t.desk->showTab(1);
        t.settle();
        t.restart();
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg", "three.svg"}));
        QCOMPARE(t.shown, t.folder.filePath("two.svg"));
        QCOMPARE(t.readDrawings(), 1);
        QCOMPARE(t.tabs().currentIndex(), 1);
        QTest::mouseClick(&t.tabs(), Qt::LeftButton, {}, t.tabs().tabRect(2).center());
        t.settle();
        QCOMPARE(t.readDrawings(), 2);
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("three.svg"));
        QTest::keyClick(t.desk->current().canvas().focusProxy(), Qt::Key_Tab, Qt::ControlModifier);
        t.settle();
        QCOMPARE(t.readDrawings(), 3);
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("one.svg"));
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg", "three.svg"}));
    }

    // Nothing is lost by a start that reads only one of them.
    void drawingsThatWereNotShownAreRememberedAgain()
    {
        NextStart t;
        t.openThree();
        t.restart();
        t.restart();
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg", "three.svg"}));
        QCOMPARE(t.readDrawings(), 1);
        t.desk->closeTab(0); // it was not read
        t.restart();
        QCOMPARE(t.names(), QStringList({"two.svg", "three.svg"}));
        t.run("reopen"); // of this run alone
        QCOMPARE(t.desk->count(), 2);
    }

    void aClosedTabThatWasNotReadIsReopened()
    {
        NextStart t;
        t.openThree();
        t.restart();
        t.desk->closeTab(0);
        QCOMPARE(t.desk->count(), 2);
        t.run("reopen");
        t.settle();
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("one.svg"));
    }

    void aVanishedFileIsSaidOnce()
    {
        NextStart t;
        t.openThree();
        t.restart();
        QVERIFY(QFile::remove(t.folder.filePath("one.svg")));
        t.desk->showTab(0);
        t.settle();
        QTRY_COMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("three.svg"));
        QVERIFY(t.desk->current().message().contains("one.svg"));
        t.restart();
        QCOMPARE(t.names(), QStringList({"two.svg", "three.svg"}));
    }

    void allFilesMayHaveVanished()
    {
        NextStart t;
        t.openThree();
        for (const char* name : {"one.svg", "two.svg", "three.svg"})
            QVERIFY(QFile::remove(t.folder.filePath(name)));
        t.restart();
        t.settle();
        QVERIFY(t.desk->current().message().contains("three.svg"));
        QVERIFY(t.desk->current().files().isUnused());
        QCOMPARE(t.desk->count(), 3); // the others were not asked for
        t.desk->showTab(0);
        t.settle();
        QTRY_COMPARE(t.desk->count(), 2);
        QVERIFY(t.desk->current().message().contains("one.svg"));
    }

    void aGivenFileTakesItsTab()
    {
        NextStart t;
        t.openThree();
        t.restart(true);
        QVERIFY(t.shown.isEmpty());
        QCOMPARE(t.desk->count(), 4); // and the first window, which is unused
        t.open(t.folder.filePath("two.svg"));
        t.settle();
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg", "three.svg"}));
        QCOMPARE(t.tabs().currentIndex(), 1);
        QCOMPARE(t.readDrawings(), 1);
    }

    void anUnsavedDrawingTakesItsTab()
    {
        NextStart t;
        t.openThree();
        t.restart();
        const QString kept = t.folder.filePath("kept");
        QVERIFY(QDir().mkpath(kept));
        const auto drawing = app::readFile(t.folder.filePath("one.svg"));
        QVERIFY(drawing);
        QVERIFY(!app::writeLeftover(drawing.value->document,
                                    {"one.svg", t.folder.filePath("one.svg"), {}},
                                    app::newLeftoverFile(kept)));
        for (int i = 0; i < t.desk->count(); ++i)
            if (t.desk->isRead(i))
                t.answersOf(t.desk->at(i)).leftover = Questions::Leftover::Recover;
        t.desk->keepJournals(kept);
        t.desk->offerRecovery();
        t.settle();
        QTRY_COMPARE(t.tabs().currentIndex(), 0);
        QTRY_VERIFY(!t.desk->current().session().history.isClean());
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg", "three.svg"}));
    }

    void turnedOffNothingIsRemembered()
    {
        NextStart t;
        t.openThree();
        QSettings settings;
        app::setReopensDrawings(settings, false);
        t.desk->showNext(1);
        t.restart();
        QCOMPARE(t.desk->count(), 1);
        QVERIFY(t.shown.isEmpty());
        t.openThree();
        app::setReopensDrawings(settings, true); // counts for what is open
        t.desk->showNext(1);
        t.restart();
        QCOMPARE(t.desk->count(), 3);
    }

    void hostileSettings()
    {
        NextStart t;
        QStringList files{"relative.svg", QString(9000, u'x'), "/\1", t.file("one.svg")};
        for (int i = 0; i < 200; ++i)
            files << QStringLiteral("/nowhere/%1.svg").arg(i);
        QSettings().setValue("drawings/open", files);
        QSettings().setValue("drawings/shown", "/nowhere/3.svg");
        t.restart();
        t.settle();
        QVERIFY(t.desk->count() <= 30);
        QVERIFY(t.desk->current().message().contains("3.svg"));
        t.desk->showTab(0);
        t.settle();
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("one.svg"));
    }
};

} // namespace editor_remembered_tabs_test

TEST_CLASS(editor_remembered_tabs_test::RememberedTabsTest, Widgets)
#include "tests/ui/editor/remembered_tabs_test.moc"

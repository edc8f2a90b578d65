// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_objects.h"
#include "app/recovery/replay.h"
#include "app/session/export_source.h"
#include "app/session/layer_steps.h"
#include "ui/explanation/explanation_window.h"
#include "ui/window/drawing_tabs.h"
#include "ui/window/workspaces.h"

#include <QApplication>
#include <QMimeData>

#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/editor/test_desk.h"

namespace editor_desk_test {

using namespace ui;

class DeskTest : public QObject {
    Q_OBJECT

private slots:
    void oneDrawingHasNoTabs()
    {
        TestDesk t;
        QCOMPARE(t.desk->count(), 1);
        QVERIFY(!t.desk->current().drawingTabs().isVisible());
        t.open(t.file("one.svg")); // replaces the empty drawing
        QCOMPARE(t.desk->count(), 1);
        QCOMPARE(t.desk->windowTitle(), t.desk->current().windowTitle());
        QVERIFY(t.desk->windowTitle().contains("one.svg"));
    }

    void aSecondFileOpensBesideTheFirst()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        MainWindow& first = t.desk->current();
        t.edit(first);
        t.open(t.file("two.svg", 7));
        QCOMPARE(t.desk->count(), 2);
        MainWindow& second = t.desk->current();
        QVERIFY(&second != &first && second.isVisible() && !first.isVisible());
        QCOMPARE(t.answersOf(first).asked, 0); // nothing is given up
        QCOMPARE(first.session().history.count(), 1);
        QCOMPARE(second.session().history.count(), 0);
        QVERIFY(second.drawingTabs().isVisible());
        QCOMPARE(t.names(), QStringList({"one.svg", "two.svg"}));
        QCOMPARE(t.tabs().currentIndex(), 1);
        QVERIFY(t.tabs().accessibleTabName(0).contains("not saved"));
        QVERIFY(!t.desk->isWindowModified());
        QTest::keyClick(second.canvas().focusProxy(), Qt::Key_Tab, Qt::ControlModifier);
        QCOMPARE(&t.desk->current(), &first);
        QVERIFY(t.desk->isWindowModified());
        first.session().history.undo();
        QVERIFY(!t.desk->isWindowModified());
    }

    void theSameFileTwiceShowsItsTab()
    {
        TestDesk t;
        const QString one = t.file("one.svg"), two = t.file("two.svg");
        t.open(one);
        t.open(two);
        t.open(one);
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->current().session().path(), one);
        t.open(QFileInfo(two).path() + "/./two.svg");
        QCOMPARE(t.desk->count(), 2);
    }

    void aLinkIsTheSameFile()
    {
        TestDesk t;
        const QString one = t.file("one.svg"), link = t.folder.filePath("link.svg");
        QVERIFY(QFile::link(one, link));
        t.open(one);
        t.open(link);
        QCOMPARE(t.desk->count(), 1);
        // Also while it is being read.
        const QString two = t.file("two.svg");
        t.desk->open({two, two});
        for (int i = 0; i < t.desk->count(); ++i)
            t.desk->at(i).files().wait();
        QCOMPARE(t.desk->count(), 2);
    }

    void anOpenDrawingIsNotReplaced()
    {
        TestDesk t;
        const QString one = t.file("one.svg"), two = t.file("two.svg");
        t.open(one);
        t.open(two);
        MainWindow& second = t.desk->current();
        const QByteArray before = contentOf(one);
        t.answersOf(second).save = one;
        t.run("save-as");
        QVERIFY(second.message().contains("one.svg"));
        QCOMPARE(second.session().path(), two);
        const app::ExportJob job{app::exportSourceOf(second.session()),
                                 {.area = {.part = app::ExportPart::Page}}};
        for (const QString& path : {one, two}) { // of the other drawing, and its own
            std::optional<bool> written;
            second.files().exportTo(job, path, [&](bool done) { written = done; });
            second.files().wait();
            QCOMPARE(written, std::optional(false));
            QVERIFY(second.message().contains(QFileInfo(path).fileName()));
        }
        QCOMPARE(contentOf(one), before);
    }

    // In the tab, in the question, and for a file to write.
    void drawingsWithoutAFileHaveNamesOfTheirOwn()
    {
        TestDesk t;
        for (int i = 0; i < 2; ++i) {
            t.run("new");
            app::addLayer(t.desk->current().session(), "Walls");
        }
        t.run("new");
        QCOMPARE(t.names(), QStringList({"Untitled", "Untitled 2", "Untitled 3"}));
        t.desk->showTab(1);
        QCOMPARE(t.desk->current().files().name(), QString("Untitled 2"));
        QCOMPARE(QFileInfo(t.desk->current().files().exportProposal({})).fileName(),
                 QString("Untitled 2-cut.svg"));
        t.desk->close(t.desk->at(2)); // unused
        QTRY_COMPARE(t.names(), QStringList({"Untitled", "Untitled 2"}));
        t.run("new");
        QTRY_COMPARE(t.names().last(), QString("Untitled 3"));
    }
    void sameNamesAreToldApart()
    {
        TestDesk t;
        t.open(t.file("a/x/plan.svg"));
        t.open(t.file("b/x/plan.svg"));
        QCOMPARE(t.names(), QStringList({"plan.svg – x", "plan.svg – x (2)"}));
    }

    void inputThatWasHeldFindsItsTabGone()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.open(t.file("two.svg"));
        MainWindow& second = t.desk->current();
        QAction* close = t.action("close");
        close->trigger();
        QCOMPARE(t.desk->count(), 1);
        close->trigger(); // before it is deleted
        t.desk->showWindow(second);
        second.files().startNew();
        QCOMPARE(t.desk->count(), 2); // the new drawing is beside the first
    }

    // The second Ctrl+W waits until the first one has saved.
    void closingTwiceClosesOne()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.open(t.file("two.svg"));
        MainWindow& second = t.desk->current();
        t.edit(second);
        t.answersOf(second).answer = Questions::Answer::Save;
        const QPointer<QAction> close = t.action("close");
        close->trigger();
        t.desk->close(second);
        QTRY_COMPARE(t.desk->count(), 1);
        QTest::qWait(50);
        QCOMPARE(t.desk->count(), 1);
        QVERIFY(t.desk->current().session().path().endsWith("one.svg"));
    }

    void whatIsInHandIsSavedBeforeQuitting()
    {
        TestDesk t;
        t.run("new");
        MainWindow& first = t.desk->current();
        first.canvas().setTool("polyline");
        QWidget* area = first.canvas().focusProxy();
        for (const QPoint corner : {QPoint(200, 100), QPoint(300, 150)})
            QTest::mouseClick(area, Qt::LeftButton, {}, corner);
        t.open(t.file("two.svg"));
        QVERIFY(!first.session().history.isClean()); // the gesture has ended
        t.desk->close();
        QCoreApplication::processEvents();
        QCOMPARE(t.answersOf(first).asked, 1);
        QCOMPARE(&t.desk->current(), &first);
    }

    void sameNamesHaveTheirFolder()
    {
        TestDesk t;
        t.open(t.file("a/plan.svg"));
        t.open(t.file("b/plan.svg"));
        QCOMPARE(t.names(), QStringList({"plan.svg – a", "plan.svg – b"}));
    }

    void toolAndWorkspaceGoAlong()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.desk->current().canvas().setTool("pen");
        t.desk->current().choose(
            *std::ranges::find(workspaces(), "workspace-compare", &Workspace::key));
        t.run("new");
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->current().canvas().tool(), "pen");
        QCOMPARE(t.desk->current().workspace().key, "workspace-compare");
        QVERIFY(t.desk->current().canvas().focusProxy()->hasFocus());
    }

    void closingAsksAndReopens()
    {
        TestDesk t;
        const QString one = t.file("one.svg"), two = t.file("two.svg");
        t.open(one);
        t.open(two);
        MainWindow& second = t.desk->current();
        t.edit(second);
        t.run("close"); // the answer is Cancel
        QCOMPARE(t.answersOf(second).asked, 1);
        QCOMPARE(t.desk->count(), 2);
        t.answersOf(second).answer = Questions::Answer::DontSave;
        t.run("close");
        QCOMPARE(t.desk->count(), 1);
        QCOMPARE(t.desk->current().session().path(), one);
        QVERIFY(!t.desk->current().drawingTabs().isVisible());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        t.run("reopen");
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->current().session().path(), two);
        t.run("close");
        t.run("close"); // the last one leaves an empty drawing
        QCOMPARE(t.desk->count(), 1);
        QVERIFY(t.desk->current().session().path().isEmpty());
        t.run("reopen");
        QCOMPARE(t.desk->current().session().path(), one);
        QCOMPARE(t.desk->count(), 1);
    }

    void tabsAreClickedClosedAndMoved()
    {
        TestDesk t;
        for (const char* name : {"one.svg", "two.svg", "three.svg"})
            t.open(t.file(name));
        QTest::mouseClick(&t.tabs(), Qt::LeftButton, {}, t.tabs().tabRect(0).center());
        QVERIFY(t.desk->current().session().path().endsWith("one.svg"));
        t.tabs().moveTab(0, 2);
        QCoreApplication::processEvents();
        QCOMPARE(t.names(), QStringList({"two.svg", "three.svg", "one.svg"}));
        QVERIFY(t.desk->current().session().path().endsWith("one.svg"));
        QTest::mouseClick(&t.tabs(), Qt::MiddleButton, {}, t.tabs().tabRect(0).center());
        QCOMPARE(t.names(), QStringList({"three.svg", "one.svg"}));
        QTest::mouseClick(t.tabs().tabButton(1, QTabBar::RightSide), Qt::LeftButton);
        QCOMPARE(t.desk->count(), 1);
    }

    void quittingAsksAboutEachUnsavedDrawing()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.edit(t.desk->current());
        t.open(t.file("two.svg"));
        t.open(t.file("three.svg"));
        t.edit(t.desk->current());
        t.answersOf(t.desk->at(0)).answer = Questions::Answer::DontSave;
        t.desk->close(); // about the third: Cancel
        QCoreApplication::processEvents();
        QVERIFY(t.desk->isVisible());
        QCOMPARE(t.desk->count(), 3); // nothing is closed before all agree
        QCOMPARE(t.answersOf(t.desk->at(0)).asked, 1);
        QCOMPARE(t.answersOf(t.desk->at(1)).asked, 0);
        QCOMPARE(t.answersOf(t.desk->at(2)).asked, 1);
        QCOMPARE(&t.desk->current(), &t.desk->at(2)); // which the question is about
        t.answersOf(t.desk->at(2)).answer = Questions::Answer::Save;
        t.desk->close();
        QTRY_VERIFY(!t.desk->isVisible());
        QVERIFY(contentOf(t.folder.filePath("three.svg")).size() > 0);
    }

    void theNextDrawingEndsThePresentation()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.open(t.file("two.svg"));
        const double size = QApplication::font().pointSizeF();
        t.run("presentation");
        QVERIFY(t.desk->isFullScreen() && QApplication::font().pointSizeF() > size);
        t.desk->showNext(1);
        QVERIFY(!t.desk->isFullScreen() && !t.desk->at(1).isPresenting());
        QCOMPARE(QApplication::font().pointSizeF(), size);
    }

    void objectsGoFromOneToTheOther()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.run("select-all");
        t.run("copy");
        t.run("new");
        t.run("paste");
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->current().session().now().objects().size(),
                 t.desk->at(0).session().now().objects().size());
    }

    void keysThatWereChangedAreEverywhere()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        t.open(t.file("two.svg"));
        QSettings().setValue("shortcuts", QStringList{"invert-selection\tCtrl+F9"});
        t.desk->showNext(1);
        QCOMPARE(t.action("invert-selection")->shortcut(), QKeySequence("Ctrl+F9"));
        QSettings().remove("shortcuts");
    }

    void aFileThatCannotBeReadLeavesNoTab()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        QFile bad(t.folder.filePath("bad.svg"));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("<svg this is none");
        bad.close();
        t.open(bad.fileName());
        QTRY_COMPARE(t.desk->count(), 1);
        QVERIFY(t.desk->current().session().path().endsWith("one.svg"));
        QVERIFY(t.desk->current().message().contains("bad.svg"));
    }

    void floatingPanelsGoWithTheirDrawing()
    {
        TestDesk t;
        t.open(t.file("one.svg"));
        MainWindow& first = t.desk->current();
        auto* layers = first.findChild<QDockWidget*>("layers");
        layers->show();
        layers->setFloating(true);
        QVERIFY(layers->isVisible());
        t.open(t.file("two.svg"));
        QVERIFY(!layers->isVisible());
        t.desk->showNext(1);
        QCOMPARE(&t.desk->current(), &first);
        QVERIFY(layers->isVisible() && layers->isFloating());
    }

    void thereIsALimit()
    {
        TestDesk t;
        constexpr int most = 3;
        t.desk->setMost(most);
        t.open(t.file("file0.svg"));
        while (t.desk->count() < most)
            t.open(t.file(QStringLiteral("file%1.svg").arg(t.desk->count())));
        MainWindow& last = t.desk->current();
        t.open(t.file("more.svg"));
        t.run("new");
        QCOMPARE(t.desk->count(), most);
        QVERIFY(last.message().contains("no more can be"));
        t.run("close");
        t.open(t.file("more.svg"));
        QCOMPARE(t.desk->current().session().path(), t.folder.filePath("more.svg"));
    }

    // Each drawing has a journal, and all are recovered side by side.
    void allUnsavedDrawingsAreRecovered()
    {
        TestDesk t;
        const QString unsaved = t.folder.filePath("unsaved"), kept = t.folder.filePath("kept");
        t.desk->keepJournals(unsaved);
        for (const char* name : {"one.svg", "two.svg", "three.svg"}) {
            t.open(t.file(name));
            t.edit(t.desk->current());
        }
        const auto journals = [&] {
            return QDir(unsaved).entryList({"*.journal"}, QDir::Dirs | QDir::NoDotAndDotDot);
        };
        QTRY_COMPARE(journals().size(), 3);
        // What a crash leaves: a copy of them, without an owner.
        QTRY_VERIFY([&] {
            QDir(kept).removeRecursively();
            QDir().mkpath(kept);
            for (const QString& journal : journals()) {
                QDir().mkpath(kept + '/' + journal);
                for (const QString& one : QDir(unsaved + '/' + journal).entryList(QDir::Files))
                    if (!one.contains("lock"))
                        QFile::copy(unsaved + '/' + journal + '/' + one,
                                    kept + '/' + journal + '/' + one);
            }
            return app::claimLeftovers(kept).size() == 3;
        }());
        for (int i = 0; i < t.desk->count(); ++i)
            t.answersOf(t.desk->at(i)).answer = Questions::Answer::DontSave;
        t.desk.reset();
        QVERIFY(journals().isEmpty());
        TestDesk next;
        const auto recoverAll = [&](MainWindow& window) {
            next.answersOf(window).leftover = Questions::Leftover::Recover;
        };
        QObject::connect(next.desk.get(), &Desk::made, recoverAll);
        recoverAll(next.desk->current());
        next.desk->keepJournals(kept);
        next.desk->offerRecovery();
        const auto allIdle = [&] {
            for (int i = 0; i < next.desk->count(); ++i)
                if (next.desk->at(i).files().busy())
                    return false;
            return true;
        };
        QTRY_VERIFY(next.desk->count() == 3 && allIdle());
        for (int i = 0; i < 3; ++i) {
            const app::Session& session = next.desk->at(i).session();
            QVERIFY(!session.history.isClean() && session.history.canUndo());
            QCOMPARE(session.now().objects().size(), std::size_t(1));
        }
    }
};

} // namespace editor_desk_test

TEST_CLASS(editor_desk_test::DeskTest, Widgets)
#include "tests/ui/editor/desk_test.moc"

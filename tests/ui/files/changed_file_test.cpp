// SPDX-License-Identifier: GPL-3.0-or-later
// Files that another program changed or deleted while they are open.
#include "app/session/file_watch.h"

#include <QPushButton>
#include <QTest>

#include "tests/app/document/sheet_edits.h"
#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace files_changed_file_test {

using namespace ui;

namespace {

constexpr clipping::Window middle{{20, 20}, {70, 70}};

/// A window with an unsaved change, whose file another program then replaced.
struct ChangedFile {
    explicit ChangedFile(bool edited = true)
    {
        test.show();
        test.open(test.twoLines());
        if (edited) {
            setWindow(test.window->session().document, middle);
            test.window->session().history.resetClean();
        }
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(theirs);
        file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime);
    }
    bool says(const char* words) const
    {
        return QTest::qWaitFor([&] { return test.window->message().contains(words); }, patience);
    }
    void press(const char* verb) const
    {
        for (QPushButton* button : test.window->findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == verb)
                button->click();
        test.window->files().wait();
    }
    std::size_t lines() const { return test.window->session().scene.lines().size(); }
    static constexpr int patience = 20'000; // milliseconds
    QString path() const { return test.path("two.svg"); }
    QByteArray contents() const { return contentOf(path()); }
    const QByteArray theirs = "<svg xmlns='http://www.w3.org/2000/svg' width='10mm' height='10mm' "
                              "viewBox='0 0 10 10'><path d='M0 0L5 5' stroke='#000'/></svg>";
    TestWindow test;
};

} // namespace

class ChangedFileTest : public QObject {
    Q_OBJECT

private slots:
    void cancelChangesNothing()
    {
        ChangedFile changed;
        QVERIFY(!changed.test.saved());
        QVERIFY(changed.test.window->isWindowModified());
        QCOMPARE(changed.contents(), changed.theirs);
    }
    void overwriteSaves()
    {
        ChangedFile changed;
        changed.test.answers->changedFile = Questions::ChangedFile::Overwrite;
        QVERIFY(changed.test.saved());
        QVERIFY(!changed.test.window->isWindowModified());
        QVERIFY(changed.contents() != changed.theirs);
    }
    void reloadShowsTheirFile()
    {
        ChangedFile changed;
        changed.test.answers->changedFile = Questions::ChangedFile::Reload;
        QVERIFY(!changed.test.saved());
        changed.test.window->files().wait();
        QCOMPARE(changed.test.window->session().now().objects().size(), std::size_t(1));
        QVERIFY(!changed.test.window->isWindowModified());
        QCOMPARE(changed.contents(), changed.theirs);
    }
    void aDeletedFileIsSavedAgainAndSaid()
    {
        ChangedFile changed;
        QVERIFY(QFile::remove(changed.path()));
        QVERIFY(changed.test.saved());
        QVERIFY(QFile::exists(changed.path()));
        QVERIFY2(changed.test.window->message().contains("two.svg had been deleted"),
                 qPrintable(changed.test.window->message()));
        QVERIFY(changed.test.saved());
        QVERIFY(!changed.test.window->message().contains("deleted"));
    }
    void aChangeIsSaidAtOnceAndReloaded()
    {
        ChangedFile changed(false);
        QVERIFY(changed.says("Another program changed two.svg."));
        QCOMPARE(changed.lines(), std::size_t(2));
        changed.press("Reload file");
        QCOMPARE(changed.lines(), std::size_t(1));
        QVERIFY(!changed.test.window->isWindowModified());
    }
    void reloadingAsksBeforeItGivesUpUnsavedWork()
    {
        ChangedFile changed;
        QVERIFY(changed.says("Another program changed two.svg."));
        changed.press("Reload file");
        QCOMPARE(changed.lines(), std::size_t(2)); // the answer is Cancel
        QVERIFY(changed.says("Another program changed two.svg."));
        changed.test.answers->changedFile = Questions::ChangedFile::Reload;
        changed.press("Reload file");
        QCOMPARE(changed.lines(), std::size_t(1));
    }
    void aDeletedFileIsSaidAtOnce()
    {
        ChangedFile changed(false);
        QVERIFY(changed.says("Another program changed two.svg."));
        QVERIFY(QFile::remove(changed.path()));
        QVERIFY(changed.says("two.svg was deleted or moved."));
        QVERIFY(changed.test.window->isWindowModified()); // closing asks
        changed.press("Save drawing");
        QVERIFY(QFile::exists(changed.path()));
        QVERIFY(!changed.test.window->isWindowModified());
    }
    void savingIsNoChangeOfAnotherProgram()
    {
        ChangedFile changed;
        changed.test.answers->changedFile = Questions::ChangedFile::Overwrite;
        QVERIFY(changed.test.saved());
        QTest::qWait(int(3 * app::FileWatch::rest.count()));
        QVERIFY2(changed.test.window->message().isEmpty(),
                 qPrintable(changed.test.window->message()));
        QVERIFY(changed.test.saved(&Files::save));
    }
    // A recovered drawing has its path, but replaces no file that changed after it was opened.
    void aRecoveredDrawingAsksIfItsFileHasChanged()
    {
        for (const bool changedSince : {false, true}) {
            ChangedFile changed(false);
            const QDateTime time = QFileInfo(changed.path()).lastModified();
            const app::Origin origin{"two.svg", changed.path(),
                                     changedSince ? time.addSecs(-5) : time};
            const QString left = changed.test.path("left.svg");
            QVERIFY(!app::writeLeftover(app::Document(), origin, left));
            auto found = app::claimLeftovers(changed.test.folder.path());
            QCOMPARE(found.size(), std::size_t(1));
            auto end = Files::Recovered::NotAtAll;
            changed.test.window->files().recover(found[0], [&](auto how) { end = how; });
            changed.test.window->files().wait();
            QVERIFY(end == Files::Recovered::Wholly);
            QCOMPARE(changed.test.window->session().path(), changed.path());
            QCOMPARE(changed.test.window->message().contains("has changed its file since"),
                     changedSince);
            QCOMPARE(changed.test.saved(), !changedSince); // the answer is Cancel
            QCOMPARE(changed.contents() == changed.theirs, changedSince);
        }
    }
};

} // namespace files_changed_file_test

TEST_CLASS(files_changed_file_test::ChangedFileTest, Widgets)
#include "tests/ui/files/changed_file_test.moc"

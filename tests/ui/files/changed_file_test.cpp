// SPDX-License-Identifier: GPL-3.0-or-later
// Files that another program changed or deleted while they are open.
#include <QTest>

#include "tests/app/document/sheet_edits.h"
#include "tests/ui/test_window.h"

using namespace ui;

namespace {

constexpr clipping::Window middle{{20, 20}, {70, 70}};

/// A window with an unsaved change, whose file another program then replaced.
struct ChangedFile {
    ChangedFile()
    {
        test.show();
        test.open(test.twoLines());
        setWindow(test.window->session().document, middle);
        test.window->session().history.resetClean();
        QFile file(path());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(theirs);
        file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime);
    }
    QString path() const { return test.path("two.svg"); }
    QByteArray contents() const
    {
        QFile file(path());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
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
};

QTEST_MAIN(ChangedFileTest)
#include "changed_file_test.moc"

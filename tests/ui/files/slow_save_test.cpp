// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/files/busy_desk.h"

namespace files_slow_save_test {

using namespace ui;

class SlowSaveTest : public QObject {
    Q_OBJECT

private slots:
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
        const auto content = [&] { return contentOf(desk.session().path()); };
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

} // namespace files_slow_save_test

TEST_CLASS(files_slow_save_test::SlowSaveTest, Widgets)
#include "tests/ui/files/slow_save_test.moc"

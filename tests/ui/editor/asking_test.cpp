// SPDX-License-Identifier: GPL-3.0-or-later
// The question about unsaved changes stands in the strip of its drawing.
#include "ui/widgets/message_strip.h"

#include <QPushButton>

#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/editor/test_desk.h"

namespace editor_asking_test {

using namespace ui;

namespace {

/// A desk whose questions nobody has answered before.
struct AskingDesk : TestDesk {
    AskingDesk() : TestDesk(Answers::Asked) {}

    void openChanged(const QString& name) const
    {
        open(file(name));
        edit(desk->current());
    }
    static MessageStrip& strip(const MainWindow& window)
    {
        return *window.findChild<MessageStrip*>();
    }
    bool asks() const { return strip(desk->current()).asks(); }
    /// What has the focus.
    QString focused() const
    {
        const auto* button = qobject_cast<QPushButton*>(desk->focusWidget());
        return button ? button->text() : QString();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        QTest::keyClick(desk->focusWidget(), key, with);
        settle();
    }
    void settle() const
    {
        for (int i = 0; i < desk->count(); ++i)
            desk->at(i).files().wait();
        QCoreApplication::processEvents();
    }
};

} // namespace

class AskingTest : public QObject {
    Q_OBJECT

private slots:
    void closingAsksInTheStrip()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.openChanged("two.svg");
        const QWidget* const before = t.desk->focusWidget();
        t.run("close");
        QVERIFY(t.asks() && AskingDesk::strip(t.desk->current()).isVisible());
        QCOMPARE(t.focused(), "Save");
        t.press(Qt::Key_Escape);
        QVERIFY(!t.asks() && !AskingDesk::strip(t.desk->current()).isVisible());
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(t.desk->focusWidget(), before);
    }

    void everyAnswerIsGivenByKeys()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.openChanged("two.svg");
        const QString two = t.folder.filePath("two.svg");
        const QByteArray before = contentOf(two);
        t.run("close");
        t.press(Qt::Key_Right);
        QCOMPARE(t.focused(), "Don't save");
        t.press(Qt::Key_Right);
        QCOMPARE(t.focused(), "Cancel");
        t.press(Qt::Key_Return);
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(contentOf(two), before);
        t.run("close");
        t.press(Qt::Key_Return); // Save
        QTRY_COMPARE(t.desk->count(), 1);
        QVERIFY(contentOf(two) != before);
        t.openChanged("three.svg");
        const QByteArray third = contentOf(t.folder.filePath("three.svg"));
        t.run("close");
        t.press(Qt::Key_Right);
        t.press(Qt::Key_Space);
        QTRY_COMPARE(t.desk->count(), 1);
        QCOMPARE(contentOf(t.folder.filePath("three.svg")), third);
    }

    // The drawing stays alive: who goes on drawing does not want to close it.
    void aFurtherStepWithdrawsTheQuestion()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.desk->close();
        t.settle();
        QVERIFY(t.asks());
        t.edit(t.desk->current());
        QVERIFY(!t.asks());
        t.settle();
        QVERIFY(t.desk->isVisible());
        t.desk->close();
        t.settle();
        QVERIFY(t.asks());
        t.desk->current().session().history.undo();
        QVERIFY(!t.asks());
    }

    void savingMeanwhileIsAnAnswer()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.openChanged("two.svg");
        t.run("close");
        QVERIFY(t.asks());
        t.run("save");
        t.settle();
        QTRY_COMPARE(t.desk->count(), 1);
        QVERIFY(t.desk->current().session().path().endsWith("one.svg"));
    }

    void messagesWaitForTheAnswer()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.run("close");
        MainWindow& window = t.desk->current();
        window.tell({Message::Kind::Warning, "Nothing is selected."});
        QVERIFY(t.asks());
        QCOMPARE(t.focused(), "Save");
        t.press(Qt::Key_Escape);
        QVERIFY(AskingDesk::strip(window).isVisible());
        QCOMPARE(window.message(), "Nothing is selected.");
    }

    // Nothing closes before all agree, and each question stands in the strip of its drawing.
    void quittingAsksInOneTabAfterTheOther()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.open(t.file("two.svg"));
        t.openChanged("three.svg");
        t.desk->close();
        t.settle();
        QCOMPARE(&t.desk->current(), &t.desk->at(0));
        QVERIFY(t.asks() && !AskingDesk::strip(t.desk->at(2)).asks());
        t.press(Qt::Key_Right);
        t.press(Qt::Key_Return); // Don't save
        QCOMPARE(&t.desk->current(), &t.desk->at(2));
        QVERIFY(t.asks());
        QCOMPARE(t.desk->count(), 3);
        t.press(Qt::Key_Escape);
        QVERIFY(t.desk->isVisible());
        QVERIFY(!t.desk->at(0).session().history.isClean()); // nothing was given up
        t.desk->close();                                     // asks about both again
        t.settle();
        QCOMPARE(&t.desk->current(), &t.desk->at(0));
        t.press(Qt::Key_Return); // Save
        QTRY_COMPARE(&t.desk->current(), &t.desk->at(2));
        QTRY_VERIFY(t.asks());
        t.press(Qt::Key_Right);
        t.press(Qt::Key_Return);
        QTRY_VERIFY(!t.desk->isVisible());
    }

    // What is drawn after the answer was not in the question.
    void workAfterTheAnswerIsAskedAboutAgain()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.openChanged("two.svg");
        t.desk->close();
        t.settle();
        t.press(Qt::Key_Right);
        t.press(Qt::Key_Return); // Don't save, in one.svg
        QCOMPARE(&t.desk->current(), &t.desk->at(1));
        t.edit(t.desk->at(0));
        t.press(Qt::Key_Right);
        t.press(Qt::Key_Return); // Don't save, in two.svg
        QVERIFY(t.desk->isVisible());
        QCOMPARE(&t.desk->current(), &t.desk->at(0));
        QVERIFY(t.asks());
    }

    void tabsMayBeClosedWhileQuittingAsks()
    {
        AskingDesk t;
        t.openChanged("one.svg");
        t.openChanged("two.svg");
        t.open(t.file("three.svg"));
        t.desk->close();
        t.settle();
        t.desk->close(t.desk->at(2)); // clean
        QCOMPARE(t.desk->count(), 2);
        QCOMPARE(&t.desk->current(), &t.desk->at(1));
        t.desk->close(); // again: the first question, in front
        t.settle();
        QCOMPARE(&t.desk->current(), &t.desk->at(0));
        for (int i = 0; i < 2; ++i) {
            QVERIFY(t.asks());
            t.press(Qt::Key_Right);
            t.press(Qt::Key_Return);
        }
        QTRY_VERIFY(!t.desk->isVisible());
    }
};

} // namespace editor_asking_test

TEST_CLASS(editor_asking_test::AskingTest, Widgets)
#include "tests/ui/editor/asking_test.moc"

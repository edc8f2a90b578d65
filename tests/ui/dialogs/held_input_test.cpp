// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/dialogs/waiting_desk.h"

namespace dialogs_held_input_test {

class HeldInputTest : public QObject {
    Q_OBJECT

private slots:
    void inputWaitsUntilTheWorkHasEnded()
    {
        Desk desk;
        const Gate gate;
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Drops);
        for (const Qt::Key key : {Qt::Key_A, Qt::Key_B, Qt::Key_C})
            desk.type(key);
        QTest::mouseClick(desk.window.windowHandle(), Qt::LeftButton);
        QCOMPARE(desk.field.text(), QString());
        gate.open();
        QTRY_COMPARE(desk.field.text(), QString("abc"));
        desk.type(Qt::Key_D);
        QCOMPARE(desk.field.text(), QString("abcd"));
    }
    void inputBeforeTheDialogIsForgotten()
    {
        Desk desk;
        const Gate gate;
        desk.background.run("Working…", gate.work(42), desk.store(), Cancel::Drops);
        desk.type(Qt::Key_A);
        QTRY_VERIFY(shownDialog());
        desk.type(Qt::Key_B);
        gate.open();
        QTRY_VERIFY(!desk.background.busy());
        desk.type(Qt::Key_C);
        QCOMPARE(desk.field.text(), QString("c"));
    }
    void inputThatBeginsTheNextJobWaitsInItsOrder()
    {
        Desk desk;
        const Gate first, second;
        connect(&desk.field, &QLineEdit::textEdited, this, [&](const QString& text) {
            if (text == "a")
                desk.background.run("Working…", second.work(2), desk.store(), Cancel::Drops);
        });
        desk.background.run("Working…", first.work(1), desk.store(), Cancel::Drops);
        desk.type(Qt::Key_A);
        desk.type(Qt::Key_B);
        first.open();
        QTRY_COMPARE(desk.field.text(), QString("a"));
        desk.type(Qt::Key_C);
        QTest::qWait(20);
        QCOMPARE(desk.field.text(), QString("a"));
        second.open();
        QTRY_COMPARE(desk.field.text(), QString("abc"));
        QCOMPARE(desk.results, (Results{1, 2}));
    }
};

} // namespace dialogs_held_input_test

TEST_CLASS(dialogs_held_input_test::HeldInputTest, Widgets)
#include "tests/ui/dialogs/held_input_test.moc"

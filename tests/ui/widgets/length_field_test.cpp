// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/length_field.h"

#include <QHelpEvent>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "tests/test_class.h"

namespace widgets_length_field_test {

using namespace ui;

// Typed lengths are accepted, or the field says why not.
class LengthFieldTest : public QObject {
    Q_OBJECT

private slots:
    void expressionsAreEvaluated_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("length");
        QTest::newRow("a number") << "25" << 25.0;
        QTest::newRow("a sum") << "10+5" << 15.0;
        QTest::newRow("a unit") << "1in" << 25.4;
        QTest::newRow("a product") << "3*25mm" << 75.0;
        QTest::newRow("a typographic sum") << QString::fromUtf8("1,010 − 5 × 2") << 1000.0;
        QTest::newRow("more decimals than are shown") << "25.123456789" << 25.123456789;
        QTest::newRow("its own text") << QString::fromUtf8("−1,234.50") << -1234.5;
    }
    void expressionsAreEvaluated()
    {
        QFETCH(QString, text);
        QFETCH(double, length);
        for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab}) {
            Field field;
            field.type(text, end);
            QCOMPARE(field.edited.size(), 1);
            QCOMPARE(field.edited[0][0].toDouble(), length);
            QVERIFY(field.refused.isEmpty());
        }
    }
    void enteringTheFieldDoesNotRoundItsNumber()
    {
        for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab}) {
            Field field;
            field->show(33.333333, app::Unit::Mm, 1);
            QCOMPARE(field->text(), "33.33");
            field->setFocus();
            field->selectAll();
            field.type("33.33", end); // what it shows
            QCOMPARE(field.edited.size(), 0);
            QCOMPARE(field->value(), 33.333333);
        }
    }
    void invalidLengthsAreRefusedWithAMessage_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* text, const char* why) {
            QTest::addRow("%s", text) << QString(text)
                                      << QString::fromUtf8("Width: “%1” is not a length: %2.")
                                             .arg(QString(text), QString::fromUtf8(why));
        };
        row("10+", "the sum ends without a number");
        row("50%", "“%” is not a unit of length here");
        row("2mm*3mm", "a length times a length is an area");
        row("1/0", "division by zero");
        row("5e10", "it is too large");
        row("", "the sum ends without a number");
        QTest::newRow("said once") << "ten" << QString::fromUtf8("Width: “ten” is not a number.");
    }
    void invalidLengthsAreRefusedWithAMessage()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Tab, Qt::Key_Up}) {
            Field field;
            field.type(text, end);
            QCOMPARE(field.refused.size(), 1);
            QCOMPARE(field.refused[0][0].toString(), sentence);
            QCOMPARE(field.edited.size(), end == Qt::Key_Up ? 1 : 0); // from the previous number
            QCOMPARE(field->text(), end == Qt::Key_Up ? "101.00" : "100.00");
            QCOMPARE(field.entered.size(), 0);
        }
    }
    void enterOnARefusedTextDoesNotReachTheDialog()
    {
        Field field;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field.operator->(), "10+");
        QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QApplication::sendEvent(field.operator->(), &enter);
        QVERIFY(enter.isAccepted());
        QCOMPARE(field.refused.size(), 1);
        QKeyEvent again(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QApplication::sendEvent(field.operator->(), &again); // the last number is back
        QVERIFY(!again.isAccepted());
    }
    void aLongNumberShowsItsBeginning()
    {
        Field field;
        field->setFixedSize(90, 26);
        field->show(1e9, app::Unit::Mm, 1);
        field.other.setFocus();
        QVERIFY(field->seenText().startsWith("1,000"));
        QVERIFY(field->seenText().endsWith(u'…'));
        QCOMPARE(field->text(), "1,000,000,000.00"); // the number itself is not touched
        QHelpEvent tip(QEvent::ToolTip, {9, 9}, field->mapToGlobal(QPoint(9, 9)));
        QApplication::sendEvent(field.operator->(), &tip);
        QCOMPARE(QToolTip::text(), "1,000,000,000.00");
        field->setFocus();
        QCOMPARE(field->seenText(), field->text());
        field->show(5, app::Unit::Mm, 1);
        field.other.setFocus();
        QCOMPARE(field->seenText(), "5.00");
    }
    void escapeRestoresTheTextThenLeavesTheField()
    {
        Field field;
        field.type("12+", Qt::Key_Escape);
        QCOMPARE(field->text(), "100.00");
        QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(field.operator->(), &again);
        QVERIFY(!again.isAccepted()); // the window gives the focus to the canvas
        QVERIFY(field.refused.isEmpty() && field.edited.isEmpty());
    }
    void escapeAndNonsenseShowNoNumberInAMixedField()
    {
        Field field;
        field->showMixed(30, app::Unit::Mm, 1);
        QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QApplication::sendEvent(field.operator->(), &escape);
        QVERIFY(!escape.isAccepted()); // nothing was typed: the field is left at once
        QCOMPARE(field->text(), "");
        field.type("12+", Qt::Key_Escape);
        QCOMPARE(field->text(), "");
        field.type("a", Qt::Key_Return);
        QCOMPARE(field->text(), "");
        QCOMPARE(field.refused.size(), 1);
        QVERIFY(field.edited.isEmpty());
    }

private:
    /// A field with a width of 100 mm, and another widget to focus.
    struct Field {
        Field()
            : field("Width", LengthField::Range::Any, LengthField::Suffix::None, &window),
              other(&window), edited(&field, &LengthField::edited),
              entered(&field, &LengthField::entered), refused(&field, &LengthField::refused)
        {
            field.show(100, app::Unit::Mm, 1);
            window.show();
            window.activateWindow();
            [[maybe_unused]] const bool active = QTest::qWaitForWindowActive(&window);
        }
        void type(const QString& text, Qt::Key end)
        {
            field.setFocus();
            field.selectAll();
            QTest::keyClick(&field, Qt::Key_Delete);
            for (const QChar c : text) { // QTest supports only Latin keys
                QKeyEvent key(QEvent::KeyPress, 0, Qt::NoModifier, QString(c));
                QApplication::sendEvent(&field, &key);
            }
            QTest::keyClick(&field, end);
        }
        LengthField* operator->() { return &field; }

        QWidget window;
        LengthField field;
        QLineEdit other;
        QSignalSpy edited, entered, refused;
    };
};

} // namespace widgets_length_field_test

TEST_CLASS(widgets_length_field_test::LengthFieldTest, Widgets)
#include "tests/ui/widgets/length_field_test.moc"

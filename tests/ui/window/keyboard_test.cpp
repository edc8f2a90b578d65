// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keyboard.h"

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_keyboard_test {

namespace {

/// A key as an X server or Wayland compositor reports it.
QKeyEvent pressed(int key, quint32 code, const QString& text,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    return {QEvent::KeyPress, key, modifiers, code, 0, 0, text};
}

} // namespace

class KeyboardTest : public QObject {
    Q_OBJECT

private slots:
    void placesAreThoseOfAUsKeyboard()
    {
        using ui::keyAtItsPlace;
        QCOMPARE(keyAtItsPlace(pressed(Qt::Key_Ampersand, 10, "&")), QKeyCombination(Qt::Key_1));
        QCOMPARE(keyAtItsPlace(pressed(Qt::Key_Agrave, 19, "à")), QKeyCombination(Qt::Key_0));
        QCOMPARE(keyAtItsPlace(pressed(0x3BB, 46, "λ")), QKeyCombination(Qt::Key_L));
        QCOMPARE(keyAtItsPlace(pressed(0x396, 52, "Ζ", Qt::ControlModifier)),
                 QKeyCombination(Qt::ControlModifier, Qt::Key_Z));
        QVERIFY(!keyAtItsPlace(pressed(Qt::Key_A, 24, "a"))); // French: A is where Q is
        QVERIFY(!keyAtItsPlace(pressed(Qt::Key_Exclam, 10, "!", Qt::ShiftModifier)));
        QVERIFY(!keyAtItsPlace(pressed(Qt::Key_Left, 113, {})));
        QVERIFY(!keyAtItsPlace(pressed(Qt::Key_Ampersand, 0, "&"))); // no place
    }
    void digitsAndLettersWorkOnFrenchAndGreekKeyboards()
    {
        ui::TestWindow test;
        test.show();
        test.open(test.twoLines());
        const auto press = [&](QKeyEvent event) {
            QCoreApplication::sendEvent(QApplication::focusWidget(), &event);
        };
        test.window->canvas().setFocus();
        press(pressed(Qt::Key_Ampersand, 10, "&"));
        QCOMPARE(test.window->session().display().variant.algorithm,
                 &clipping::algorithms().front());
        press(pressed(0x3BB, 46, "λ"));
        QVERIFY(test.window->canvas().tool() == "line");
        press(pressed(Qt::Key_QuoteDbl, 12, "\""));
        QCOMPARE(test.window->session().display().variant.algorithm, &clipping::algorithms()[2]);
        test.action("remove-window")->trigger();
        QCOMPARE(test.window->session().history.index(), 1);
        press(pressed(0x3B6, 52, "ζ", Qt::ControlModifier)); // Ctrl+Z
        QCOMPARE(test.window->session().history.index(), 0);
    }
};

} // namespace window_keyboard_test

TEST_CLASS(window_keyboard_test::KeyboardTest, Widgets)
#include "tests/ui/window/keyboard_test.moc"

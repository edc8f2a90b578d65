// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/digits.h"
#include "app/session/session.h"

#include <QTest>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace session_digits_test {

using app::DigitPlace, app::DigitUse;

class DigitsTest : public QObject {
    Q_OBJECT

private slots:
    /// Every combination, against the rule in words.
    void oneRuleEverywhere()
    {
        int algorithms = 0, numbers = 0, answers = 0;
        for (int bits = 0; bits < 32; ++bits) {
            const DigitPlace place{.question = bool(bits & 1),
                                   .gesture = bool(bits & 2),
                                   .numbers = bool(bits & 4),
                                   .draws = bool(bits & 8),
                                   .windowChosen = bool(bits & 16)};
            const DigitUse use = app::digitUse(place);
            const QByteArray where = "combination " + QByteArray::number(bits);
            algorithms += use == DigitUse::Algorithm;
            numbers += use == DigitUse::Number;
            answers += use == DigitUse::Answer;
            // In a lesson's question digits answer, and nothing else does.
            VERIFY_OR_SAY((use == DigitUse::Answer) == (place.question && !place.gesture), where);
            // They choose the algorithm outside gestures whenever a window is chosen or the
            // workspace is not Draw.
            VERIFY_OR_SAY(
                (use == DigitUse::Algorithm)
                    == (!place.question && !place.gesture && (place.windowChosen || !place.draws)),
                where);
            // A number is never begun where nothing takes one.
            VERIFY_OR_SAY(use != DigitUse::Number || place.numbers, where);
            // In a gesture that takes numbers they are its numbers.
            VERIFY_OR_SAY((use == DigitUse::Number) == place.numbers || !place.gesture, where);
        }
        QCOMPARE(algorithms, 6);
        QCOMPARE(answers, 8);
        QCOMPARE(numbers, 8 + 1); // in gestures, and in Draw of what was just drawn
    }
    void theLastChosenThingHasTheKeys()
    {
        app::Session session;
        app::Sheet sheet;
        sheet.window = {{0, 0}, {10, 10}};
        app::Shape line;
        line.paths = {{{1, 1}, {{{9, 9}}}}};
        line.style.stroke = app::Colour{};
        sheet.shapes = {line};
        load(session.document, sheet);
        QVERIFY(session.windowChosen());
        session.select({0});
        QVERIFY(!session.windowChosen());
        session.chooseWindow(0); // as a drag of it does
        QVERIFY(session.windowChosen());
        session.select({0}); // clicked again
        QVERIFY(!session.windowChosen());
        session.select({});
        QVERIFY(session.windowChosen());
        session.guide = 0;
        QVERIFY(!session.windowChosen());
        session.guide.reset();
        app::Edit edit;
        edit.windows = app::ClipWindows{};
        session.document.apply(edit);
        QVERIFY(!session.windowChosen());
    }
};

} // namespace session_digits_test

TEST_CLASS(session_digits_test::DigitsTest, Core)
#include "tests/app/session/digits_test.moc"

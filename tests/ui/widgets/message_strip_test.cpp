// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_strip.h"

#include <QTest>

#include "tests/test_class.h"

namespace widgets_message_strip_test {

using namespace ui;

namespace {

QString shownText(const MessageStrip& strip)
{
    return strip.isHidden() ? QString() : strip.findChild<QLabel*>()->text();
}

QStringList shownButtons(const MessageStrip& strip)
{
    QStringList texts;
    for (const auto* button : strip.findChildren<QPushButton*>())
        if (button->isVisibleTo(&strip))
            texts << button->text();
    return texts;
}

} // namespace

class MessageStripTest : public QObject {
    Q_OBJECT

private slots:
    void aQuestionHidesTheMessageUntilItIsAnswered()
    {
        MessageStrip strip;
        QStringList given;
        strip.tell({Message::Kind::Warning, "First.", "Do it", [] {}});
        const int asked = strip.ask(
            {"Save?", {{"Yes", [&] { given << "yes"; }}, {"No", [&] { given << "no"; }}}});
        QCOMPARE(shownText(strip), "Save?");
        QCOMPARE(shownButtons(strip), QStringList({"Yes", "No"}));
        QCOMPARE(strip.sentence(), "First.");
        strip.tell({Message::Kind::Warning, "Second."});
        QCOMPARE(shownText(strip), "Save?");
        strip.give(asked, 1);
        QCOMPARE(given, QStringList("no"));
        QCOMPARE(shownText(strip), "Second.");
        QVERIFY(!strip.asks() && shownButtons(strip).isEmpty());
        strip.give(asked, 0); // it has been answered
        QCOMPARE(given.size(), 1);
    }
    void aQuestionWaitsForALaterOne()
    {
        MessageStrip strip;
        QStringList given;
        const auto question = [&](const QString& what) {
            return StripQuestion{what, {{"Yes", [&given, what] { given << what; }}}};
        };
        const int first = strip.ask(question("First?"));
        const int second = strip.ask(question("Second?"));
        QCOMPARE(shownText(strip), "Second?");
        strip.give(first, 0); // withdrawn from below
        QCOMPARE(shownText(strip), "Second?");
        QTest::keyClick(&strip, Qt::Key_Escape);
        QCOMPARE(given, QStringList({"First?", "Second?"}));
        QVERIFY(strip.isHidden());
        strip.give(second, 0);
        QCOMPARE(given.size(), 2);
    }
    void anAnswerMayAskAgain()
    {
        MessageStrip strip;
        strip.ask({"First?", {{"On", [&] { strip.ask({"Second?", {{"Yes", [] {}}}}); }}}});
        QTest::mouseClick(strip.findChildren<QPushButton*>().last(), Qt::LeftButton);
        QCOMPARE(shownText(strip), "Second?");
        QCOMPARE(shownButtons(strip), QStringList("Yes"));
    }
};

} // namespace widgets_message_strip_test

TEST_CLASS(widgets_message_strip_test::MessageStripTest, Widgets)
#include "tests/ui/widgets/message_strip_test.moc"

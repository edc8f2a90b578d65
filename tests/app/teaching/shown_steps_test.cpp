// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/manual.h"
#include "app/teaching/shown_steps.h"

#include <QTest>

#include "tests/test_class.h"

namespace teaching_shown_steps_test {

using Kind = app::ShownStep::Kind;

class ShownStepsTest : public QObject {
    Q_OBJECT

private slots:
    void aPageIsRead()
    {
        const auto read = app::shownSteps("copy or landscape\n"
                                          "  command tool-window\n\n"
                                          "drag 10,20 -3,4.5 with Shift Alt \"Draw a window\"\n"
                                          "press Page to drawing\n"
                                          "type G 1,2 Tab Ctrl+D Roof Enter\n"
                                          "ends windows +1 objects 3 guides -1\n");
        QVERIFY2(read, qPrintable(read.error));
        const app::ShownSteps& steps = *read.value;
        QVERIFY(steps.inCopy);
        QCOMPARE(steps.sample, QString("landscape"));
        QCOMPARE(steps.steps.size(), 4U);
        QCOMPARE(steps.steps[0].command, QString("tool-window"));
        const app::ShownStep& drag = steps.steps[1];
        QVERIFY(drag.kind == Kind::Drag && drag.points.size() == 2);
        QCOMPARE(drag.points[1].y, 4.5);
        QCOMPARE(drag.with, Qt::ShiftModifier | Qt::AltModifier);
        QCOMPARE(drag.sentence, QString("Draw a window"));
        QCOMPARE(steps.steps[2].button, QString("Page to drawing"));
        QCOMPARE(steps.ends.size(), 3U);
        QVERIFY(steps.ends[0].isMore && !steps.ends[1].isMore && steps.ends[2].isMore);
    }

    // A word of one letter is a key; in others capitals are typed with Shift; some name a key.
    void keysAreThoseOfThePages()
    {
        const auto read = app::shownSteps("new\ntype G 1, Enter Ctrl+D Ro Space\nends objects 0");
        QVERIFY2(read, qPrintable(read.error));
        QList<QKeyCombination> keys;
        QString text;
        for (const auto& key : read.value->steps[0].keys) {
            keys << key.key;
            text += key.text;
        }
        QCOMPARE(keys, (QList<QKeyCombination>{Qt::Key_G, Qt::Key_1, Qt::Key_Comma, Qt::Key_Return,
                                               Qt::CTRL | Qt::Key_D, Qt::SHIFT | Qt::Key_R,
                                               Qt::Key_O, Qt::Key_Space}));
        QCOMPARE(text, QString("g1,Ro "));
    }

    void wrongLinesAreNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("wrong");
        const QString end = "\nends objects 1";
        for (const char* line :
             {"jump 1,2", "drag 1,2", "click 1", "click 1,x", "click 1e9,2", "click nan,2",
              "click 1,2 with Meta", "command", "command a b", "type", "press", "ends", "ends a",
              "ends a b", "click 1,2 3,4", "\"only said\""})
            QTest::newRow(line) << QString("new\n") + line + end << QString(line);
        QTest::newRow("place") << "somewhere else" + end << "somewhere else";
        QTest::newRow("behind the end") << "new\nclick 1,2" + end + "\nclick 3,4"
                                        << "click 3,4";
        QTest::newRow("endless line")
            << "new\ntype " + QString(5000, u'a') + end << "type " + QString(75, u'a');
        QTest::newRow("endless list")
            << "new" + QString("\nclick 1,2").repeated(500) + end << "click 1,2";
    }
    void wrongLinesAreNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, wrong);
        const auto read = app::shownSteps(text);
        QVERIFY(!read);
        QCOMPARE(read.error,
                 QString("The steps of this page cannot be shown: \"%1\" is not understood.")
                     .arg(wrong));
    }
    void whatIsNotCompleteIsRefused()
    {
        for (const char* text : {"", "\n\n", "new", "new\nclick 1,2", "new\nends objects 1"})
            QVERIFY2(app::shownSteps(text).error.endsWith("they are not complete."), text);
    }

    void pagesAreLargeEnoughForAllPoints()
    {
        const auto read = app::shownSteps("new\ndrag 1,2 100,50\nends objects 1");
        QVERIFY(read.value->fitOn({100, 50}));
        QVERIFY(!read.value->fitOn({99, 50}) && !read.value->fitOn({100, 49}));
    }

    void everyPageIsUnderstood()
    {
        int pages = 0;
        for (const QString& topic : app::manualTopics()) {
            const auto page = app::manualPage(topic);
            if (page->shows.isEmpty())
                continue;
            const auto read = app::shownSteps(page->shows);
            QVERIFY2(read, qPrintable(topic + ": " + read.error));
            QVERIFY(!app::placeOfSteps(page->shows, app::newDrawing()).isEmpty());
            ++pages;
        }
        QVERIFY(pages > 30);
    }
};

} // namespace teaching_shown_steps_test

TEST_CLASS(teaching_shown_steps_test::ShownStepsTest, Gui)
#include "tests/app/teaching/shown_steps_test.moc"

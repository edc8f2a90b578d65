// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/check_lesson.h"
#include "app/lessons/parse_lesson.h"

#include <QTest>

#include "tests/test_class.h"

namespace lessons_parse_lesson_test {

namespace {

constexpr auto head = "# T\n> S\n:: look cs line -160,-30 70,130 window -100,-75 100,75\n";

/// "3: sentence" of each fault, from both the parser and the check.
QStringList faultsOfText(const QString& text)
{
    const auto parsed = app::parseLesson(QStringLiteral("x"), text);
    auto faults = parsed.faults;
    if (faults.empty())
        faults = app::faultsOf(parsed);
    QStringList all;
    for (const app::LessonFault& fault : faults)
        all << QStringLiteral("%1: %2").arg(fault.line).arg(fault.sentence);
    return all;
}

} // namespace

class ParseLessonTest : public QObject {
    Q_OBJECT

private slots:
    void everyLessonOfTheProgramIsFaultless()
    {
        for (const app::Lesson& lesson : app::lessons()) {
            QFile file(QStringLiteral(":/lessons/%1.md").arg(lesson.key));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            QVERIFY2(text.contains(QStringLiteral("\n:: version 1\n")), qPrintable(lesson.key));
            QCOMPARE(faultsOfText(text), QStringList());
        }
    }
    void eachFaultHasItsLineAndAllAreNamed()
    {
        const QStringList faults = faultsOfText(
            "# T\n:: look nobody line 0,0 1,1 window 0,0 1,1\n:: dance\n:: step seven\n"
            "![](/dev/zero)\n:: ask what\n:: ask edge\n");
        QCOMPARE(faults.size(), 6);
        const QStringList starts{"2: There is no algorithm “nobody”.",
                                 "3: “:: dance” is no",
                                 "4: “seven” names no step.",
                                 "5: A picture stands on a line",
                                 "6: There is no question “:: ask what”.",
                                 "7: A page asks at most"};
        for (int i = 0; i < faults.size(); ++i)
            QVERIFY2(faults[i].startsWith(starts[i]), qPrintable(faults[i]));
    }
    void whatOnlyTheLineShowsIsNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("fault");
        const auto row = [](const char* name, const QString& text, const QString& fault) {
            QTest::newRow(name) << text << fault;
        };
        row("part", "# T\n:: look cs line 0,0 1,1 window -100,-75 100,75\nText.\n:: ask part\n",
            "4: “:: ask part” needs a line that the window cuts twice.");
        row("region", QString(head) + "Text.\n:: ask region 3\n",
            "5: “:: ask region” needs the number of an end, 1 or 2.");
        row("step", QString(head) + ":: step cut-9\nText.\n", "4: The ");
        row("window", "# T\n:: look cs line 0,0 1,1 window 9,9 1,1\nText.\n",
            "2: The line cannot be shown. ");
        row("nan", "# T\n:: look cs line 0,0 nan,1 window 1,1 9,9\nText.\n",
            "2: The line cannot be shown. ");
        row("family", QString(head) + ":: draw corner\nText.\n:: ask part\n",
            "4: “:: draw corner” finds no line");
    }
    void whatOnlyTheLineShowsIsNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, fault);
        const QStringList faults = faultsOfText(text);
        QCOMPARE(faults.size(), 1);
        QVERIFY2(faults[0].startsWith(fault), qPrintable(faults[0]));
    }
    void versionsAreRead()
    {
        QCOMPARE(faultsOfText(":: version 1\n" + QString(head) + "Text.\n"), QStringList());
        QVERIFY(
            faultsOfText(":: version 2\n" + QString(head) + "Text.\n")
                .join(u' ')
                .startsWith("1: This lesson has version 2, and this Clearcut reads version 1."));
        for (const char* bad : {"", " 0", " -1", " x", " 1 2", " 99999999999"})
            QVERIFY2(faultsOfText(QStringLiteral(":: version%1\n").arg(bad) + head + "Text.\n")
                         .join(u' ')
                         .startsWith("1: Write the version"),
                     bad);
    }
    void linesMayEndAsOnWindows()
    {
        QCOMPARE(faultsOfText(QString(QString(head) + "Text.\n---\nMore.\n").replace("\n", "\r\n")),
                 QStringList());
    }
    void tenThousandQuestionsAreOneSentence()
    {
        QString text = head;
        for (int i = 0; i < 10'000; ++i)
            text += QStringLiteral("Text.\n:: ask visible\n---\n");
        const QStringList faults = faultsOfText(text + "End.");
        QCOMPARE(faults.size(), 1);
        QVERIFY2(faults[0].contains("at most 100 pages"), qPrintable(faults[0]));
    }
    void otherTextIsNoLesson()
    {
        QCOMPARE(faultsOfText("# Notes\n\nBuy chalk.\n").size(), 1);
        QCOMPARE(faultsOfText("").size(), 1);
    }
    void aFileOfFaultsEnds()
    {
        QCOMPARE(faultsOfText(QString(":: x\n").repeated(100'000)).size(), 21); // and no title
        const QStringList faults = faultsOfText(QString(head) + QString("word ").repeated(100'000));
        QVERIFY2(faults.join(u' ').contains("at most 10,000 characters"), qPrintable(faults[0]));
        for (const QString& fault : faultsOfText(":: " + QString(100'000, u'y')))
            QVERIFY(fault.size() < 300);
    }
};

} // namespace lessons_parse_lesson_test

TEST_CLASS(lessons_parse_lesson_test::ParseLessonTest, Core)
#include "tests/app/lessons/parse_lesson_test.moc"

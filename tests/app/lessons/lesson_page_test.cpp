// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"
#include "app/lessons/lesson_page.h"
#include "app/lessons/markdown_html.h"
#include "app/lessons/parse_lesson.h"

#include <QRegularExpression>
#include <QTest>

#include "tests/test_class.h"

namespace lessons_lesson_page_test {

namespace {

app::Lesson lessonOf(const QString& text)
{
    return app::parseLesson(QStringLiteral("x"),
                            "# T\n> S\n:: look cs line -160,-30 70,130 window -100,-75 100,75\n"
                                + text)
        .lesson;
}

} // namespace

class LessonPageTest : public QObject {
    Q_OBJECT

private slots:
    void everyLessonIsOnePageThatNeedsNothing()
    {
        for (const app::Lesson& lesson : app::lessons()) {
            const auto html = app::lessonHtml(lesson);
            QVERIFY2(html, qPrintable(html.error));
            const QString page = QString::fromUtf8(*html.value);
            QVERIFY2(html.value->size() <= app::mostLessonPageBytes, qPrintable(lesson.key));
            QCOMPARE(page.count(u"<article "), qsizetype(lesson.pages.size()));
            static const QRegularExpression outside(
                QStringLiteral("(src|href)=\"(?!data:)|url\\(|@import|https?:(?!//www\\.w3)"));
            const auto found = outside.match(page);
            QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
            QVERIFY(page.contains("<h1>" + lesson.title.toHtmlEscaped()));
            // Each page that asks does so about at least one line, and each line has its answer.
            QVERIFY(page.count(u"class=\"ask\"") >= app::questionsOf(lesson));
            QCOMPARE(page.count(u"class=\"ask\""), page.count(u"data-right="));
            QVERIFY(page.contains(QStringLiteral("\"needed\":%1").arg(app::neededRight(lesson))));
            QCOMPARE(*app::lessonHtml(lesson).value, *html.value);
        }
    }
    void theRightChoiceIsTheLibrarys()
    {
        const auto page = QString::fromUtf8(
            *app::lessonHtml(lessonOf(QStringLiteral("Text.\n:: ask part\nTold."))).value);
        const auto right =
            QRegularExpression(QStringLiteral("data-right=\"(\\d)\"")).match(page).captured(1);
        static const QRegularExpression choice(QStringLiteral("class=\"choice\">([^<]+)<"));
        auto choices = choice.globalMatch(page);
        QStringList all;
        while (choices.hasNext())
            all << choices.next().captured(1);
        QCOMPARE(all.size(), 3);
        QCOMPARE(all.value(right.toInt()), "From the left edge to the top edge");
        QVERIFY(page.contains("<div class=\"told\" hidden>\n<p>Told.</p>"));
    }
    void anOpenQuestionShowsNoLaterStep()
    {
        const auto html =
            *app::lessonHtml(
                 lessonOf(QStringLiteral(":: step last\n:: shows steps\nText.\n:: ask part\n")))
                 .value;
        const auto asked = html.indexOf("class=\"asked\""),
                   answered = html.indexOf("class=\"answered\"");
        QVERIFY(asked > 0 && answered > asked);
        QVERIFY(!html.mid(asked, answered - asked).contains("class=\"sentence\""));
        QVERIFY(html.mid(answered).contains("class=\"sentence\""));
    }
    void textsAreEscaped()
    {
        const auto html =
            *app::lessonHtml(
                 lessonOf(QStringLiteral("<script>alert(1)</script> **a<b** [x](http://y)\n")))
                 .value;
        QVERIFY(!html.contains("<script>alert") && !html.contains("http://y"));
        QVERIFY(html.contains("&lt;script&gt;alert(1)"));
    }
    void markdownIsUnderstood()
    {
        QCOMPARE(
            app::markdownHtml(QStringLiteral("One **b** *i* `c`\n\n- x\n- y\n\n1. z\n\nEnd & <b>")),
            QByteArray("<p>One <strong>b</strong> <em>i</em> <code>c</code></p>\n<ul>\n"
                       "<li>x</li>\n<li>y</li>\n</ul>\n<ol>\n<li>z</li>\n</ol>\n"
                       "<p>End &amp; &lt;b&gt;</p>\n"));
    }
    void aLessonThatIsTooLongSaysSo()
    {
        QString text;
        for (int i = 0; i < 99; ++i)
            text += QString("word ").repeated(1000) + "\n:: ask visible\n---\n";
        const auto html = app::lessonHtml(lessonOf(text + "End."));
        QVERIFY(!html);
        QVERIFY2(html.error.contains("300 kB"), qPrintable(html.error));
    }
};

} // namespace lessons_lesson_page_test

TEST_CLASS(lessons_lesson_page_test::LessonPageTest, Gui)
#include "tests/app/lessons/lesson_page_test.moc"

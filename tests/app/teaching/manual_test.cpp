// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/manual.h"

#include <QDir>
#include <QRegularExpression>
#include <QTest>

#include "tests/test_class.h"

namespace teaching_manual_test {

class ManualTest : public QObject {
    Q_OBJECT

    static QStringList files(const QString& folder)
    {
        return QDir(QStringLiteral(SOURCE_DIR "/resources/manual/") + folder)
            .entryList(QDir::Files | QDir::NoDotAndDotDot);
    }

private slots:
    void everyPageIsInTheIndexOnce()
    {
        const QStringList topics = app::manualTopics();
        QCOMPARE(topics.first(), app::manualIndex);
        QCOMPARE(QSet<QString>(topics.begin(), topics.end()).size(), topics.size());
        QStringList expected, listed;
        for (const QString& name : files({}))
            if (name.endsWith(QStringLiteral(".md")))
                expected << name.chopped(3);
        listed = topics;
        listed.sort();
        QCOMPARE(listed, expected);
        QVERIFY(topics.size() > 30);
    }

    void everyPageHasATitle_data()
    {
        QTest::addColumn<QString>("topic");
        for (const QString& topic : app::manualTopics())
            QTest::newRow(qPrintable(topic)) << topic;
    }
    void everyPageHasATitle()
    {
        QFETCH(QString, topic);
        const auto page = app::manualPage(topic);
        QVERIFY(page.has_value());
        QVERIFY(page->markdown.startsWith("# "));
        QVERIFY(!page->title.isEmpty());
        QVERIFY(!page->markdown.contains("<!--"));
    }

    void everyLinkLeadsSomewhere_data() { everyPageHasATitle_data(); }
    void everyLinkLeadsSomewhere()
    {
        QFETCH(QString, topic);
        static const QRegularExpression link(QStringLiteral("\\]\\(([^)\\s]+)\\)"));
        const auto page = app::manualPage(topic);
        QVERIFY(page.has_value());
        for (auto links = link.globalMatch(page->markdown); links.hasNext();) {
            const QString target = links.next().captured(1);
            const bool known = target.startsWith("https://") || target.startsWith("sample:")
                               || QFile::exists(":/manual/" + target)
                               || !app::topicOfPage(target.section('#', 0, 0)).isEmpty();
            QVERIFY2(known, qPrintable(target));
        }
    }

    void everyPictureIsShown()
    {
        QString all;
        for (const QString& topic : app::manualTopics())
            all += app::manualPage(topic)->markdown;
        const QStringList pictures = files(QStringLiteral("pictures"));
        QVERIFY(!pictures.isEmpty());
        for (QString picture : pictures) {
            const bool isDark = picture.endsWith("-dark.png"); // beside the light one
            QVERIFY(!isDark || pictures.contains(QString(picture).replace("-dark", "")));
            picture.replace("-dark.png", ".png");
            QVERIFY2(all.contains("](pictures/" + picture + ')'), qPrintable(picture));
        }
    }

    void onlyNamesOfPagesAreTopics()
    {
        QCOMPARE(app::topicOfPage("snapping.md"), QStringLiteral("snapping"));
        for (const char* other : {"", "snapping", ".md", "no-such-page.md", "skala.md"})
            QCOMPARE(app::topicOfPage(other), QString());
        QVERIFY(!app::manualPage("no-such-page"));
        QVERIFY(!app::manualPage("../algorithms/skala"));
    }

    void aTerminalShowsWords()
    {
        const app::ManualPage page{"a", "Title",
                                   "# Title\nPress **Esc** or *Edit* > *Undo*, see\n"
                                   "[the grid](grid.md).\n\n![Grid](pictures/grid.png)\n\n"
                                   "`3*25mm` and 2 * 3 * 4\n"};
        QCOMPARE(app::plainText(page), QStringLiteral("# Title\nPress Esc or Edit > Undo, see\n"
                                                      "the grid (grid).\n\n"
                                                      "`3*25mm` and 2 * 3 * 4\n\n"));
    }
};

} // namespace teaching_manual_test

TEST_CLASS(teaching_manual_test::ManualTest, None)
#include "tests/app/teaching/manual_test.moc"

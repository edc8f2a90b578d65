// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/help_search.h"
#include "app/teaching/manual.h"

#include <QTest>

#include "tests/test_class.h"

namespace teaching_help_search_test {

namespace {

const app::HelpCommands& commands()
{
    static const app::HelpCommands all{{"crop", {"Crop to windows", {"Ctrl+Shift+X"}}},
                                       {"group", {"Group", {"Ctrl+G"}}},
                                       {"rotate", {"Rotate", {"O"}}},
                                       {"delete", {"Delete", {"Del"}}},
                                       {"ungroup", {"Ungroup", {"Ctrl+Shift+G"}}}};
    return all;
}

QStringList links(const QString& typed)
{
    QStringList found;
    for (const app::HelpHit& hit : app::searchHelp(typed, commands()))
        found << hit.page->link;
    return found;
}

} // namespace

class HelpSearchTest : public QObject {
    Q_OBJECT

private slots:
    void theContentsHaveEveryPageOnce()
    {
        QStringList listed;
        for (const app::HelpPart& part : app::helpContents()) {
            QVERIFY(!part.title.isEmpty() && !part.pages.empty());
            for (const app::HelpPage& page : part.pages) {
                QVERIFY2(!page.title.isEmpty() && page.text.size() > 100, qPrintable(page.link));
                listed << page.link;
            }
        }
        QStringList expected;
        for (const QString& topic : app::manualTopics().mid(1))
            expected << topic + ".md";
        for (const clipping::Algorithm& algorithm : clipping::algorithms())
            expected << QString::fromLatin1(algorithm.key.data(), qsizetype(algorithm.key.size()))
                            + ".md";
        QCOMPARE(listed, expected);
    }

    void theTextsAreWords()
    {
        for (const app::HelpPart& part : app::helpContents())
            for (const app::HelpPage& page : part.pages)
                for (const char* sign : {"<!--", "](", "**", "explains:", "\n"})
                    QVERIFY2(!page.text.contains(sign), qPrintable(page.link + " has " + sign));
    }

    void titlesComeBeforeCommandsBeforeTexts()
    {
        QCOMPARE(links("snapping").value(0), QStringLiteral("snapping.md"));
        QVERIFY(links("snapping").size() > 3); // others name it
        const QStringList crop = links("crop");
        QCOMPARE(crop.value(0), QStringLiteral("cutting.md"));
        QVERIFY(crop.size() > 1);
        QCOMPARE(app::searchHelp("crop", commands()).front().why,
                 QStringLiteral("Crop to windows (Ctrl+Shift+X)"));
    }

    void questionsAreAnswered()
    {
        const auto isAmongFirst = [](const QString& question, const char* page) {
            return links(question)
                .first(std::min<qsizetype>(3, links(question).size()))
                .contains(QString(page));
        };
        QVERIFY(isAmongFirst("how to turn something", "transform.md"));
        QVERIFY(isAmongFirst("make the paper bigger", "page.md"));
        QVERIFY(isAmongFirst("get the drawing into a laser cutter", "export.md"));
        QVERIFY(isAmongFirst("how do I print on several sheets", "printing.md"));
        QCOMPARE(links("how to"), links("how to")); // nothing but fillers is sought as it is
        QVERIFY(links("print zzyzx").contains("printing.md")); // of two words one may be missing
        QVERIFY(links("zzyzx").isEmpty() && links("the zzyzx").isEmpty());
    }

    void keysAreFoundWhole()
    {
        QCOMPARE(links("Ctrl+G").value(0), QStringLiteral("groups.md"));
        QCOMPARE(app::searchHelp("ctrl+g", commands()).front().why,
                 QStringLiteral("Group (Ctrl+G)"));
        QCOMPARE(app::searchHelp("Ctrl+Shift+G", commands()).front().why,
                 QStringLiteral("Ungroup (Ctrl+Shift+G)"));
    }

    void anExcerptHasTheWordsAround()
    {
        const auto hits = app::searchHelp("outcode", commands());
        QVERIFY(!hits.empty());
        for (const app::HelpHit& hit : hits) {
            if (hit.page->title.contains("outcode", Qt::CaseInsensitive))
                continue;
            QVERIFY2(hit.why.contains("outcode", Qt::CaseInsensitive), qPrintable(hit.why));
            QVERIFY(hit.why.size() < 130);
        }
    }

    void everyWordMustBeThereIfAnyPageHasAll()
    {
        QVERIFY(links("grid isometric").contains("grid.md"));
        QVERIFY(links("grid isometric").size() < links("grid").size());
        QVERIFY(links("grid zebra") != links("zebra") && links("zebra yak grid").isEmpty());
        for (const QString& nothing : {QString(), QStringLiteral("  "), QStringLiteral("xyzzy")})
            QVERIFY(links(nothing).isEmpty());
    }

    // A newcomer's words.
    void otherWordsFindThePage()
    {
        for (const char* word : {"turn", "spin", "Turn", "rotate"})
            QCOMPARE(links(word).value(0), QString("transform.md"));
        for (const char* word : {"erase", "trash"})
            QCOMPARE(links(word).value(0), QString("select.md"));
        QVERIFY(links("oval").contains("shapes.md")); // in the text
        for (const char* word : {"stretch", "mirror", "tutorial", "freehand", "vertex"})
            QVERIFY2(!links(word).isEmpty(), word);
    }

    void hostileTextFindsNothing()
    {
        for (const QString& typed : {QString(100'000, u'a'), QStringLiteral("[("),
                                     QStringLiteral("\\"), QString(QChar::Null)})
            QVERIFY(links(typed).size() < 5);
        // Only the beginning of an endless text is sought.
        const QString word = QStringLiteral("snapping") + QString(300, u' ');
        QCOMPARE(links(word + "zebra"), links("snapping"));
    }
};

} // namespace teaching_help_search_test

TEST_CLASS(teaching_help_search_test::HelpSearchTest, None)
#include "tests/app/teaching/help_search_test.moc"

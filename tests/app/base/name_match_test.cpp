// SPDX-License-Identifier: GPL-3.0-or-later
// What is found by a few letters, and which of it comes first.
#include "app/base/name_match.h"

#include <QTest>

#include <random>

#include "tests/test_class.h"

namespace base_name_match_test {

using app::matchName;
using Letters = QList<qsizetype>;

class NameMatchTest : public QObject {
    Q_OBJECT

private slots:
    void theBestComesFirst()
    {
        const QStringList names{"Start panel",          // begins with it
                                "Show start panel",     // a word does
                                "Restart",              // contains it
                                "Show the arrow tool"}; // its letters
        int before = 1000;
        for (const QString& name : names) {
            const auto match = matchName("start", name);
            QVERIFY2(match, qPrintable(name));
            QVERIFY2(match->score < before, qPrintable(name));
            before = match->score;
        }
    }
    void americanSpellingsFindBritishOnes()
    {
        QVERIFY(matchName("color", "Same colour"));
        QVERIFY(matchName("take Color", "Take stroke colour"));
        QCOMPARE(matchName("center", "Line at the centre")->letters,
                 (Letters{12, 13, 14, 15, 16, 17}));
        QCOMPARE(matchName("color", "color wheel")->score,
                 matchName("colour", "colour wheel")->score);
        QVERIFY(!matchName("colt", "Same colour"));
    }
    void theLettersAreThoseThatWereTyped()
    {
        QCOMPARE(matchName("cut", "Draw and cut out")->letters, (Letters{9, 10, 11}));
        QCOMPARE(matchName("out cut", "Cut out windows")->letters, (Letters{0, 1, 2, 4, 5, 6}));
        QCOMPARE(matchName("sal", "Select all")->letters, (Letters{0, 7, 8}));
        QCOMPARE(matchName("seal", "Select all")->letters, (Letters{0, 1, 7, 8}));
        QCOMPARE(matchName("a b a", "Ab")->letters, (Letters{0, 1}));
    }
    void wordsComeInAnyOrder()
    {
        QVERIFY(matchName("window on page", "On page: lay a window"));
        QVERIFY(!matchName("window on map", "On page: lay a window"));
        QVERIFY(matchName("out cut", "Cut out")->score > matchName("ut ou", "Cut out")->score);
    }
    void lettersBeginAtAWord()
    {
        QVERIFY(matchName("gp", "Go to the page"));
        QVERIFY(!matchName("ht", "Go to the page")); // no word begins with h
        QVERIFY(!matchName("rot", "Reset layout"));
        QVERIFY(matchName("cob", "Copy object")); // the o is not that of Copy
        QVERIFY(!matchName("gpx", "Go to the page"));
    }
    void nothingTypedFitsAll()
    {
        QVERIFY(matchName("", "Anything")->letters.isEmpty());
        QVERIFY(matchName("  ", ""));
        QVERIFY(!matchName("a", ""));
    }
    void whateverIsTyped()
    {
        std::mt19937_64 random(3);
        const QString signs = QStringLiteral("abAB .-ßİ\u0300€");
        const auto text = [&](std::size_t most) {
            QString made;
            for (std::size_t i = random() % (most + 1); i > 0; --i)
                made += signs[qsizetype(random() % std::size_t(signs.size()))];
            return made;
        };
        for (int i = 0; i < 50'000; ++i) {
            const QString typed = text(4), name = text(12);
            const auto match = matchName(typed, name);
            if (name.contains(typed.simplified(), Qt::CaseInsensitive))
                QVERIFY(match);
            if (!match)
                continue;
            for (qsizetype k = 0; k < match->letters.size(); ++k) {
                QVERIFY(match->letters[k] >= 0 && match->letters[k] < name.size());
                QVERIFY(k == 0 || match->letters[k - 1] < match->letters[k]);
            }
        }
    }
};

} // namespace base_name_match_test

TEST_CLASS(base_name_match_test::NameMatchTest, None)
#include "tests/app/base/name_match_test.moc"

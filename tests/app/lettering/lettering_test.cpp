// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"

#include <QTest>

#include <limits>
#include <numbers>
#include <set>

#include "tests/test_class.h"

namespace lettering_lettering_test {

using namespace app;

class LetteringTest : public QObject {
    Q_OBJECT

    static TextRecipe text(const char* words, double size = 21, const Point& at = {0, 0})
    {
        return {QString::fromUtf8(words), strokeFonts().front().name, size, at};
    }
    static std::vector<Subpath> paths(const char* words) { return lettered(text(words)).paths; }
    static double left(const std::vector<Subpath>& paths)
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Subpath& path : paths)
            least = std::min(least, path.start.x);
        return least;
    }

private slots:
    void lettersStandOnTheBaseline()
    {
        const std::vector<Subpath> wanted{{{14, 9}, {{{14, 30}}}}, {{14, 30}, {{{26, 30}}}}};
        QVERIFY(lettered(text("L", 21, {10, 30})).paths == wanted);
        const auto large = lettered(text("L", 42, {10, 30})).paths;
        QVERIFY(large.front().start == Point(18, -12));
    }
    void lettersFollowEachOther()
    {
        const auto two = paths("LT"); // L takes 17, T the 8 to its middle
        QCOMPARE(two.size(), std::size_t(4));
        QVERIFY(two[2].start == Point(25, -21));
    }
    void aLineBreakBeginsBelow()
    {
        const auto lines = paths("L\nL");
        QCOMPARE(lines.size(), std::size_t(4));
        QVERIFY(lines[2].start == lines[0].start + Point(0, 21 * linePitch));
    }
    void everyFontHasEveryAsciiCharacter()
    {
        QVERIFY2(!hersheyGlyphs("futural").empty(), "install the package hershey-fonts-data");
        std::set<QString> names;
        for (const StrokeFont& font : strokeFonts()) {
            names.insert(font.name);
            for (char32_t c = ' '; c <= U'~'; ++c)
                QVERIFY2(glyphOf(c, font).glyph, qPrintable(font.name + QString::number(c)));
        }
        QCOMPARE(names.size(), strokeFonts().size());
    }
    void alphabetsAreWhole_data()
    {
        QTest::addColumn<QString>("letters");
        QTest::newRow("Greek") << "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρσςτυφχψω";
        QTest::newRow("Greek with accents") << "ΆΈΉΊΌΎΏάέήίόύώϊϋΐΰ";
        QTest::newRow("Cyrillic")
            << "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдеёжзийклмнопрстуфхцчшщъыьэюя";
        QTest::newRow("signs") << "±¹²³½¼¾⌀∅…€£§©®≤≥≠≈√";
        QTest::newRow("composed") << "ØøÆæŒœßŁłĐđ";
        QTest::newRow("Western") << "ÄÖÜäöüÀÉÊÎÕÑàéêîõñÅåÇçŠšŽžŐő°×÷·–—“”‘’";
    }
    void alphabetsAreWhole()
    {
        QFETCH(QString, letters);
        for (const StrokeFont& font : strokeFonts()) {
            const Lettering made = lettered({letters, font.name, 5, {0, 0}});
            QVERIFY2(made.missing.isEmpty(), qPrintable(made.missing.join(' ')));
        }
    }
    void lettersWithTheSameLookAreFoundInTheirOwnAlphabet()
    {
        QVERIFY(paths("Γ") != paths("G"));
        QVERIFY(paths("Λ") != paths("L"));
        QVERIFY(paths("Ж") != paths("J"));
        QVERIFY(paths("й") != paths("и"));
        QVERIFY(paths("ά") != paths("α"));
    }
    void anAccentTakesNoRoom()
    {
        const auto plain = paths("aL"), accented = paths("áL");
        QCOMPARE(accented.size(), plain.size() + 1);
        QVERIFY(accented.back() == plain.back());
        QVERIFY(left(paths("Áa")) == left(paths("Aa")));
    }
    void aSignIsMadeOfTheLettersOfItsFont()
    {
        QCOMPARE(paths("Ø").size(), paths("O").size() + 1);
        const auto highest = [](const std::vector<Subpath>& all) {
            double top = 0;
            for (Subpath path : all)
                forEachPoint(path, [&](const Point& p) { top = std::min(top, p.y); });
            return top;
        };
        QVERIFY(std::abs(highest(paths("m²")) - highest(paths("H"))) < 0.3);
    }
    void missingLettersAreNamedAndStandAsBoxes()
    {
        const Lettering made = lettered(text("a漢b漢c₿"));
        QCOMPARE(made.missing, (QStringList{"漢", "₿"}));
        QCOMPARE(made.paths.size(), paths("abc").size() + 3);
        QVERIFY(missingText(made).contains("漢, ₿"));
        QCOMPARE(missingText(lettered(text("abc"))), QString());
    }
    void hostileTextsAreEmpty()
    {
        const double inf = std::numeric_limits<double>::infinity(),
                     nan = std::numeric_limits<double>::quiet_NaN();
        for (const double size : {0.0, -1.0, inf, nan, 1e299})
            QVERIFY(lettered(text("a", size)).paths.empty());
        QVERIFY(lettered(text("a", 1, {nan, 0})).paths.empty());
        QVERIFY(lettered({"a", "no such font", 1, {}}).paths.empty());
        QVERIFY(
            lettered({QString(longestText + 1, 'a'), strokeFonts()[0].name, 1, {}}).paths.empty());
        QVERIFY(lettered(text("")).paths.empty());
        QVERIFY(lettered(text("  \n ")).paths.empty());
    }
    void aTurnedTextGoesAlongItsLine()
    {
        TextRecipe turned = text("L", 21, {10, 30});
        turned.turn = std::numbers::pi / 2; // down the page
        auto made = lettered(turned).paths;
        QCOMPARE(made.size(), std::size_t(2));
        QVERIFY(made[0].start == Point(31, 34) && made[0].segments[0].to == Point(10, 34));
        QVERIFY(made[1].segments[0].to == Point(10, 46));
        turned.turn = 0;
        turned.mirrored = true; // below the line
        made = lettered(turned).paths;
        QVERIFY(made[0].start == Point(14, 51) && made[1].segments[0].to == Point(26, 30));
    }
    void withoutAScreenThereAreNoInstalledFonts()
    {
        QVERIFY(outlineFonts().isEmpty());
        QCOMPARE(fontInsteadOf("No such font"), strokeFonts().front().name);
    }
    void itsPathsAreRecognised()
    {
        const TextRecipe recipe = text("Ab", 3, {10, 20});
        auto made = lettered(recipe).paths;
        QVERIFY(makes(recipe, made));
        made[1].start.x += 1e-12;
        QVERIFY(makes(recipe, made));
        made[1].start.x += 1e-3;
        QVERIFY(!makes(recipe, made));
        QVERIFY(!makes(recipe, lettered(text("Ac", 3, {10, 20})).paths));
    }
};

} // namespace lettering_lettering_test

TEST_CLASS(lettering_lettering_test::LetteringTest, Core)
#include "tests/app/lettering/lettering_test.moc"

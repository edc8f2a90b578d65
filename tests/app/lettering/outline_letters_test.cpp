// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "app/view/outline.h"

#include <QRawFont>
#include <QTest>

#include <algorithm>

#include "tests/test_class.h"

namespace lettering_outline_letters_test {

using namespace app;

// Any font that is installed will do.
class OutlineLettersTest : public QObject {
    Q_OBJECT

    static QRawFont raw(const QString& family) { return QRawFont::fromFont(QFont(family)); }
    static QString latinFont()
    {
        const auto found = std::ranges::find_if(outlineFonts(), [](const QString& family) {
            const QRawFont font = raw(family);
            return font.supportsCharacter(U'H') && font.supportsCharacter(U'o')
                   && !font.pathForGlyph(font.glyphIndexesForString("o").value(0)).isEmpty();
        });
        return found == outlineFonts().end() ? QString() : *found;
    }
    TextRecipe text(const QString& words, double size = 10) const
    {
        return {words, font_, size, {5, 20}};
    }
    static QRectF box(const std::vector<Subpath>& paths)
    {
        return painterPath(paths, FillRule::NonZero).boundingRect();
    }
    static bool near(double a, double b, double off) { return std::abs(a - b) <= off; }

    QString font_;

private slots:
    void init()
    {
        font_ = latinFont();
        if (font_.isEmpty())
            QSKIP("no font with Latin letters is installed");
    }
    void capitalsHaveTheSizeAndStandOnTheBaseline()
    {
        const QRectF h = box(lettered(text("H")).paths);
        QVERIFY(near(h.bottom(), 20, 0.3) && near(h.top(), 10, 0.5));
        QVERIFY(h.left() > 4 && h.left() < 9);
        const QRectF large = box(lettered(text("H", 20)).paths);
        QVERIFY(near(large.height(), 2 * h.height(), 1e-9));
        const QRectF lower = box(lettered(text("H\nH")).paths);
        QVERIFY(near(lower.bottom() - h.bottom(), 10 * linePitch, 1e-9));
    }
    void outlinesAreClosedAndHaveCurvesAndHoles()
    {
        const auto paths = lettered(text("Ho")).paths;
        QVERIFY(paths.size() >= 3);
        bool curved = false;
        for (const Subpath& path : paths) {
            QVERIFY(path.closed && !path.segments.empty());
            const PathSegment& last = path.segments.back();
            QVERIFY(last.curved || last.to != path.start);
            for (const PathSegment& s : path.segments)
                curved = curved || s.curved;
        }
        QVERIFY(curved);
        const auto o = painterPath(lettered(text("o")).paths, FillRule::NonZero);
        QVERIFY(!o.contains(o.boundingRect().center()));
    }
    void lettersFollowEachOther()
    {
        const QRectF one = box(lettered(text("H")).paths), two = box(lettered(text("HH")).paths);
        QVERIFY(two.width() > 1.8 * one.width() && near(two.height(), one.height(), 1e-9));
        const auto spaced = box(lettered(text("H H")).paths);
        QVERIFY(spaced.width() > two.width());
        QVERIFY(box(lettered(text("H\tH")).paths) == spaced);
        QVERIFY(lettered(text(" \n ")).paths.empty());
    }
    void aLongLineDoesNotWrap()
    {
        const QRectF all = box(lettered(text(QString(longestText, 'H'))).paths);
        QVERIFY(near(all.bottom(), box(lettered(text("H")).paths).bottom(), 1e-9));
        QVERIFY(all.width() > double(longestText) * 3);
        QVERIFY(lettered(text(QString(longestText + 1, 'H'))).paths.empty());
    }
    void missingLettersAreNamedAndStandAsBoxes()
    {
        const std::u32string rare = U"\U00013000\U00012000\U00010900漢\u0F40";
        const auto lacks = [&](char32_t c) { return !raw(font_).supportsCharacter(c); };
        const auto c = std::ranges::find_if(rare, lacks);
        if (c == rare.end())
            QSKIP("the font has every letter");
        const QString letter = QString::fromUcs4(&*c, 1);
        const Lettering made = lettered(text("H" + letter + "H" + letter));
        QCOMPARE(made.missing, QStringList{letter});
        QVERIFY(missingText(made).contains(letter));
        QVERIFY(made.paths.size() > lettered(text("HH")).paths.size());
        QVERIFY(lettered(text("H")).missing.isEmpty());
    }
    void textsStayTextsUnderMapsThatKeepAngles_data()
    {
        QTest::addColumn<AffineMap>("map");
        QTest::newRow("turned") << rotation(20, {3, 4});
        QTest::newRow("quarter") << rotation(90, {3, 4});
        QTest::newRow("half") << scaling({-1, -1}, {3, 4});
        QTest::newRow("flipped") << scaling({-2, 2}, {0, 0});
        QTest::newRow("upside down") << scaling({1, -1}, {1, 7});
        QTest::newRow("moved") << translation({0.1, 7});
    }
    void textsStayTextsUnderMapsThatKeepAngles()
    {
        QFETCH(AffineMap, map);
        for (const QString& font : {font_, strokeFonts().front().name}) {
            TextRecipe words = text("Hgo\nR");
            words.font = font;
            Path path(lettered(words).paths);
            Recipe recipe = words;
            for (const AffineMap& each : {map, rotation(-70, {1, 1}), map}) {
                transform(path, recipe, each);
                const auto* turned = std::get_if<TextRecipe>(&recipe);
                QVERIFY(turned && makes(*turned, path.subpaths()));
            }
        }
    }
    void aMissingFontIsReplaced()
    {
        const QString missing = "No such font";
        QVERIFY(!hasFont(missing) && hasFont(font_) && hasFont(strokeFonts().front().name));
        QVERIFY(outlineFonts().contains(fontInsteadOf(missing)));
        QVERIFY(lettered({"H", missing, 10, {}}).paths.empty());
        QVERIFY(missingFontText(missing).contains(fontInsteadOf(missing)));
    }
};

} // namespace lettering_outline_letters_test

TEST_CLASS(lettering_outline_letters_test::OutlineLettersTest, Gui)
#include "tests/app/lettering/outline_letters_test.moc"

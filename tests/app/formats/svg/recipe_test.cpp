// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"
#include "app/formats/format.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <QBuffer>
#include <QTest>

#include "tests/test_class.h"

namespace formats_svg_recipe_test {

using namespace app;

class RecipeTest : public QObject {
    Q_OBJECT

    static Document read(const QByteArray& text)
    {
        QBuffer in;
        in.setData(text);
        in.open(QIODevice::ReadOnly);
        const auto imported = formats().front().read(in);
        return imported ? imported.value->document : Document();
    }
    static QByteArray written(const Document& document)
    {
        QBuffer out;
        out.open(QIODevice::WriteOnly);
        return formats().front().write(document, out, {}) ? QByteArray() : out.data();
    }
    static std::vector<Subpath> letters()
    {
        return {{{0.1, -0.0}, {{{5, 0}, {2, 3}, {7.25, 1.0 / 3}, true}, {{5, 9}}}, true},
                {{1, 1}, {{{2, 1}}, {{2, 2}}}, true}};
    }
    static Document drawn(const Recipe& recipe)
    {
        const auto* text = std::get_if<TextRecipe>(&recipe);
        return drawn(recipe,
                     text ? lettered(*text).paths : std::vector<Subpath>{*outlineOf(recipe)});
    }
    static Document drawn(const Recipe& recipe, const std::vector<Subpath>& subpaths)
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        builder.add(Object{.path = Path(subpaths),
                           .style = {.stroke = Colour{}},
                           .particulars = {.recipe = recipe}});
        builder.close();
        return builder.take({});
    }

private slots:
    void comesBackFromAFile_data()
    {
        QTest::addColumn<Recipe>("recipe");
        QTest::newRow("rectangle") << Recipe(RectangleRecipe{{0.1, -3}, {7.7, 1e-3}});
        QTest::newRow("ellipse") << Recipe(EllipseRecipe{{10.1, 20}, {3.3, 4}});
        QTest::newRow("turned rectangle") << Recipe(RectangleRecipe{{0.1, -3}, {7.7, 2}, 0, 0.3});
        QTest::newRow("turned, round") << Recipe(RectangleRecipe{{0.1, -3}, {7.7, 2}, 0.5, -3});
        QTest::newRow("turned ellipse") << Recipe(EllipseRecipe{{10.1, 20}, {3.3, 4}, 1.1});
        const QString font = strokeFonts().front().name;
        QTest::newRow("text") << Recipe(TextRecipe{"A word", font, 5.1, {0.1, 20}});
        QTest::newRow("signs") << Recipe(
            TextRecipe{" \"<&>' \\n\\ \n\n  λ漢\n", font, 1.0 / 3, {-7, 1e5}});
        QTest::newRow("turned") << Recipe(TextRecipe{"A word", font, 5.1, {0.1, 20}, 1.1});
        QTest::newRow("mirrored") << Recipe(TextRecipe{"word", font, 5, {0, 0}, -0.5, true});
    }
    void comesBackFromAFile()
    {
        QFETCH(Recipe, recipe);
        const Document document = drawn(recipe);
        const Document back = read(written(document));
        QCOMPARE(back.objects().size(), std::size_t(1));
        QVERIFY(back.objects()[0].particulars().recipe == recipe);
        QVERIFY(back.objects()[0].path() == document.objects()[0].path());
    }
    // The letters of an installed font are verified by a checksum: it may be missing here.
    void textsOfFontsThatAreMissingComeBack_data()
    {
        QTest::addColumn<QString>("font");
        QTest::addColumn<QString>("words");
        QTest::newRow("simple") << "No such font"
                                << "A word";
        QTest::newRow("signs") << "It's a \\'\\q font"
                               << " <&>'\\q\n 12 λ漢 ";
        QTest::newRow("no words") << "No such font"
                                  << "";
    }
    void textsOfFontsThatAreMissingComeBack()
    {
        QFETCH(QString, font);
        QFETCH(QString, words);
        for (const auto& [turn, mirrored, face] : {std::tuple(0.0, false, FontFace{}),
                                                   {0.7, false, {true, false}},
                                                   {0.0, true, {}},
                                                   {0.0, false, {false, true}},
                                                   {0.7, true, {true, true}}}) {
            const TextRecipe recipe{words, font, 5, {1, 2}, turn, mirrored, face};
            const Document document = drawn(recipe, letters());
            const QByteArray file = written(document);
            const Document back = read(file);
            QCOMPARE(back.objects().size(), std::size_t(1));
            QVERIFY(back.objects()[0].particulars().recipe == Recipe(recipe));
            QCOMPARE(written(back), file);
        }
    }
    void goesWhereLettersWereMoved()
    {
        const QByteArray file =
            written(drawn(TextRecipe{"A word", "No such font", 5, {1, 2}}, letters()));
        for (const char* const part : {"7.25", "0.1"}) {
            QByteArray edited = file;
            QVERIFY(edited.contains(part));
            edited.replace(part, "7.26");
            QVERIFY(read(edited).objects()[0].particulars().recipe == Recipe{});
        }
    }
    /// The shapes of other programs are shapes here, too, as far as there are such recipes.
    void rectanglesAndEllipsesOfOtherProgramsAreRead_data()
    {
        QTest::addColumn<QByteArray>("element");
        QTest::addColumn<Recipe>("recipe");
        const double turn = 25 * 3.14159265358979323846 / 180;
        QTest::newRow("rect") << QByteArray("<rect x='1' y='2' width='30' height='40'/>")
                              << Recipe(RectangleRecipe{{1, 2}, {30, 40}});
        QTest::newRow("rounded") << QByteArray("<rect width='30' height='40' rx='5'/>")
                                 << Recipe(RectangleRecipe{{0, 0}, {30, 40}, 5});
        QTest::newRow("elliptical corners")
            << QByteArray("<rect width='30' height='40' rx='5' ry='6'/>") << Recipe();
        QTest::newRow("circle") << QByteArray("<circle cx='5' cy='6' r='3'/>")
                                << Recipe(EllipseRecipe{{5, 6}, {3, 3}});
        QTest::newRow("ellipse") << QByteArray("<ellipse cx='5' cy='6' rx='3' ry='2'/>")
                                 << Recipe(EllipseRecipe{{5, 6}, {3, 2}});
        QTest::newRow("scaled") << QByteArray("<g transform='translate(5) scale(2 3)'>"
                                              "<rect x='1' y='2' width='30' height='40'/></g>")
                                << Recipe(RectangleRecipe{{7, 6}, {60, 120}});
        QTest::newRow("rotated") << QByteArray("<rect x='60' y='40' width='80' height='40' "
                                               "transform='rotate(25 100 60)'/>")
                                 << Recipe(RectangleRecipe{{60, 40}, {80, 40}, 0, turn});
        QTest::newRow("skewed") << QByteArray("<rect width='80' height='40' "
                                              "transform='skewX(20)'/>")
                                << Recipe();
        QTest::newRow("path") << QByteArray("<path d='M0 0H30V40H0Z'/>") << Recipe();
    }
    void rectanglesAndEllipsesOfOtherProgramsAreRead()
    {
        QFETCH(QByteArray, element);
        QFETCH(Recipe, recipe);
        const Document document = read("<svg xmlns='http://www.w3.org/2000/svg' width='200' "
                                       "height='200'>"
                                       + element + "</svg>");
        const Recipe found = document.objects()[0].particulars().recipe;
        QCOMPARE(found.index(), recipe.index());
        const auto made = outlineOf(found);
        QVERIFY(!made || makes(recipe, std::span(&*made, 1)));
        const auto* turned = std::get_if<RectangleRecipe>(&found);
        QVERIFY(!turned || std::abs(turned->turn - std::get<RectangleRecipe>(recipe).turn) < 1e-9);
    }
    // Whoever moved a corner in another program did not know of the recipe.
    void goesWhereThePathIsAnotherOne_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("another corner") << QByteArray("rectangle 1 ") << QByteArray("rectangle 2 ");
        QTest::newRow("another kind") << QByteArray("rectangle ") << QByteArray("ellipse ");
        QTest::newRow("too few numbers") << QByteArray("rectangle 1 ") << QByteArray("rectangle ");
        QTest::newRow("unknown") << QByteArray("rectangle ") << QByteArray("star ");
        QTest::newRow("NaN") << QByteArray("rectangle 1 ") << QByteArray("rectangle nan ");
        QTest::newRow("too large") << QByteArray("rectangle 1 ") << QByteArray("rectangle 1e999 ");
        QTest::newRow("transformed") << QByteArray("clearcut:recipe")
                                     << QByteArray("transform=\"scale(2)\" clearcut:recipe");
    }
    void goesWhereThePathIsAnotherOne()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QByteArray file = written(drawn(RectangleRecipe{{1, 2}, {30, 40}}));
        QVERIFY(file.contains(from));
        file.replace(from, to);
        const Document back = read(file);
        QCOMPARE(back.objects().size(), std::size_t(1));
        QVERIFY(std::holds_alternative<std::monostate>(back.objects()[0].particulars().recipe));
    }
};

} // namespace formats_svg_recipe_test

TEST_CLASS(formats_svg_recipe_test::RecipeTest, None)
#include "tests/app/formats/svg/recipe_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Font, bold, italic and size of selected texts.
#include "app/document/document_builder.h"
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "app/session/selected_texts.h"

#include <QTest>

#include <limits>

#include "tests/test_class.h"

namespace session_selected_texts_test {

using namespace app;

namespace {

TextRecipe written(const QString& text, double size)
{
    return {text, strokeFonts().front().name, size, {10, 20 * size}};
}

/// Two texts and a line.
class Texts {
public:
    Texts()
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        for (const TextRecipe& text : {written("first", 4), written("second", 8)})
            builder.add(textObject(text));
        const Subpath line{{0, 0}, {{{5, 5}}}, false};
        builder.add(Object{.path = Path({&line, 1}), .style = {.stroke = Colour{}, .width = 1}});
        builder.close();
        session.load({builder.take(Page{}), {}});
    }
    void loadOne(const Object& object)
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        builder.add(object);
        builder.close();
        session.load({builder.take(Page{}), {}});
        session.select({0});
    }
    static Object textObject(const TextRecipe& text)
    {
        Object object{.path = Path(lettered(text).paths),
                      .style = {.stroke = Colour{}, .width = 0.5}};
        object.particulars.recipe = text;
        return object;
    }
    TextRecipe text(std::size_t object)
    {
        return std::get<TextRecipe>(Recipe(session.now().objects()[object].particulars().recipe));
    }
    bool isDrawn(std::size_t object)
    {
        return makes(text(object), session.now().objects()[object].path().subpaths());
    }
    Session session;
};

} // namespace

class SelectedTextsTest : public QObject {
    Q_OBJECT

private slots:
    void onlyTextsAlone()
    {
        Texts t;
        QVERIFY(selectedTexts(t.session).empty());
        t.session.select({0, 1});
        const auto both = selectedTexts(t.session);
        QCOMPARE(both.size(), std::size_t(2));
        QCOMPARE(commonOf(both, &TextRecipe::font), strokeFonts().front().name);
        QVERIFY(!commonOf(both, &TextRecipe::size));
        t.session.select({0, 2});
        QVERIFY(selectedTexts(t.session).empty());
        QVERIFY(!setTextFont(t.session, strokeFonts()[1].name));
        QCOMPARE(t.session.history.count(), 0);
    }
    void aFontIsOneStep()
    {
        Texts t;
        t.session.select({0, 1});
        const QString other = strokeFonts()[1].name;
        QVERIFY(!setTextFont(t.session, other));
        for (const std::size_t i : {0, 1}) {
            QCOMPARE(t.text(i).font, other);
            QVERIFY(t.isDrawn(i));
        }
        QCOMPARE(t.session.history.count(), 1);
        QVERIFY(!setTextFont(t.session, other)); // nothing to do
        QCOMPARE(t.session.history.count(), 1);
        t.session.history.undo();
        QCOMPARE(t.text(0).font, strokeFonts().front().name);
        QVERIFY(t.session.selection() == ObjectRanges({0, 1}));
    }
    void aSizeKeepsTheBeginning()
    {
        Texts t;
        t.session.select({0, 1});
        QVERIFY(!setTextSize(t.session, 6));
        for (const std::size_t i : {0, 1}) {
            QCOMPARE(t.text(i).size, 6.0);
            QVERIFY(t.isDrawn(i));
        }
        QCOMPARE(t.text(1).at, Point(10, 160));
        QCOMPARE(t.session.history.count(), 1);
        for (const double wrong :
             {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
            QVERIFY(setTextSize(t.session, wrong).value_or("").contains("more than 0"));
        QCOMPARE(t.session.history.count(), 1);
    }
    void lettersThatAreMissingAreNamed()
    {
        Texts t;
        Object object = Texts::textObject(written("first", 4));
        std::get<TextRecipe>(object.particulars.recipe).text = QStringLiteral("\u4e2d");
        t.loadOne(object);
        const auto remark = setTextFont(t.session, strokeFonts()[1].name);
        QVERIFY2(remark && remark->contains(QStringLiteral("\u4e2d")),
                 qPrintable(remark.value_or("nothing")));
    }
    // Its letters only grow; to make it bold they are written in another font, which is said.
    void aFontThatIsNotInstalledKeepsItsLetters()
    {
        Texts t;
        Object object = Texts::textObject(written("first", 4));
        std::get<TextRecipe>(object.particulars.recipe).font = QStringLiteral("No Such Font");
        t.loadOne(object);
        QVERIFY(!setTextSize(t.session, 12));
        QCOMPARE(t.text(0).font, QStringLiteral("No Such Font"));
        const auto bounds = t.session.selectionBounds();
        t.session.history.undo();
        const auto before = t.session.selectionBounds();
        QVERIFY(std::abs((bounds->max.x - 10) - 3 * (before->max.x - 10)) < 1e-9);
        const auto remark = setTextFace(t.session, &FontFace::bold, true);
        QVERIFY2(remark && remark->contains(QStringLiteral("No Such Font")),
                 qPrintable(remark.value_or("nothing")));
        QVERIFY(hasFont(t.text(0).font));
    }
    void tooManyAreNotChangedTogether()
    {
        DocumentBuilder builder;
        builder.open({.name = "Drawing"});
        const Object object = Texts::textObject(written("a", 4));
        for (std::size_t i = 0; i <= mostTextsAtOnce; ++i)
            builder.add(object);
        builder.close();
        Session session;
        session.load({builder.take(Page{}), {}});
        session.select(ObjectRanges(ObjectRange{0, mostTextsAtOnce}));
        QCOMPARE(selectedTexts(session).size(), mostTextsAtOnce);
        session.select(ObjectRanges(ObjectRange{0, mostTextsAtOnce + 1}));
        QVERIFY(selectedTexts(session).empty());
    }
};

} // namespace session_selected_texts_test

TEST_CLASS(session_selected_texts_test::SelectedTextsTest, Gui)
#include "tests/app/session/selected_texts_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// Texts become the outlines of their letters. The tests have the fonts of tests/fonts.conf.
#include "app/document/path.h"
#include "app/lettering/lettering.h"

#include <QTest>

#include <glm/common.hpp>

#include <cmath>
#include <thread>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_text_test {

using app::Path;
using app::Point;

namespace {

struct Bounds {
    Point min{1e9, 1e9}, max{-1e9, -1e9};
    double width() const { return max.x - min.x; }
    double middle() const { return (min.x + max.x) / 2; }
};

Bounds boundsOf(const app::Document& document)
{
    Bounds bounds;
    for (std::size_t i = 0; i < document.objects().size(); ++i)
        document.objects()[i].path().forEachPoint([&](const Point& p) {
            bounds.min = glm::min(bounds.min, p);
            bounds.max = glm::max(bounds.max, p);
        });
    return bounds;
}

const QByteArray mono = " font-family='DejaVu Sans Mono' font-size='10' ";
constexpr double advance = 6.0205; // of each letter of DejaVu Sans Mono at 10

app::Document documentOf(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? result.value->document : app::Document();
}
Bounds boundsOf(const QByteArray& elements) { return boundsOf(documentOf(elements)); }

std::size_t countOf(const QByteArray& elements) { return documentOf(elements).objects().size(); }

std::optional<app::TextRecipe> recipeOf(const QByteArray& elements)
{
    const app::Document document = documentOf(elements);
    if (document.objects().size() != 1)
        return std::nullopt;
    const app::Recipe recipe = document.objects()[0].particulars().recipe;
    const auto* text = std::get_if<app::TextRecipe>(&recipe);
    return text ? std::optional(*text) : std::nullopt;
}

QByteArray text(const QByteArray& attributes, const QByteArray& content)
{
    return "<text" + mono + attributes + '>' + content + "</text>";
}

#define QNEAR(actual, expected)                                                                    \
    QVERIFY2(std::abs((actual) - (expected)) < 0.06,                                               \
             qPrintable(QStringLiteral("%1, not %2").arg(actual).arg(expected)))

} // namespace

class TextTest : public QObject {
    Q_OBJECT
private slots:
    void verticalLinesRunDown()
    {
        const Bounds across = boundsOf(text("x='10' y='20'", "HHHHH")),
                     down = boundsOf(text("x='10' y='20' writing-mode='tb'", "HHHHH"));
        QNEAR(down.max.y - down.min.y, across.width());
        QNEAR(down.min.y - 20, across.min.x - 10);
        QNEAR(down.width(), across.max.y - across.min.y);
        QVERIFY(down.min.x < 10 && down.max.x > 10); // the line runs through the letters
        const auto place = [](const QByteArray& anchor) {
            return boundsOf(text(
                "y='50' style='writing-mode: vertical-rl; text-anchor: " + anchor + "'", "HHHHH"));
        };
        QNEAR((place("middle").min.y + place("middle").max.y) / 2, 50);
        QNEAR(place("end").max.y, 50 - (across.min.x - 10));
        QNEAR(boundsOf(text("y='10' writing-mode='vertical-lr'", "H<tspan dy='7'>H</tspan>")).max.y
                  - boundsOf(text("y='10' writing-mode='vertical-lr'", "HH")).max.y,
              7);
        // Only that of the whole text counts.
        QNEAR(boundsOf(text("", "H<tspan writing-mode='tb'>H</tspan>")).width(),
              boundsOf(text("", "HH")).width());
        QVERIFY(reportOf("<path id='p' d='M0 0H90'/>"
                         + text("writing-mode='tb'", "<textPath href='#p'>H</textPath>"))
                    .contains("use of the style property “writing-mode”"));
    }

    void kerningCanBeSwitchedOff()
    {
        const auto width = [](const QByteArray& attributes) {
            return boundsOf("<text font-family='DejaVu Serif' font-size='10' " + attributes
                            + ">AVAVA</text>")
                .width();
        };
        for (const char* off : {"kerning='0'", "style='font-kerning:none'"})
            QVERIFY2(width(off) > 1.02 * width({}), off);
        for (const char* on : {"font-kerning='normal'", "kerning='auto'"})
            QNEAR(width(on), width({}));
        // It is no attribute; `font` sets it back.
        QNEAR(width("font-kerning='none'"), width({}));
        QNEAR(width("style=\"font-kerning:none;font:10px 'DejaVu Serif'\""), width({}));
        QVERIFY(reportOf(text("kerning='3'", "AVA")).contains("“kerning: 3”"));
    }
    void lettersStandOnTheirBaseline()
    {
        const Bounds one = boundsOf(text("x='10' y='20'", "H"));
        QNEAR(one.max.y, 20);
        QNEAR(one.min.y, 20 - 7.29); // the height of capitals of DejaVu: 0.729
        QVERIFY(one.min.x > 10 && one.max.x < 10 + advance);
        const Bounds five = boundsOf(text("x='10' y='20'", "HHHHH"));
        QNEAR(five.max.x - one.max.x, 4 * advance);
        QNEAR(boundsOf(text("x='10' y='20' style='font-size:20px'", "H")).min.y, 20 - 14.58);
    }

    void anchors()
    {
        QNEAR(boundsOf(text("x='50' y='20' text-anchor='middle'", "HHHHH")).middle(), 50);
        const double start = boundsOf(text("x='50' y='20'", "HHHHH")).min.x;
        QNEAR(boundsOf(text("x='50' y='20' text-anchor='end'", "HHHHH")).min.x,
              start - 5 * advance);
        QNEAR(boundsOf(text("x='50' y='20' text-anchor='end'", "HH<tspan fill='red'>HHH</tspan>"))
                  .min.x,
              start - 5 * advance);
        QNEAR(boundsOf(text("x='50' direction='rtl'", "HHHHH")).min.x, start - 5 * advance);
    }

    void positionsOfLetters()
    {
        const double left = boundsOf(text("", "H")).min.x;
        QNEAR(boundsOf(text("x='10 40'", "HH")).max.x - boundsOf(text("x='10'", "H")).max.x, 30);
        QNEAR(boundsOf(text("x='10' dx='5 7'", "HH")).width(),
              boundsOf(text("", "HH")).width() + 7);
        QNEAR(boundsOf(text("x='10' dx='5'", "H")).min.x, left + 15);
        QNEAR(boundsOf(text("y='10' dy='1 2'", "HH")).max.y, 13);
        QNEAR(boundsOf(text("", "H<tspan x='30' y='9'>H</tspan>")).max.y, 9);
        QNEAR(boundsOf(text("", "H<tspan dy='9'>H</tspan>")).max.y, 9);
        QNEAR(boundsOf(text("rotate='90'", "H")).min.x, 0); // its foot
        QNEAR(boundsOf(text("letter-spacing='2'", "HHH")).width(),
              boundsOf(text("", "HHH")).width() + 4);
        QNEAR(boundsOf(text("baseline-shift='3'", "H")).max.y, 0); // of a part of a text alone
        QNEAR(boundsOf(text("", "<tspan baseline-shift='3'>H</tspan>")).max.y, -3);
    }

    void baselines()
    {
        const auto foot = [](const QByteArray& name) {
            return boundsOf(text("dominant-baseline='" + name + "'", "H")).max.y;
        };
        QNEAR(foot("auto"), 0);
        QNEAR(foot("middle"), 5.47 / 2);       // half the height of an x
        QNEAR(foot("text-before-edge"), 9.28); // DejaVu's ascent
        QNEAR(foot("text-after-edge"), -2.36); // and descent
        QNEAR(foot("central"), (9.28 - 2.36) / 2);
    }

    void textLength()
    {
        const double five = boundsOf(text("", "HHHHH")).width();
        QNEAR(boundsOf(text("textLength='60'", "HHHHH")).width(), five + 60 - 5 * advance);
        const Bounds stretched =
            boundsOf(text("textLength='60.205' lengthAdjust='spacingAndGlyphs'", "HHHHH"));
        QNEAR(stretched.width(), five * 2);
        // Of a part, which has no gap after it: 20 for two letters, then one more.
        const double one = boundsOf(text("", "H")).width();
        QNEAR(boundsOf(text("", "H<tspan textLength='20'>HH</tspan>H")).width(),
              advance + 20 + one);
        QNEAR(boundsOf(text("textLength='90'", "<tspan textLength='40'>HHH</tspan>HH")).width(),
              boundsOf(text("textLength='90'", "HHHHH")).width());
        const char* const stretchedPart =
            "H<tspan textLength='20' lengthAdjust='spacingAndGlyphs'>HH</tspan>";
        QVERIFY(reportOf(text("", stretchedPart)).contains("attribute “textLength”"));
        QVERIFY(
            !reportOf(text("", "<tspan textLength='20'>HH</tspan>H")).contains("textLength"));
    }

    void blanks()
    {
        const double one = boundsOf(text("", "H H")).width();
        QNEAR(boundsOf(text("", "\n  H \n\t H  ")).width(), one);
        QNEAR(boundsOf(text("xml:space='preserve'", "H   H")).width(), one + 2 * advance);
        QNEAR(boundsOf(text("style='white-space:pre'", "H   H")).width(), one + 2 * advance);
        QNEAR(boundsOf(text("text-anchor='end'", " H ")).max.x,
              boundsOf(text("", "H")).max.x - advance);
        QCOMPARE(countOf(text("", "   ")), std::size_t(0));
        QCOMPARE(countOf(text("", "")), std::size_t(0));
        QCOMPARE(countOf("<text font-size='0'>a<tspan font-size='5'>b</tspan></text>"),
                 std::size_t(1));
        QVERIFY(readText(drawing("<text letter-spacing='1e30' word-spacing='-1e30' "
                                 "font-size='1e-300'>a b</text>")));
        QVERIFY(readText(drawing("<text letter-spacing='1e30' font-size='9'>a b</text>")));
    }

    void onAPath()
    {
        const QByteArray path = "<path id='p' fill='none' stroke='none' d='M10 90V10'/>";
        const Bounds up = boundsOf("<defs>" + path + "</defs>"
                                   + text("", "<textPath href='#p'>HHHHH</textPath>"));
        QNEAR(up.max.x, 10);
        QNEAR(up.min.x, 10 - 7.29);
        QNEAR(up.max.y - up.min.y, boundsOf(text("", "HHHHH")).width());
        const Bounds later =
            boundsOf("<defs>" + path + "</defs>"
                     + text("", "<textPath href='#p' startOffset='50%'>HHHHH</textPath>"));
        QNEAR(later.max.y, up.max.y - 40);
        QVERIFY(reportOf("<defs>" + path + "</defs>"
                         + text("", "<textPath href='#p' startOffset='75'>HHHHH</textPath>"))
                    .contains("cut off where its path ends"));
        QVERIFY(reportOf(text("", "<textPath href='#gone'>H</textPath>"))
                    .contains("text on a path that is not in the file"));
    }

    void areEditable()
    {
        const auto plain = recipeOf(text("x='10' y='20'", "Hello"));
        QVERIFY(plain);
        QCOMPARE(plain->text, "Hello");
        QCOMPARE(plain->font, "DejaVu Sans Mono");
        QCOMPARE(plain->at, Point(10, 20));
        QNEAR(plain->size, 7.29);
        const auto turned = recipeOf(
            text("transform='translate(50,50) rotate(90) scale(2)' font-weight='bold'", "Hello"));
        QVERIFY(turned);
        QNEAR(turned->turn, std::acos(0.0));
        QNEAR(turned->size, 14.58);
        QVERIFY(turned->face.bold && !turned->mirrored);
        QVERIFY(recipeOf(text("transform='scale(-1,1)'", "Hello"))->mirrored);
        QVERIFY(!recipeOf(text("transform='skewX(20)'", "Hello")));
        const auto placedOneByOne = recipeOf(text("x='10 16.5 22 28.2'", "Word"));
        QVERIFY(placedOneByOne);
        QCOMPARE(placedOneByOne->text, "Word");
        QVERIFY(documentOf(text("display='none'", "one")).objects()[0].hidden());
    }

    // The recipe makes the letters that the file has.
    void recipesMakeTheSameLetters()
    {
        const QByteArray elements = text("x='10' y='20' transform='rotate(30)'", "Avast");
        const auto recipe = recipeOf(elements);
        QVERIFY(recipe);
        const auto again = app::lettered(*recipe).paths;
        const auto read = documentOf(elements).objects()[0].path().subpaths();
        QCOMPARE(again.size(), read.size());
        for (std::size_t i = 0; i < again.size(); ++i) {
            QNEAR(again[i].start.x, read[i].start.x);
            QNEAR(again[i].start.y, read[i].start.y);
        }
    }

    void areWrittenAgain()
    {
        const app::Document document = documentOf(text("x='10' y='20'", "Hello"));
        const QByteArray written = textOf(document);
        const auto again = readText(written);
        QVERIFY(again);
        QVERIFY(textOf(again.value->document) == written);
        const app::Recipe recipe = again.value->document.objects()[0].particulars().recipe;
        QVERIFY(std::holds_alternative<app::TextRecipe>(recipe));
    }

    void partsAreAGroup()
    {
        const app::Document document =
            documentOf(text("id='t' fill='red'", "one<tspan fill='blue' x='0' y='20'>two</tspan>"));
        QCOMPARE(document.objects().size(), std::size_t(2));
        QVERIFY(textOf(document).contains("<g id=\"t\""));
        QCOMPARE(documentOf(text("id='t'", "one")).objects()[0].particulars().id, "t");
        QCOMPARE(countOf(text("text-decoration='underline'", "one")), std::size_t(2));
    }

    void isTold()
    {
        QCOMPARE(reportOf(text("", "one")), "1 text became the outlines of its letters");
        QVERIFY(app::mustSaveAs(readText(drawing(text("", "one"))).value->report));
        QVERIFY(reportOf("<text font-family='No Such Font, serif'>one</text>")
                    .contains("“No Such Font → DejaVu Serif”"));
        QCOMPARE(reportOf("<text font-family='serif'>one</text>"),
                 "1 text became the outlines of its letters");
        QCOMPARE(reportOf(text("writing-mode='tb'", "one")),
                 "1 text became the outlines of its letters");
        QVERIFY(reportOf(text("x='1 nonsense'", "one")).contains("“x: nonsense”"));
        QVERIFY(reportOf(text("letter-spacing='5%'", "one")).contains("“letter-spacing: 5%”"));
        QVERIFY(reportOf(text("font-variant='small-caps'", "one")).contains("small capitals"));
        QVERIFY(reportOf(text("textLength='0'", "one")).contains("attribute “textLength”"));
    }

    void hiddenAndConditionalParts()
    {
        QCOMPARE(countOf(text("", "<tspan display='none'>one</tspan>")), std::size_t(0));
        QCOMPARE(countOf(text("", "<title>one</title><desc>two</desc>")), std::size_t(0));
        QVERIFY(documentOf(text("visibility='hidden'", "one")).objects()[0].hidden());
        QCOMPARE(countOf(text("", "<tspan systemLanguage='de'>eins</tspan>")), std::size_t(0));
    }

    // What is meant by a box of the text.
    void boxes()
    {
        const Bounds bounds = boundsOf("<g style='transform:scale(2);transform-box:fill-box;"
                                       "transform-origin:center'>"
                                       + text("x='10' y='20'", "HHHHH") + "</g>");
        const Bounds plain = boundsOf(text("x='10' y='20'", "HHHHH"));
        QNEAR(bounds.middle(), plain.middle());
        QNEAR(bounds.width(), 2 * plain.width());
    }

    // A box is as high as the font, whatever letters are in it.
    void boxesOfLowAndHighLetters()
    {
        const auto cut = [](const QByteArray& letters) {
            return boundsOf("<clipPath id='c' clipPathUnits='objectBoundingBox'>"
                            "<path d='M0 0H9V.5H0z'/></clipPath><g clip-path='url(#c)'>"
                            + text("y='50'", letters) + "</g>");
        };
        QCOMPARE(cut("Hg").max.y, cut("H").max.y);
    }

    void textsOfOtherTexts()
    {
        const QByteArray other = "<defs><text id='o'>o<tspan fill='red'>n</tspan>e</text></defs>";
        QCOMPARE(textOf(documentOf(other + text("", "<tref xlink:href='#o'/>"))),
                 textOf(documentOf(other + text("", "<tspan>one</tspan>"))));
        QCOMPARE(countOf(other + text("", "<tref xlink:href='#gone'/>")), std::size_t(0));
    }

    // Each line has the paint of the element that asks for it.
    void linesHaveTheStyleOfTheirElements()
    {
        const app::Document document =
            documentOf("<text y='50' fill='red' text-decoration='underline'>a<tspan fill='blue' "
                       "text-decoration='line-through'>b</tspan></text>");
        std::vector<app::Colour> fills;
        for (std::size_t i = 0; i < document.objects().size(); ++i)
            fills.push_back(*document.objects()[i].style().fill);
        const app::Colour red{255, 0, 0}, blue{0, 0, 255};
        QVERIFY((fills == std::vector{red, red, red, blue, blue})); // _ a _ b -
    }

    void linesAreTurnedWithTheirLetters()
    {
        const Bounds level = boundsOf(text("y='50' text-decoration='underline'", "x"));
        const Bounds turned = boundsOf(text("y='50' rotate='90' text-decoration='underline'", "x"));
        QVERIFY(turned.max.y > 50 + 0.9 * level.width());
        QVERIFY(turned.min.x < 0); // the line is on the left
    }

    // By the font around, not by their own.
    void scriptsAreAsHighAsTheFontSays()
    {
        const auto topOf = [](const QByteArray& size) {
            return boundsOf(text("y='50'", "<tspan baseline-shift='super' font-size='" + size
                                               + "'>x</tspan>"))
                .max.y;
        };
        QVERIFY(topOf("10") < 48);
        QNEAR(topOf("5"), topOf("10"));
    }

    void positionsOnAPathAreAlongIt()
    {
        const auto leftOf = [](const QByteArray& attributes) {
            return boundsOf("<text" + attributes + "><textPath path='M0 50H90'>x</textPath></text>")
                .min.x;
        };
        QNEAR(leftOf(" x='20' y='7'"), leftOf("") + 20);
        QNEAR(leftOf(" dx='5'"), leftOf("") + 5);
        QNEAR(boundsOf("<text><textPath path='M0 50H90' x='9'>x</textPath></text>").min.x,
              leftOf("")); // it has no positions of its own
        const auto countIn = [](const QByteArray& content) {
            return countOf("<text><textPath path='M0 50H90'>" + content + "</textPath></text>");
        };
        QCOMPARE(countIn("<textPath path='M0 9H90'>x</textPath>"), std::size_t(0));
    }

    void spacingAfterTheLastLetterDoesNotCount()
    {
        const Bounds plain = boundsOf(text("x='50' y='50' text-anchor='end'", "x"));
        const Bounds spaced =
            boundsOf(text("x='50' y='50' text-anchor='end' letter-spacing='9'", "x"));
        QNEAR(spaced.min.x, plain.min.x);
    }

    void whatIsNotANumberOfDegreesIsTold()
    {
        QVERIFY(reportOf(text("rotate='5mm'", "x")).contains("“rotate: 5mm”"));
        QNEAR(boundsOf(text("y='50' rotate='5mm'", "x")).max.y,
              boundsOf(text("y='50'", "x")).max.y);
    }

    // SVG gives parts of a text neither opacity nor clip path.
    void partsHaveNoEffects()
    {
        const QByteArray clip = "<clipPath id='c'><path d='M0 0H1V1z'/></clipPath>";
        QCOMPARE(textOf(documentOf(clip
                                   + text("", "<tspan clip-path='url(#c)' opacity='.5'>"
                                              "one</tspan>"))),
                 textOf(documentOf(clip + text("", "<tspan>one</tspan>"))));
    }

    // The editor opens files in the background.
    void onOtherThreads()
    {
        const QByteArray elements = text("", "one") + "<text font-family='serif'>two</text>";
        const QByteArray expected = textOf(documentOf(elements));
        std::vector<QByteArray> found(4);
        std::vector<std::thread> threads;
        for (QByteArray& each : found)
            threads.emplace_back([&] { each = textOf(documentOf(elements)); });
        for (std::thread& thread : threads)
            thread.join();
        for (const QByteArray& each : found)
            QVERIFY(each == expected);
    }

    void longTextsEnd()
    {
        const QByteArray many = text("id='t'", QByteArray(9'000, '.'));
        QVERIFY(readText(drawing(many)));
        const auto result = readText(
            drawing("<defs>" + many + "</defs>" + QByteArray("<use href='#t'/>").repeated(120)));
        QVERIFY(!result);
        QVERIFY2(result.error.contains("exceeds the limit of 1000000 letters"),
                 qPrintable(result.error));
    }
};

} // namespace formats_svg_text_test

TEST_CLASS(formats_svg_text_test::TextTest, Gui)
#include "tests/app/formats/svg/text_test.moc"

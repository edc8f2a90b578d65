// SPDX-License-Identifier: GPL-3.0-or-later
// Colours, style sheets, inheritance, opacity: what a shape's style becomes.
#include "app/formats/svg/colour.h"

#include <QColor>
#include <QTest>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"

namespace formats_svg_style_test {

namespace {

const QByteArray triangle = "<path d='M0 0h9v9' id='i'";
const QByteArray line = "<line x2='9' y2='9' id='i' class='a b'";

QString name(const std::optional<app::Colour>& c)
{
    return c ? QStringLiteral("%1 %2 %3 %4").arg(c->red).arg(c->green).arg(c->blue).arg(c->alpha)
             : "none";
}

app::Style style(const QByteArray& attributes, const QByteArray& sheet = {})
{
    return shapeOf("<style>" + sheet + "</style>" + line + attributes + "/>").style;
}

} // namespace

class StyleTest : public QObject {
    Q_OBJECT

private slots:
    void colours_data()
    {
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* text, const char* expected) {
            QTest::newRow(text) << QString(expected);
        };
        row("#f80", "255 136 0 255");
        row("#F808", "255 136 0 136");
        row("#0a141e", "10 20 30 255");
        row("#0a141e80", "10 20 30 128");
        row("rgb(10,20,30)", "10 20 30 255");
        row("RGB( 10 , 20 , 300 )", "10 20 255 255");
        row("rgb(100%, 50%, 0%)", "255 128 0 255");
        row("rgb(10 20 30 / 50%)", "10 20 30 128");
        row("rgba(10,20,30,.2)", "10 20 30 51");
        row("rgb(-5,20,30)", "0 20 30 255");
        row("hsl(120,100%,50%)", "0 255 0 255");
        row("hsl(-120, 100%, 50%)", "0 0 255 255");
        row("hsla(0,0%,50%,0.4)", "128 128 128 102");
        row("hsl(30deg 100% 50%)", "255 128 0 255");
        row(" Tomato ", "255 99 71 255");
        row("LightGoldenrodYellow", "250 250 210 255");
        row("rebeccapurple", "102 51 153 255");
        row("hwb(120 0% 0%)", "0 255 0 255");
        row("hwb(0.5turn 20% 40% / 50%)", "51 153 153 128");
        row("hwb(90 60% 90%)", "102 102 102 255");
        row("hsl(3.14159265358979rad 100% 50%)", "0 255 255 255");
        row("hsl(0.5turn,100%,50%)", "0 255 255 255");
        row("lab(29.2345% 39.3825 20.0664)", "125 35 41 255"); // the same in four notations
        row("lch(29.2345 44.2 27deg)", "125 35 41 255");
        row("oklab(40.101% 0.1147 0.0453)", "125 35 41 255");
        row("oklch(0.401 0.123 21.57 / 50%)", "125 36 41 128");
        row("lab(100 none 0)", "255 255 255 255");
        row("color(srgb 1 0.5 0 / 50%)", "255 128 0 128");
        row("color(srgb-linear 100% 0 0.2158605)", "255 0 128 255");
        row("color(display-p3 1 1 1)", "255 255 255 255");
        row("color(xyz 0.9505 1 1.089)", "255 255 255 255");
        row("light-dark(rgb(1,2,3), white)", "1 2 3 255");
        row("transparent", "0 0 0 0");
        for (const char* bad : {"",
                                "#",
                                "#12",
                                "#12345",
                                "#ggg",
                                "#-12345",
                                "rgb(1,2)",
                                "rgb(1,2,3",
                                "rgb(1,2,3,4,5)",
                                "rgb(1,50%,3)",
                                "rgb(1e999,2,3)",
                                "rgb(nan,2,3)",
                                "lab(50 20)",
                                "light blue",
                                "color(zap 1 1 1)",
                                "color()",
                                "light-dark(red",
                                "nocolour",
                                "hsl(a,b,c)",
                                "rgb()",
                                "url(#a)"})
            row(bad, "none");
    }
    void colours()
    {
        QFETCH(QString, expected);
        QCOMPARE(name(app::svg::parseColour(QTest::currentDataTag())), expected);
    }

    void allNamesOfSvg()
    {
        int count = 0;
        for (const QString& known : QColor::colorNames()) {
            if (known == "transparent")
                continue;
            ++count;
            const QColor expected = QColor::fromString(known);
            QCOMPARE(name(app::svg::parseColour(known.toStdString())),
                     QStringLiteral("%1 %2 %3 255")
                         .arg(expected.red())
                         .arg(expected.green())
                         .arg(expected.blue()));
        }
        QCOMPARE(count, 147);
    }

    void missingPropertiesHaveSvgsDefaults()
    {
        const app::Style plain = shapeOf(triangle + "/>").style;
        QCOMPARE(name(style("").fill), "none"); // a line has nothing to fill
        QCOMPARE(name(plain.fill), "0 0 0 255");
        QCOMPARE(name(plain.stroke), "none");
        QCOMPARE(plain.width, 1.0);
        QCOMPARE(plain.miterLimit, 4.0);
    }

    void strengthOfRules()
    {
        QCOMPARE(name(style(" stroke='red'").stroke), "255 0 0 255");
        QCOMPARE(name(style(" stroke='red'", "*{stroke:blue}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", "line{stroke:blue} *{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", ".b{stroke:blue} line{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", ".a.b{stroke:blue} .b{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", "#i{stroke:blue} .a.b{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", ".a{stroke:red} .b{stroke:blue}").stroke), "0 0 255 255");
        QCOMPARE(name(style(" style='stroke:blue'", "#i{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style(" style='stroke:red'", "*{stroke:blue!important}").stroke),
                 "0 0 255 255");
        QCOMPARE(name(style(" style='stroke:blue !important'", "*{stroke:red ! important}").stroke),
                 "0 0 255 255");
        QCOMPARE(name(style(" stroke='blue'", ".c, .ab{stroke:red}").stroke), "0 0 255 255");
        QCOMPARE(name(style("", ".c , .b{stroke:blue}").stroke), "0 0 255 255");
    }

    void comments_data()
    {
        QTest::addColumn<QByteArray>("attributes");
        QTest::addColumn<QByteArray>("sheet");
        const auto row = [](const char* attributes, const char* sheet) {
            QTest::addRow("%s | %s", attributes, sheet)
                << QByteArray(attributes) << QByteArray(sheet);
        };
        row(" style='stroke:blue/* red */'", "");
        row(" style='/* a */stroke:/* b */blue'", "");
        row(" style='fill:red; /* c; */ stroke : blue; /* */'", "");
        row(" style='fill:none;/*stroke:red;*/stroke:blue'", "");
        row(" style='stroke:blue;/* not closed; stroke:red'", "");
        row(" style='stroke/**/:/**/blue/**/!important'", "#i{stroke:red!important}");
        row(" style='font-family:\"/*\";stroke:blue'", "");
        row(" style='filter:url(/*);stroke:blue'", "");
        row(" stroke='blue/* c */'", "");
        row(" stroke='/* c */ blue '", "");
        row("", "#i{/* a */stroke:/* b */blue/* c */;/* d */}");
        row("", "/* #i{stroke:red} */#i/**/.a{stroke:blue}/* e");
        row("", "x{content:'/*'}#i{stroke:blue}y{content:\"*/\"}");
    }
    void comments()
    {
        QFETCH(QByteArray, attributes);
        QFETCH(QByteArray, sheet);
        QCOMPARE(name(style(attributes, sheet).stroke), "0 0 255 255");
    }
    void commentsPartWords()
    {
        const auto dashes = [](const QByteArray& attributes, const QByteArray& sheet) {
            return style(attributes, sheet).dashes;
        };
        const std::vector<double> expected{1, 2};
        QCOMPARE(dashes(" style='stroke-dasharray:1/**/2'", ""), expected);
        QCOMPARE(dashes(" stroke-dasharray='1/**/2'", ""), expected);
        QCOMPARE(dashes("", "#i{stroke-dasharray:1/**/2}"), expected);
    }

    void selectors()
    {
        const auto inGroup = [](const QByteArray& sheet) {
            return name(shapeOf("<style><![CDATA[" + sheet
                                + "]]></style><g class='g'><g><line x2='1' class='a'/></g></g>")
                            .style.stroke);
        };
        QCOMPARE(inGroup(".g .a{stroke:blue}"), "0 0 255 255");
        QCOMPARE(inGroup(".g > .a{stroke:blue}"), "none");
        QCOMPARE(inGroup(".g>g>.a{stroke:blue}"), "0 0 255 255");
        QCOMPARE(inGroup("svg g line[x2]{stroke:blue}"), "0 0 255 255");
        QCOMPARE(inGroup("[class=\"a\"]{stroke:blue}"), "0 0 255 255");
        QCOMPARE(inGroup("[class='b']{stroke:blue}"), "none");
        QCOMPARE(inGroup("/* .a{stroke:red} */ .a/**/{;;stroke/**/:blue;x}"), "0 0 255 255");
        QCOMPARE(inGroup("@media print { .a{stroke:red} } @import 'x'; .a{stroke:blue}"),
                 "0 0 255 255");
        QCOMPARE(inGroup(".a:hover{stroke:red} .a+.a{stroke:red}"), "none");
        QCOMPARE(inGroup(".a{stroke:blue"), "0 0 255 255");
        QCOMPARE(inGroup(":root{stroke:blue}"), "0 0 255 255");
        QCOMPARE(inGroup("g:root{stroke:blue}"), "none");
        QCOMPARE(inGroup(":root .a{stroke:blue} .a{stroke:red}"), "0 0 255 255");
    }

    void rulesForOtherMedia()
    {
        const auto with = [](const QByteArray& sheets) {
            return name(shapeOf(sheets + line + "/>").style.stroke);
        };
        QCOMPARE(with("<style>@media screen{line{stroke:blue}}</style>"), "0 0 255 255");
        QCOMPARE(with("<style>@MEDIA print, all{line{stroke:blue}}</style>"), "0 0 255 255");
        QCOMPARE(with("<style>@media print{line{stroke:blue}}</style>"), "none");
        QCOMPARE(with("<style media='print'>line{stroke:blue}</style>"), "none");
        QCOMPARE(with("<style media='screen'>line{stroke:blue}</style>"), "0 0 255 255");
        QCOMPARE(with("<style type='text/less'>line{stroke:blue}</style>"), "none");
        QCOMPARE(reportOf("<style>@media print{line{stroke:blue}}</style>"), "");
        QCOMPARE(reportOf("<style>@media (min-width:9px){line{stroke:blue}}</style>"),
                 "1 style rule “@media (min-width:9px)”");
        QCOMPARE(reportOf("<style media='(min-width:9px)'>line{stroke:blue}</style>"),
                 "1 style rule “media=(min-width:9px)”");
        // What is not closed in one element does not swallow the next.
        QCOMPARE(with("<style>a{</style><style>line{stroke:blue}</style>"), "0 0 255 255");
    }

    void variables()
    {
        const auto stroke = [](const QByteArray& attributes, const QByteArray& around = "",
                               const QByteArray& sheet = "") {
            return name(shapeOf("<style>" + sheet + "</style><g " + around + "><path d='M0 0h1v1' "
                                + attributes + "/></g>")
                            .style.stroke);
        };
        const QString blue = "0 0 255 255";
        QCOMPARE(stroke("stroke='var(--c1, var(--c2, #00f))'"), blue);
        QCOMPARE(stroke("style='stroke:var(--c,blue)'"), blue);
        QCOMPARE(stroke("style='stroke:VAR( --c , blue )'"), blue);
        QCOMPARE(stroke("style='--c:blue;stroke:var(--c,red)'"), blue);
        QCOMPARE(stroke("style='stroke:var(--c,red);--c:blue'"), blue);
        QCOMPARE(stroke("style='stroke:var(--c)'", "style='--c:blue'"), blue);
        QCOMPARE(stroke("stroke='var(--c)'", "", ":root{--c:var(--d);--d:blue}"), blue);
        QCOMPARE(stroke("style='--c:red!important;--c:blue;stroke:var(--c)'"), "255 0 0 255");
        QCOMPARE(stroke("style='--c:initial;stroke:var(--c,blue)'", "style='--c:red'"), blue);
        QCOMPARE(stroke("style='--C:red;stroke:var(--c,blue)'"), blue); // capitals differ here
        // Without a value the property is as if it were not set.
        QCOMPARE(stroke("style='stroke:var(--c)'", "stroke='blue'"), blue);
        QCOMPARE(stroke("style='--a:var(--b);--b:var(--a);stroke:var(--a,blue)'"), blue);
        QCOMPARE(reportOf("<path d='M0 0h1v1' style='--c:1;stroke:var(--c,red)'/>"),
                 "1 value “stroke: var(--c,red)” that is not understood");
        QCOMPARE(shapeOf("<circle r='var(--r,9)'/>").paths.size(), std::size_t(1));
        QCOMPARE(shapeOf("<path d='M0 0h9' transform='var(--t,scale(2))'/>")
                     .paths.at(0)
                     .segments[0]
                     .to.x,
                 18.0);
    }

    void wordsOfAllProperties()
    {
        const auto width = [](const QByteArray& own) {
            return shapeOf(
                       "<g stroke='red' stroke-width='3'><path d='M0 0h1' stroke-width='5' style='"
                       + own + "'/></g>")
                .style.width;
        };
        QCOMPARE(width("stroke-width:inherit"), 3.0);
        QCOMPARE(width("stroke-width:UNSET"), 3.0);
        QCOMPARE(width("stroke-width:revert"), 3.0);
        QCOMPARE(width("stroke-width:initial"), 1.0);
        QCOMPARE(reportOf("<rect width='9' height='9' style='x:inherit'/>"),
                 "1 value “x: inherit” that is not understood");
    }

    void capitals()
    {
        QCOMPARE(name(style(" style='STROKE:#00F'").stroke), "0 0 255 255");
        QCOMPARE(name(style("", "line{Stroke:Blue}").stroke), "0 0 255 255");
        QCOMPARE(name(shapeOf(triangle + " style='fill:NONE;stroke:CURRENTCOLOR'/>").style.fill),
                 "none");
        QCOMPARE(style(" style='stroke-linecap:ROUND'").cap, app::Cap::Round);
        QVERIFY(shapeOf(triangle + " style='display:NONE'/>").hidden);
    }

    void rulesThatAreNotUnderstoodAreReported()
    {
        QCOMPARE(reportOf("<style>.a:hover{} @media x{} .b{}</style>"), "1 style rule “@media x”");
        QCOMPARE(reportOf("<style>@font-face{} @keyframes a{} @charset 'x'; @page{}</style>"), "");
        const auto result = readText(drawing("\n<style>/* a\nb */.a{}\n.b /*\n*/ > .c:lang(x){}\n"
                                             "</style><style>.d:has(.e){}</style>"));
        const auto& report = result.value->report;
        QCOMPARE(report.size(), std::size_t(2));
        QCOMPARE(report[0].line, 4);
        QCOMPARE(report[1].line, 6);
    }

    void inheritance()
    {
        const auto child = [](const QByteArray& parent, const QByteArray& own) {
            return shapeOf("<g " + parent + "><path d='M0 0h1v1' " + own + "/></g>").style;
        };
        QCOMPARE(name(child("stroke='blue'", "").stroke), "0 0 255 255");
        QCOMPARE(name(child("fill='blue'", "fill='red' style='fill:inherit'").fill), "0 0 255 255");
        QCOMPARE(name(child("color='blue' stroke='currentColor'", "color='red'").stroke),
                 "255 0 0 255");
        QCOMPARE(name(child("fill='blue'", "fill='no-such'").fill), "0 0 255 255");
        QCOMPARE(child("stroke-dasharray='1,2 3'", "").dashes, (std::vector<double>{1, 2, 3}));
        QCOMPARE(child("stroke-dasharray='1,2'", "stroke-dasharray='none'").dashes,
                 std::vector<double>());
        QCOMPARE(child("stroke-dasharray='1,2'", "stroke-dasharray='0 0'").dashes,
                 std::vector<double>());
        QCOMPARE(child("stroke-linecap='square'", "").cap, app::Cap::Square);
    }

    void opacitiesMultiply()
    {
        QCOMPARE(name(style(" stroke='#00f' stroke-opacity='.5'").stroke), "0 0 255 128");
        QCOMPARE(name(style(" stroke='#00f8' opacity='50%'").stroke), "0 0 255 68");
        const auto nested =
            shapeOf("<g opacity='.5'><g opacity='.5'><line x2='1' stroke='#00f'/></g></g>");
        QCOMPARE(name(nested.style.stroke), "0 0 255 64");
    }

    void lengths()
    {
        QCOMPARE(style(" stroke-width='1in'").width, 96.0);
        QCOMPARE(style(" stroke-width='2.54cm'").width, 96.0);
        QCOMPARE(style(" stroke-width='3PT'").width, 4.0);
        QCOMPARE(style(" stroke-width='2em' style='font-size:10px'").width, 20.0); // its own
        QCOMPARE(style(" stroke-width='10%'").width, 10.0);
        QCOMPARE(style(" stroke-width='-1'").width, 1.0);
        QCOMPARE(style(" stroke-width='1 2'").width, 1.0);
    }

    void transformsScaleStrokes()
    {
        const auto scaled = [](const QByteArray& transform, const QByteArray& own = "") {
            return shapeOf("<g transform='" + transform
                           + "'><line x2='1' stroke='red' stroke-width='2' "
                             "stroke-dasharray='1 2' stroke-dashoffset='3' "
                           + own + "/></g>")
                .style;
        };
        QCOMPARE(scaled("scale(3)").width, 6.0);
        QCOMPARE(scaled("scale(3)").dashes, (std::vector<double>{3, 6}));
        QCOMPARE(scaled("scale(3)").dashOffset, 9.0);
        QCOMPARE(scaled("rotate(90)").width, 2.0);
        QCOMPARE(scaled("scale(1,-4)").width, 8.0); // horizontal lines
        QCOMPARE(scaled("scale(3)", "vector-effect='non-scaling-stroke'").width, 2.0);
        QCOMPARE(scaled("scale(1,2)").width, 4.0); // a horizontal line: nothing is lost
        QCOMPARE(reportOf("<line x2='1' stroke='red' transform='scale(1,2)'/>"), "");
        const QByteArray corner = "<path d='M0 0H3V3' fill='none' stroke='red' "
                                  "stroke-dasharray='1' transform='scale(1,2)'/>";
        QCOMPARE(reportOf(corner), "1 unevenly stretched stroke");
        QCOMPARE(shapeOf(corner).style.width, 4.0 / 3); // 3 units of width 2, 6 units of width 1
        QCOMPARE(shapeOf(corner).style.dashes, std::vector<double>{1.5});
        QCOMPARE(reportOf("<line x2='1' fill='red' transform='scale(1,2)'/>"), "");
    }

    void gradientsAndPatternsBecomeColours()
    {
        const QByteArray defs =
            "<defs><linearGradient id='s'><stop stop-color='#0000ff' "
            "stop-opacity='.2'/><stop/></linearGradient>"
            "<radialGradient id='r' xlink:href='#s'/><linearGradient id='one'><stop "
            "style='stop-color:red'/></linearGradient>"
            "<linearGradient id='loop' xlink:href='#loop'/><pattern id='p'/></defs>";
        const auto fill = [&](const QByteArray& value) {
            return name(shapeOf(defs + triangle + " fill='" + value + "'/>").style.fill);
        };
        QCOMPARE(fill("url(#r)"), "0 0 0 255"); // both stops are at its centre
        QCOMPARE(fill("url( &quot;#one&quot; )"), "255 0 0 255");
        QCOMPARE(fill("url(#loop)"), "none");
        QCOMPARE(fill("url(#p)"), "none");
        QCOMPARE(fill("url(#p) red"), "255 0 0 255");
        QCOMPARE(fill("url(#nothing) #00f"), "0 0 255 255");
        QCOMPARE(fill("url(#nothing) currentColor"), "0 0 0 255");
        QCOMPARE(fill("URL(#one)"), "255 0 0 255");
        QCOMPARE(fill("url(#nothing)"), "none");
        QCOMPARE(reportOf(defs + triangle + " fill='url(#r)' stroke='url(#p)'/>"),
                 "1 pattern; 1 gradient");
        QCOMPARE(reportOf(defs + triangle + " fill='url(#one)'/>"), "");
    }
};

} // namespace formats_svg_style_test

TEST_CLASS(formats_svg_style_test::StyleTest, None)
#include "tests/app/formats/svg/style_test.moc"

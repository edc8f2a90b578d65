// SPDX-License-Identifier: GPL-3.0-or-later
// Every property either changes what is drawn, or changes nothing in any program, or is told.
#include "app/formats/svg/property.h"

#include <QTest>

#include <map>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace formats_svg_property_test {

using namespace app::svg;

namespace {

// A value of each property that is evaluated, which differs from what it is without it.
const std::map<std::string_view, const char*> samples{
    {"color", "red"},
    {"fill", "red"},
    {"stroke", "blue"},
    {"fill-opacity", "0.5"},
    {"stroke-opacity", "50%"},
    {"stroke-width", "2px"},
    {"stroke-miterlimit", "7"},
    {"stroke-dashoffset", "3"},
    {"stroke-dasharray", "1 2"},
    {"stroke-linecap", "round"},
    {"stroke-linejoin", "bevel"},
    {"fill-rule", "evenodd"},
    {"clip-rule", "evenodd"},             // checked by itself
    {"color-interpolation", "linearRGB"}, // checked by itself
    {"visibility", "hidden"},
    {"paint-order", "stroke"},
    {"font", "italic bold 9px monospace"},
    {"font-size", "40px"},
    {"font-family", "monospace"},
    {"font-style", "italic"},
    {"font-weight", "bold"},
    {"font-variant", "small-caps"},
    {"letter-spacing", "2px"},
    {"word-spacing", "2px"},
    {"writing-mode", "vertical-rl"},
    {"text-anchor", "end"},
    {"direction", "rtl"},
    {"white-space", "pre"},
    {"dominant-baseline", "middle"},
    {"alignment-baseline", "middle"},
    {"baseline-shift", "super"},
    {"text-decoration", "underline"},
    {"text-decoration-line", "underline"},
    {"text-transform", "uppercase"},
    {"font-feature-settings", "'smcp'"},
    {"font-kerning", "none"},
    {"font-size-adjust", "2"},
    {"font-stretch", "condensed"},
    {"font-variant-alternates", "historical-forms"},
    {"font-variant-caps", "small-caps"},
    {"font-variant-east-asian", "ruby"},
    {"font-variant-ligatures", "none"},
    {"font-variant-numeric", "ordinal"},
    {"font-variant-position", "sub"},
    {"font-variation-settings", "'wght' 9"},
    {"glyph-orientation-horizontal", "90deg"},
    {"glyph-orientation-vertical", "90deg"},
    {"inline-size", "9px"},
    {"kerning", "0"},
    {"shape-inside", "url(#s)"},
    {"text-combine-upright", "all"},
    {"text-emphasis", "dot"},
    {"text-indent", "9px"},
    {"text-orientation", "upright"},
    {"text-rendering", "optimizeSpeed"},
    {"text-shadow", "1px 1px red"},
    {"unicode-bidi", "bidi-override"},
    {"marker-start", "url(#m)"},
    {"marker-mid", "url(#m)"},
    {"marker-end", "url(#m)"},
    {"marker", "url(#m)"},
    {"opacity", "0.25"},
    {"display", "none"},
    {"overflow", "visible"},
    {"vector-effect", "non-scaling-stroke"},
    {"clip-path", "url(#c)"},
    {"mask", "url(#m)"},
    {"mask-type", "alpha"}, // checked by itself
    {"image-rendering", "pixelated"},
    {"filter", "url(#f)"},
    {"mix-blend-mode", "multiply"},
    {"stop-color", "red"},
    {"stop-opacity", "0.5"},
    {"transform", "scale(2)"},
    {"transform-origin", "10px 20px"},
    {"transform-box", "fill-box"},
    {"translate", "5px 6px"},
    {"rotate", "90deg"},
    {"scale", "2 3"},
    {"x", "3px"},
    {"y", "3px"},
    {"cx", "3px"},
    {"cy", "3px"},
    {"r", "3px"},
    {"rx", "3px"},
    {"ry", "3px"},
    {"width", "3px"},
    {"height", "3px"},
    {"d", "path('M0 0h7v7')"},
};

// Shapes on which every property has an effect, with a style.
QByteArray shapes(const QByteArray& style)
{
    const QByteArray of = " style='" + style + "'";
    return "<clipPath id='c'><path d='M0 0H50V50H0z'/></clipPath>"
           "<linearGradient id='g'><stop"
           + of
           + "/></linearGradient>"
             "<g transform='scale(2)' stroke='#000' fill='#0f0'><path d='M0 0h30v30h-30zM5 5h9v9z'"
           + of + "/><g transform='rotate(9)' transform-origin='1 1'" + of
           + "><path d='M60 60h30' stroke-width='.1em'" + of
           + "/></g><path d='M1 1h5v5' fill='url(#g)'/><path d='M1 1h5v5' fill='currentColor'" + of
           + "/><rect width='40' height='40' rx='1' ry='1'" + of + "/><circle r='9'" + of
           + "/><ellipse rx='9' ry='8'" + of + "/><svg width='9' height='9' viewBox='0 0 9 9'" + of
           + "><path d='M0 0h60'/></svg><rect x='10' y='10' width='20' height='10' "
             "transform='skewX(9)'"
             " style='transform-origin:2px 1px;"
           + style + "'/></g><text x='50' y='50'>a  b<tspan" + of
           + "> c  d</tspan></text><text x='50' y='60'" + of + ">e  f AVA</text>";
}

struct Read {
    QByteArray text;
    QString report;
};

Read read(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? Read{textOf(result.value->document), reportOf(elements)}
                  : Read{{}, result.error};
}

// "style" stands for the whole name.
QByteArray nameOf(std::string_view pattern)
{
    QByteArray name(pattern.data(), qsizetype(pattern.size()));
    return name.endsWith('*') ? name.chopped(1) + "x" : name;
}

// Whether any value is told as a use of the property, where there are texts.
bool isToldByName(const Property& property)
{
    const auto name = nameOf(property.name);
    const auto told = "use of the style property “" + QString(name) + "”";
    return reportOf("<text>a<tspan style='" + name + ":nonsense(1)'>b</tspan></text>")
        .contains(told);
}

} // namespace

class PropertyTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsEvaluatedChangesTheDrawingOrIsTold()
    {
        const Read plain = read(shapes(""));
        for (const Property& property : properties()) {
            QVERIFY2(samples.contains(property.name), property.name.data());
            const QByteArray name = nameOf(property.name);
            if (name == "clip-rule" || name == "mask-type" || name == "color-interpolation"
                || name == "image-rendering")
                continue; // in clip paths, masks and images alone: clip_path_test, mask_test,
                          // image_test
            const Read styled = read(shapes(name + ':' + samples.at(property.name)));
            VERIFY_OR_SAY(styled.text != plain.text || styled.report != plain.report, name);
            VERIFY_OR_SAY(!styled.report.contains("understood"), styled.report.toUtf8());
        }
    }

    void capitalsMeanTheSame()
    {
        for (const Property& property : properties()) {
            const QByteArray name = nameOf(property.name), value = samples.at(property.name);
            const Read small = read(shapes(name + ':' + value));
            VERIFY_OR_SAY(read(shapes(name.toUpper() + ':' + value)).text == small.text, name);
        }
    }

    void valuesThatAreNotUnderstoodAreTold()
    {
        const Read plain = read(shapes(""));
        for (const Property& property : properties()) {
            const QByteArray name = nameOf(property.name);
            const bool anyWord = name == "display" || name == "overflow" || name == "font-family"
                                 || name == "mask" || name == "filter" || name == "mix-blend-mode"
                                 || name == "clip-path" || name.startsWith("marker");
            if (anyWord || isToldByName(property))
                continue;
            const Read wrong = read(shapes(name + ":nonsense(1)"));
            VERIFY_OR_SAY(wrong.text == plain.text, name);
            VERIFY_OR_SAY(wrong.report.contains("“" + name + ": nonsense(1)”"), name);
        }
    }

    void whatIsLostIsToldWithItsName()
    {
        for (const LostProperty& property : lostProperties()) {
            const QByteArray name = nameOf(property.name);
            const QByteArray root = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9' "
                                    "style='"
                                    + name + ":something'><path d='M0 0h1'/></svg>";
            const auto ofRoot = readText(root);
            QVERIFY(ofRoot);
            QCOMPARE(ofRoot.value->report.size(), std::size_t(1));
            QCOMPARE(ofRoot.value->report[0].what, "use of the style property “" + name + "”");
            QVERIFY(isLossy(*ofRoot.value));
            const QString told = reportOf("<path d='M0 0h1' style='" + name + ":something'/>");
            QCOMPARE(told.isEmpty(), property.ofRoot);
            for (const QByteArray& value : QByteArray(property.without.data()).split(' '))
                if (!value.isEmpty())
                    QCOMPARE(reportOf("<path d='M0 0h1' style='" + name + ':' + value + "'/>"), "");
        }
    }

    void whatHasNoEffectIsNotTold()
    {
        for (const std::string_view pattern : propertiesWithoutEffect())
            QCOMPARE(reportOf("<path d='M0 0h1' style='" + nameOf(pattern) + ":something'/>"), "");
    }

    void everyPropertyIsInOneTable()
    {
        QSet<QByteArray> names;
        const auto add = [&](std::string_view name) {
            const QByteArray bytes(name.data(), qsizetype(name.size()));
            QVERIFY2(!names.contains(bytes), bytes);
            names << bytes;
        };
        for (const Property& property : properties())
            add(property.name);
        for (const LostProperty& property : lostProperties())
            add(property.name);
        for (const std::string_view pattern : propertiesWithoutEffect())
            add(pattern);
    }

    void unknownPropertiesAreToldOnceWithTheirNumberAndFirstLine()
    {
        const auto result =
            readText(drawing("<style>\n.a{zap:1;fill:red}</style>\n<path d='M0 0h1' class='a'/>\n"
                             "<path d='M0 0h1' style='zap:2'/><path d='M0 0h1' style='zip:3'/>"));
        QVERIFY(result);
        const auto& report = result.value->report;
        QCOMPARE(report.size(), std::size_t(2));
        QCOMPARE(report[0].what, "uses of the style property “zap”");
        QCOMPARE(report[0].count, 2);
        QCOMPARE(report[0].line, 3);
        QCOMPARE(report[1].what, "use of the style property “zip”");
        QCOMPARE(report[1].line, 4);
    }

    void aThousandUnknownPropertiesAreAFewLines()
    {
        QByteArray style;
        for (int i = 0; i < 1000; ++i)
            style += "z" + QByteArray::number(i) + ":1;";
        const auto result = readText(drawing("<path d='M0 0h1' style='" + style + "'/>"));
        QCOMPARE(result.value->report.size(), std::size_t(21));
        QCOMPARE(result.value->report.back().count, 980);
    }

    void prefixesOfBrowsersAreOtherNames()
    {
        const auto moved = [](const QByteArray& style) {
            return read("<path d='M0 0h1' style='" + style + "'/>").text;
        };
        QCOMPARE(moved("-webkit-transform:scale(2)"), moved("transform:scale(2)"));
        QCOMPARE(reportOf("<path d='M0 0h1' style='-webkit-animation:a 1s'/>"),
                 "1 use of the style property “animation”");
        QCOMPARE(reportOf("<path d='M0 0h1' style='-webkit-font-smoothing:none;-moz-zip:1;"
                          "-inkscape-stroke:hairline'/>"),
                 "");
    }
};

} // namespace formats_svg_property_test

TEST_CLASS(formats_svg_property_test::PropertyTest, Gui)
#include "tests/app/formats/svg/property_test.moc"

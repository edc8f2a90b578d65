// SPDX-License-Identifier: GPL-3.0-or-later
// Every attribute of SVG is read, or told, or changes nothing.
#include "app/formats/svg/attribute_effects.h"
#include "app/formats/svg/property.h"

#include <QTest>

#include <set>

#include "tests/app/formats/lossy.h"
#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace formats_svg_attribute_effects_test {

using namespace app::svg;
using Kind = AttributeEffect::Kind;

namespace {

// The index of attributes of SVG 2, and what SVG 1.1 and SVG Tiny 1.2 had besides.
const QByteArray attributesOfSvg =
    "accent-height accumulate additive alphabetic amplitude arabic-form ascent attributeName "
    "attributeType autofocus azimuth baseFrequency baseProfile bbox begin bias by calcMode "
    "cap-height class clip clipPathUnits contentScriptType contentStyleType crossorigin cx cy d "
    "descent diffuseConstant divisor download dur dx dy edgeMode editable elevation end exponent "
    "externalResourcesRequired fill filterRes filterUnits focusHighlight focusable format fr from "
    "fx fy g1 g2 glyph-name glyphRef gradientTransform gradientUnits hanging height horiz-adv-x "
    "horiz-origin-x horiz-origin-y href hreflang id ideographic in in2 intercept k k1 k2 k3 k4 "
    "kernelMatrix kernelUnitLength keyPoints keySplines keyTimes lang lengthAdjust "
    "limitingConeAngle local markerHeight markerUnits markerWidth maskContentUnits maskUnits "
    "mathematical max media method min mode name nav-down nav-left nav-next nav-prev nav-right "
    "nav-up numOctaves offset onabort onactivate onbegin onclick onend onerror onfocusin "
    "onfocusout "
    "onload onmousedown onmousemove onmouseout onmouseover onmouseup onrepeat onresize onscroll "
    "onunload onzoom operator order orient orientation origin overline-position "
    "overline-thickness panose-1 path pathLength patternContentUnits patternTransform patternUnits "
    "ping playbackorder points pointsAtX pointsAtY pointsAtZ preserveAlpha preserveAspectRatio "
    "primitiveUnits r radius referrerpolicy refX refY rel rendering-intent repeatCount repeatDur "
    "requiredExtensions requiredFeatures requiredFonts requiredFormats restart result role rotate "
    "rx ry scale seed side slope snapshotTime spacing specularConstant specularExponent "
    "spreadMethod startOffset stdDeviation stemh stemv stitchTiles strikethrough-position "
    "strikethrough-thickness string style surfaceScale syncBehavior syncMaster syncTolerance "
    "systemLanguage tabindex tableValues target targetX targetY textLength timelinebegin title to "
    "transform transform-origin transferBehavior type u1 u2 underline-position "
    "underline-thickness unicode unicode-range units-per-em v-alphabetic v-hanging v-ideographic "
    "v-mathematical values version vert-adv-y vert-origin-x vert-origin-y viewBox viewTarget width "
    "widths x x-height x1 x2 xChannelSelector xlink:actuate xlink:arcrole xlink:href xlink:role "
    "xlink:show xlink:title xlink:type xml:base xml:lang xml:space y y1 y2 yChannelSelector z "
    "zoomAndPan aria-label data-note";

// The presentation attributes of SVG 1.1 and SVG 2.
const QByteArray presentationAttributes =
    "alignment-baseline baseline-shift clip clip-path clip-rule color color-interpolation "
    "color-interpolation-filters color-profile color-rendering cursor direction display "
    "dominant-baseline enable-background fill fill-opacity fill-rule filter flood-color "
    "flood-opacity font-family font-size font-size-adjust font-stretch font-style font-variant "
    "font-weight glyph-orientation-horizontal glyph-orientation-vertical image-rendering kerning "
    "letter-spacing lighting-color marker-end marker-mid marker-start mask mask-type opacity "
    "overflow paint-order pointer-events shape-rendering stop-color stop-opacity stroke "
    "stroke-dasharray stroke-dashoffset stroke-linecap stroke-linejoin stroke-miterlimit "
    "stroke-opacity stroke-width text-anchor text-decoration text-overflow text-rendering "
    "unicode-bidi vector-effect visibility white-space word-spacing writing-mode";

// The properties of SVG 2 and of the modules of CSS that say how SVG is drawn.
const QByteArray propertiesOfCss =
    "backdrop-filter background-blend-mode clip-path clip-rule color-scheme filter font "
    "font-feature-settings font-kerning font-language-override font-optical-sizing font-palette "
    "font-synthesis font-variant-emoji font-variation-settings inline-size isolation line-height "
    "mask mask-border mask-clip mask-composite mask-image mask-mode mask-origin mask-position "
    "mask-repeat mask-size mix-blend-mode offset-path perspective rotate scale "
    "shape-image-threshold "
    "shape-inside shape-margin shape-padding shape-subtract solid-color solid-opacity "
    "text-align text-align-all text-align-last text-combine-upright text-decoration-color "
    "text-decoration-line text-decoration-style text-indent text-orientation text-shadow "
    "text-transform transform transform-box transform-origin transform-style translate "
    "white-space-collapse will-change zoom x y cx cy r rx ry width height d all animation "
    "transition content";

bool isRead(const Property* property)
{
    return property && property->attribute != Property::Attribute::Other;
}

// Elements on which the attribute may have an effect.
QByteArray with(const QByteArray& attribute)
{
    return "<g " + attribute + "><path d='M0 0H9V9' " + attribute + "/><rect width='5' height='5' "
           + attribute + "/></g><text y='50' " + attribute + ">a<tspan " + attribute
           + ">b</tspan></text>";
}

struct Example {
    const char* name;
    const char* with;    ///< elements with it
    const char* without; ///< the same without it
};

// Where the attributes are read that are no properties.
const std::vector<Example> examples{
    {"class", "<style>.a{fill:red}</style><path d='M0 0H9V9' class='a'/>",
     "<style>.a{fill:red}</style><path d='M0 0H9V9'/>"},
    {"href", "<path id='p' d='M0 0H9'/><use href='#p' x='5'/>", "<path id='p' d='M0 0H9'/><use/>"},
    {"xlink:href", "<path id='p' d='M0 0H9'/><use xlink:href='#p'/>",
     "<path id='p' d='M0 0H9'/><use/>"},
    {"id", "<path id='p' d='M0 0H9'/>", "<path d='M0 0H9'/>"},
    {"requiredExtensions", "<path d='M0 0H9' requiredExtensions='a'/>", "<path d='M0 0H9'/>"},
    {"systemLanguage", "<path d='M0 0H9' systemLanguage='de'/>", "<path d='M0 0H9'/>"},
    {"style", "<path d='M0 0H9V9' style='fill:red'/>", "<path d='M0 0H9V9'/>"},
    {"xml:space", "<text xml:space='preserve'>a   b</text>", "<text>a   b</text>"},
    {"pathLength", "<path d='M0 0H9' stroke='red' stroke-dasharray='2' pathLength='3'/>",
     "<path d='M0 0H9' stroke='red' stroke-dasharray='2'/>"},
    {"points", "<polygon points='0 0 5 0 5 5'/>", "<polygon/>"},
    {"viewBox", "<svg width='9' height='9' viewBox='0 0 3 3'><path d='M0 0H2'/></svg>",
     "<svg width='9' height='9'><path d='M0 0H2'/></svg>"},
    {"preserveAspectRatio",
     "<svg width='9' height='5' viewBox='0 0 3 3' preserveAspectRatio='none'>"
     "<path d='M0 0H2'/></svg>",
     "<svg width='9' height='5' viewBox='0 0 3 3'><path d='M0 0H2'/></svg>"},
    {"x1", "<line x1='4' x2='9'/>", "<line x2='9'/>"},
    {"x2", "<line x2='9'/>", "<line/>"},
    {"y1", "<line y1='4' x2='9'/>", "<line x2='9'/>"},
    {"y2", "<line y2='4' x2='9'/>", "<line x2='9'/>"},
    {"dx", "<text dx='5'>a</text>", "<text>a</text>"},
    {"dy", "<text dy='5'>a</text>", "<text>a</text>"},
    {"rotate", "<text rotate='5'>a</text>", "<text>a</text>"},
    {"textLength", "<text textLength='50'>ab</text>", "<text>ab</text>"},
    {"lengthAdjust", "<text textLength='50' lengthAdjust='spacingAndGlyphs'>ab</text>",
     "<text textLength='50'>ab</text>"},
    {"path", "<text><textPath path='M0 9H90'>a</textPath></text>",
     "<text><textPath>a</textPath></text>"},
    {"side", "<text><textPath path='M0 9H90' side='right'>a</textPath></text>",
     "<text><textPath path='M0 9H90'>a</textPath></text>"},
    {"startOffset", "<text><textPath path='M0 9H90' startOffset='9'>a</textPath></text>",
     "<text><textPath path='M0 9H90'>a</textPath></text>"},
    {"clipPathUnits",
     "<clipPath id='c' clipPathUnits='objectBoundingBox'><path d='M0 0H.5V1H0z'/></clipPath>"
     "<path d='M0 0H9V9' clip-path='url(#c)'/>",
     "<clipPath id='c'><path d='M0 0H.5V1H0z'/></clipPath><path d='M0 0H9V9' "
     "clip-path='url(#c)'/>"},
    {"maskContentUnits",
     "<mask id='c' maskContentUnits='objectBoundingBox'><path d='M0 0H.5V1H0z' fill='#fff'/>"
     "</mask><path d='M0 0H9V9' mask='url(#c)'/>",
     "<mask id='c'><path d='M0 0H.5V1H0z' fill='#fff'/></mask><path d='M0 0H9V9' "
     "mask='url(#c)'/>"},
    {"maskUnits",
     "<mask id='c' maskUnits='userSpaceOnUse' width='.5' height='1'><path d='M0 0H9V9H0z' "
     "fill='#fff'/></mask><path d='M0 0H9V9' mask='url(#c)'/>",
     "<mask id='c' width='.5' height='1'><path d='M0 0H9V9H0z' fill='#fff'/></mask>"
     "<path d='M0 0H9V9' mask='url(#c)'/>"},
    {"media", "<style media='print'>path{fill:red}</style><path d='M0 0H9V9'/>",
     "<style>path{fill:red}</style><path d='M0 0H9V9'/>"},
    {"type", "<style type='text/plain'>path{fill:red}</style><path d='M0 0H9V9'/>",
     "<style>path{fill:red}</style><path d='M0 0H9V9'/>"},
};

const QByteArray arrow = "><path d='M0 0H2V1z'/></marker><path d='M0 0H9V9' stroke='red' "
                         "stroke-width='2' marker-end='url(#m)'/>";
const QByteArray blend = "><stop stop-color='red'/><stop offset='.4' stop-color='lime'/></";
const QByteArray filled = "<path d='M0 0H9V9H2z' fill='url(#f)'/>";
const QByteArray tile = "><path d='M0 0H3V9H0z' fill='red'/></pattern>";

QByteArray textOfElements(const QByteArray& elements)
{
    const auto result = readText(drawing(elements));
    return result ? textOf(result.value->document) : result.error.toUtf8();
}

} // namespace

class AttributeEffectsTest : public QObject {
    Q_OBJECT

private slots:
    void everyAttributeOfSvgIsKnown()
    {
        for (const QByteArray& name : attributesOfSvg.split(' '))
            VERIFY_OR_SAY(isRead(findProperty(name.toStdString()))
                              || effectOf(name.toStdString()).kind != Kind::Unknown,
                          name);
        for (const QByteArray& name : presentationAttributes.split(' '))
            VERIFY_OR_SAY(isRead(findProperty(name.toStdString()))
                              || effectOf(name.toStdString()).kind != Kind::Unknown,
                          name);
    }

    void everyPropertyIsReadOrToldOrWithoutEffect()
    {
        for (const QByteArray& name : (presentationAttributes + ' ' + propertiesOfCss).split(' ')) {
            const std::string text = name.toStdString();
            const bool isLostRow = std::ranges::any_of(lostProperties(), [&](const auto& row) {
                return row.name == text
                       || (row.name.ends_with('*')
                           && text.starts_with(row.name.substr(0, row.name.size() - 1)));
            });
            VERIFY_OR_SAY(findProperty(text) || hasNoEffect(text) || isLostRow, name);
        }
    }

    void whatHasNoEffectChangesNothing()
    {
        const QByteArray plain = textOfElements(with(""));
        for (const AttributeEffect& row : attributeEffects()) {
            const std::string_view pattern = row.name;
            QByteArray name(pattern.data(), qsizetype(pattern.size()));
            if (name.endsWith('*'))
                name.replace('*', "x");
            if (row.kind != Kind::None || findProperty(pattern) || pattern.starts_with("onload"))
                continue;
            VERIFY_OR_SAY(textOfElements(with(name + "='1'")) == plain, name);
            VERIFY_OR_SAY(reportOf(with(name + "='1'")) == reportOf(with("")), name);
        }
    }

    void whatIsReadChangesTheDrawing()
    {
        std::set<QByteArray> shown;
        for (const Example& each : examples) {
            shown.insert(each.name);
            VERIFY_OR_SAY(textOfElements(each.with) != textOfElements(each.without)
                              || reportOf(each.with) != reportOf(each.without),
                          each.name);
        }
        const auto differ = [&](const QByteArray& attribute, const QByteArray& before,
                                const QByteArray& after) {
            const QByteArray name = attribute.left(attribute.indexOf('='));
            shown.insert(name);
            VERIFY_OR_SAY(textOfElements(before + ' ' + attribute + after)
                              != textOfElements(before + after),
                          name);
        };
        for (const char* attribute : {"markerWidth='1'", "markerHeight='.5'", "orient='90'",
                                      "refX='1'", "refY='1'", "markerUnits='userSpaceOnUse'"})
            differ(attribute, "<marker id='m'", arrow);
        for (const char* attribute : {"gradientUnits='userSpaceOnUse'",
                                      "gradientTransform='scale(9)'", "spreadMethod='repeat'"})
            differ(attribute, "<linearGradient id='f' x2='.3'", blend + "linearGradient>" + filled);
        for (const char* attribute : {"fx='.1'", "fr='.3'"})
            differ(attribute, "<radialGradient id='f'", blend + "radialGradient>" + filled);
        differ("fy='.1'", "<radialGradient id='f' fx='.1'", blend + "radialGradient>" + filled);
        differ("offset='.9'",
               "<linearGradient id='f'><stop offset='.1' stop-color='red'/><stop "
               "stop-color='blue'",
               "/></linearGradient>" + filled);
        for (const char* attribute :
             {"patternUnits='userSpaceOnUse'", "patternContentUnits='objectBoundingBox'"})
            differ(attribute, "<pattern id='f' width='.9' height='.9'", tile + filled);
        for (const AttributeEffect& row : attributeEffects())
            if (row.kind == Kind::Read) {
                const QByteArray name(row.name.data(), qsizetype(row.name.size()));
                VERIFY_OR_SAY(shown.contains(name), name);
            }
    }

    void whatIsLostIsTold()
    {
        for (const AttributeEffect& row : attributeEffects()) {
            if (row.kind != Kind::Lost)
                continue;
            const QByteArray name(row.name.data(), qsizetype(row.name.size()));
            QCOMPARE(reportOf("<path d='M0 0H9' " + name + "='rect(1 2 3 4)'/>"),
                     "1 use of the attribute “" + name + "”");
            for (const QByteArray& plain :
                 QByteArray(row.without.data(), qsizetype(row.without.size())).split(' '))
                QCOMPARE(reportOf("<path d='M0 0H9' " + name + "='" + plain + "'/>"),
                         plain.isEmpty() ? "1 use of the attribute “" + name + "”" : QByteArray());
        }
    }

    void unknownAttributesAreToldOnceWithTheirNumber()
    {
        const auto result =
            readText(drawing("<path d='M0 0H9' zap='1'/>\n<path d='M0 0H9' zap='2' viewbox='0'/>"
                             "<path d='M0 0H9' inkscape:zap='1' data-zap='1' aria-zap='1'/>"));
        QVERIFY(result);
        const auto& report = result.value->report;
        QCOMPARE(report.size(), std::size_t(2));
        QCOMPARE(report[0].what, "attributes “zap” that SVG does not have were ignored");
        QCOMPARE(report[0].count, 2);
        QCOMPARE(report[1].what, "attribute “viewbox” that SVG does not have was ignored");
        QVERIFY(!isLossy(*result.value));
    }
};

} // namespace formats_svg_attribute_effects_test

TEST_CLASS(formats_svg_attribute_effects_test::AttributeEffectsTest, Gui)
#include "tests/app/formats/svg/attribute_effects_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
// <text> as the outlines of its letters. Each part in one style is an object that can be edited as
// a text, as long as its letters stand on a straight line.
#include "app/base/text.h"

#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/formats/svg/text_layout.h"
#include "app/formats/svg/tree_drawer.h"
#include "app/lettering/lettering.h"
#include "app/lettering/named_font.h"
#include "app/lettering/outline_fonts.h"

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

QString inCase(const QString& text, TextStyle::Case letterCase)
{
    return letterCase == TextStyle::Case::Upper   ? text.toUpper()
           : letterCase == TextStyle::Case::Lower ? text.toLower()
                                                  : text;
}

// The recipe that makes the letters again, in the document's coordinates.
Recipe textRecipe(const LaidLetters& letters, const LineFont& font, double capital,
                  const Matrix& matrix)
{
    QString text = letters.text;
    while (text.endsWith(u' '))
        text.chop(1);
    if (text.isEmpty() || !matrix.keepsShapes() || text.size() > longestText)
        return {};
    const FontFace face = faceOf(font.family, {font.weight >= 600, font.italic});
    return TextRecipe{.text = std::move(text),
                      .font = font.family,
                      .size = capital * matrix.scale(),
                      .at = matrix(letters.at),
                      .turn = std::atan2(matrix.b, matrix.a),
                      .mirrored = matrix.determinant() < 0,
                      .face = face};
}

Subpath bar(const Point& min, const Point& max)
{
    return {min, {{{max.x, min.y}}, {max}, {{min.x, max.y}}}, true};
}

// The lines under, over and through letters.
std::vector<Subpath> linesOf(const LaidLetters& letters, const LineFont& font, std::uint8_t lines)
{
    constexpr double thickness = 0.05; // of the font's size
    struct Line {
        std::uint8_t kind;
        double below; // of the baseline, in sizes of the font
    };
    std::vector<Subpath> bars;
    for (const auto& [kind, below] :
         {Line{TextStyle::underline, 0.1}, Line{TextStyle::overline, -0.85},
          Line{TextStyle::lineThrough, -0.28}})
        if (lines & kind)
            bars.push_back(bar(letters.at + Point{0, below * font.size},
                               letters.at + Point{letters.width, (below + thickness) * font.size}));
    return bars;
}

} // namespace

struct TreeDrawer::Texts {
    TextContent content{};
    std::vector<TextRun> runs{};
    std::vector<Place> places{};     ///< of the runs
    std::vector<QString> replaced{}; ///< of the runs: "Arial → DejaVu Sans", or ""
    std::vector<TextFit> fits{};
};

void TreeDrawer::drawText(Node node, const Place& around)
{
    if (outlineFonts().isEmpty())
        return report_.add(losses::text);
    const Place place = inside(node, around);
    reportEffects(place.properties, false);
    Texts texts;
    const TextParts parts = textParts(node, place, texts);
    if (parts.letters.empty())
        return;
    report_.add(losses::outlinedText);
    const Node named = place.repeated ? around.use : node;
    const bool several = parts.letters.size() > 1 || hasLines(parts, texts);
    const bool grouped = several && named != noNode && !place.repeated;
    Particulars own = named == noNode ? Particulars() : particularsOf(named);
    if (grouped)
        content_.open({.kind = Container::Kind::Group,
                       .svgId = std::exchange(own.id, {}),
                       .title = std::exchange(own.title, {}),
                       .description = std::exchange(own.description, {})});
    for (const LaidLetters& letters : parts.letters) {
        drawLetters(letters, texts, std::exchange(own, {}));
        const Place& run = texts.places[letters.run];
        const TextStyle& style = run.properties.text;
        for (Subpath& line :
             linesOf(letters, texts.runs[letters.run].font, style.lines | style.linesAround))
            addShape({placed({{std::move(line)}}, run.matrix)}, run, {});
    }
    if (grouped)
        content_.close();
}

bool TreeDrawer::hasLines(const TextParts& parts, const Texts& texts)
{
    return std::ranges::any_of(parts.letters, [&](const LaidLetters& letters) {
        const TextStyle& style = texts.places[letters.run].properties.text;
        return (style.lines | style.linesAround) != 0;
    });
}

void TreeDrawer::drawLetters(const LaidLetters& letters, const Texts& texts, Particulars own)
{
    const Place& place = texts.places[letters.run];
    const LineFont& font = texts.runs[letters.run].font;
    own.recipe = textRecipe(letters, font, lineFonts_.measuresOf(font).capital, place.matrix);
    addShape({placed({letters.paths}, place.matrix)}, place, std::move(own));
}

void TreeDrawer::addBoundsOfText(Node node, const Place& place, ElementBounds& bounds)
{
    for (const Subpath& path : letterPaths(node, place))
        include(bounds, path);
}

// The letters of a text in the coordinates of `place.matrix`, whatever their styles.
std::vector<Subpath> TreeDrawer::letterPaths(Node node, const Place& place)
{
    Texts texts;
    std::vector<Subpath> paths;
    for (LaidLetters& letters : textParts(node, place, texts).letters)
        for (Subpath& path : placed({std::move(letters.paths)}, place.matrix))
            paths.push_back(std::move(path));
    return paths;
}

// The letters of a text, in its own coordinates.
TextParts TreeDrawer::textParts(Node node, const Place& place, Texts& texts)
{
    collectText(node, place, {}, texts);
    texts.content.trimEnd();
    const qsizetype count = texts.content.text().size();
    letters_ += std::size_t(count);
    if (letters_ > mostLetters)
        throw Refused{Text::tr("exceeds the limit of %1 letters of texts.").arg(mostLetters)};
    for (TextFit& fit : texts.fits)
        fit.end = std::min(fit.end, count);
    std::erase_if(texts.fits, [](const TextFit& fit) { return fit.end <= fit.first; });
    const TextParts parts = laidOut(texts.content, texts.runs, texts.fits, lineFonts_);
    for (int i = 0; i < parts.unfitted; ++i)
        report_.add(losses::attribute, "textLength");
    for (const QString& missing : parts.missing)
        report_.add(losses::letter, missing.toStdString());
    report_.add(losses::offPath, parts.leavesPath);
    for (const LaidLetters& letters : parts.letters) {
        const QString& replaced = texts.replaced[letters.run];
        if (!replaced.isEmpty())
            report_.add(losses::replacedFont, replaced.toStdString());
        const auto notEvaluated = texts.places[letters.run].properties.text.notEvaluated;
        if (!notEvaluated.empty())
            report_.add(losses::property, notEvaluated);
    }
    return parts;
}

// `place` is that of the element's content.
void TreeDrawer::collectText(Node node, const Place& place, const TextSpan& around, Texts& texts)
{
    const auto blanksAs = tree_.attribute(node, "xml:space");
    TextSpan span = around;
    if (!blanksAs.empty())
        span.keepsBlanks = blanksAs == "preserve";
    const qsizetype first = texts.content.text().size();
    addRun(place, span, texts);
    const std::size_t run = texts.runs.size() - 1;
    for (const Node child : Children(tree_, node))
        if (tree_.name(child) == textNode && texts.runs[run].font.size >= leastFontSize)
            texts.content.append(inCase(QString::fromUtf8(tree_.attribute(child, textNode)),
                                        place.properties.text.letterCase),
                                 run, span.keepsBlanks || place.properties.text.keepsBlanks);
        else if (tree_.name(child) != textNode)
            collectSpan(child, place, span, texts);
    texts.content.place(tree_, node, first, place.lengths, report_);
    const auto fit = tree_.attribute(node, "textLength");
    if (const auto length = fit.empty() ? std::nullopt : place.lengths.x(fit);
        length && *length > 0)
        texts.fits.push_back({first, texts.content.text().size(), *length,
                              tree_.attribute(node, "lengthAdjust") == "spacingAndGlyphs"});
}

void TreeDrawer::collectSpan(Node node, const Place& around, TextSpan span, Texts& texts)
{
    const auto name = tree_.name(node);
    if (name != "tspan" && name != "a" && name != "textPath") {
        report_.add(losses::text, name == "tref" || name == "altGlyph");
        return;
    }
    refuseTooDeep(around);
    if (!isWanted(node))
        return;
    report_.turnTo(tree_.line(node));
    const Matrix matrix = around.matrix;
    Place place = inside(node, around);
    place.matrix = matrix; // parts of a text have no transforms
    if (!place.properties.displayed)
        return;
    reportEffects(place.properties, false);
    span.raised += place.properties.baselineShift;
    if (name == "textPath" && !turnToPath(node, place, span))
        return;
    collectText(node, place, span, texts);
}

// False: there is no such path, so SVG does not draw the text either.
bool TreeDrawer::turnToPath(Node node, const Place& place, TextSpan& span)
{
    const Node target = tree_.findReference(hrefOf(tree_, node));
    const OutlineKind* kind = target == noNode ? nullptr : findOutlineKind(tree_.name(target));
    if (!kind) {
        report_.add(losses::pathlessText);
        return false;
    }
    Place own;
    own.lengths = place.lengths;
    own = styled(target, own);
    auto paths = placed(outlineOf(*kind, target, own), own.matrix);
    if (tree_.attribute(node, "side") == "right") {
        std::ranges::reverse(paths);
        for (Subpath& path : paths)
            path = reversedPath(path);
    }
    span.path = std::make_shared<const PathWalk>(paths);
    const double whole = span.path->length();
    const auto given = Lengths().parse(tree_.attribute(target, "pathLength"), 0);
    const auto text = tree_.attribute(node, "startOffset");
    const double offset = place.lengths.parse(text, whole).value_or(0);
    const bool counts = given && *given > 0 && !trimmed(text).ends_with('%');
    span.startOffset = counts ? offset * whole / *given : offset;
    return true;
}

void TreeDrawer::addRun(const Place& place, const TextSpan& span, Texts& texts)
{
    const Properties& p = place.properties;
    const NamedFont& font = fontOf(p);
    TextRun run{.font = {.family = font.family,
                         .weight = p.text.weight,
                         .italic = p.text.italic,
                         .smallCapitals = p.text.smallCapitals,
                         .size = p.fontSize,
                         .letterSpacing = p.text.letterSpacing,
                         .wordSpacing = p.text.wordSpacing},
                .anchor = p.text.anchor,
                .rightToLeft = p.text.rightToLeft,
                .path = span.path,
                .startOffset = span.startOffset};
    const auto baseline = p.alignment.empty() ? p.text.baseline : p.alignment;
    run.lowered = -span.raised;
    if (!baseline.empty())
        run.lowered += depthOfBaseline(baseline, lineFonts_.measuresOf(run.font));
    texts.runs.push_back(std::move(run));
    texts.places.push_back(place);
    texts.replaced.push_back(
        font.missing.isEmpty() ? QString() : font.missing + QStringLiteral(" → ") + font.family);
}

const NamedFont& TreeDrawer::fontOf(const Properties& p)
{
    const auto [at, isNew] = fonts_.try_emplace(std::string(p.text.families));
    if (isNew)
        at->second = namedFont(QString::fromUtf8(p.text.families));
    return at->second;
}

} // namespace app::svg

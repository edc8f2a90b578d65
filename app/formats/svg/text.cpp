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

} // namespace

/// A line under, over or through letters, in the style of the element that asks for it.
struct TreeDrawer::TextLineStyle {
    Place place{};
    LineMeasures measures{};
};

struct TreeDrawer::Texts {
    using Lines = std::array<std::shared_ptr<const TextLineStyle>, 3>;
    TextContent content{};
    std::vector<TextRun> runs{};
    std::vector<Place> places{};     ///< of the runs
    std::vector<QString> replaced{}; ///< of the runs: "Arial → DejaVu Sans", or ""
    std::vector<TextFit> fits{};
    std::vector<Lines> lines{}; ///< of the runs: under, over and through their letters
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
        drawLine(letters, texts, TextLineKind::Under);
        drawLine(letters, texts, TextLineKind::Over);
        drawLetters(letters, texts, std::exchange(own, {}));
        drawLine(letters, texts, TextLineKind::Through);
    }
    if (grouped)
        content_.close();
}

void TreeDrawer::drawLine(const LaidLetters& letters, const Texts& texts, TextLineKind kind)
{
    const auto& line = texts.lines[letters.run][std::size_t(kind)];
    if (!line)
        return;
    const LineMeasures& high = line->measures;
    const double middle = kind == TextLineKind::Under  ? high.underline
                          : kind == TextLineKind::Over ? high.ascent
                                                       : high.strikeOut;
    const Place& run = texts.places[letters.run];
    Place place = line->place;
    place.matrix = run.matrix;
    place.clips = run.clips;
    for (const LetterCell& cell : letters.cells) {
        Subpath bar = cell.box(-middle - high.thickness / 2, -middle + high.thickness / 2);
        addShape({placed({{std::move(bar)}}, place.matrix)}, place, {});
    }
}

bool TreeDrawer::hasLines(const TextParts& parts, const Texts& texts)
{
    return std::ranges::any_of(parts.letters, [&](const LaidLetters& letters) {
        return std::ranges::any_of(texts.lines[letters.run],
                                   [](const auto& line) { return line != nullptr; });
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
    Texts texts;
    for (const LaidLetters& letters : textParts(node, place, texts).letters) {
        const LineMeasures high = lineFonts_.measuresOf(texts.runs[letters.run].font);
        for (const LetterCell& cell : letters.cells)
            for (const Subpath& box :
                 placed({{cell.box(-high.ascent, high.descent)}}, place.matrix))
                include(bounds, box);
    }
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
    collectText(node, place, {.vertical = place.properties.text.vertical}, texts);
    texts.content.trimEnd();
    const qsizetype count = texts.content.text().size();
    countLetters(std::size_t(count));
    for (TextFit& fit : texts.fits)
        fit.end = std::min(fit.end, count);
    std::erase_if(texts.fits, [](const TextFit& fit) { return fit.end <= fit.first; });
    const TextParts parts = laidOut(texts.content, texts.runs, texts.fits, lineFonts_);
    for (int i = 0; i < parts.unfitted; ++i)
        report_.add(losses::attribute, "textLength");
    for (const QString& missing : parts.missing)
        report_.add(losses::letter, missing.toStdString());
    report_.add(losses::offPath, parts.leavesPath);
    report_.add(losses::pictureLetter, parts.pictures);
    for (const LaidLetters& letters : parts.letters) {
        const QString& replaced = texts.replaced[letters.run];
        if (!replaced.isEmpty())
            report_.add(losses::replacedFont, replaced.toStdString());
        report_.add(losses::smallCapitals, texts.runs[letters.run].font.smallCapitals);
        const auto notEvaluated = texts.places[letters.run].properties.text.notEvaluated;
        if (!notEvaluated.empty())
            report_.add(losses::property, notEvaluated);
    }
    return parts;
}

void TreeDrawer::countLetters(std::size_t count)
{
    letters_ += count;
    if (letters_ > mostLetters)
        throw Refused{Text::tr("exceeds the limit of %1 letters of texts.").arg(mostLetters)};
}

// `place` is that of the element's content.
void TreeDrawer::collectText(Node node, const Place& place, const TextSpan& around, Texts& texts)
{
    const auto blanksAs = tree_.attribute(node, "xml:space");
    TextSpan span = around;
    if (!blanksAs.empty())
        span.keepsBlanks = blanksAs == "preserve";
    addLines(place, span);
    const qsizetype first = texts.content.text().size();
    addRun(place, span, texts);
    const std::size_t run = texts.runs.size() - 1;
    for (const Node child : Children(tree_, node))
        if (tree_.name(child) == textNode)
            appendText(child, run, span, texts);
        else
            collectSpan(child, place, span, texts);
    if (tree_.name(node) != "textPath") // which has no positions of its own
        texts.content.place(tree_, node, first, place.lengths, report_);
    const auto fit = tree_.attribute(node, "textLength");
    const auto length = fit.empty() ? std::nullopt : place.lengths.x(fit);
    if (!fit.empty() && !(length && *length > 0))
        report_.add(losses::attribute, "textLength");
    else if (length)
        texts.fits.push_back({first, texts.content.text().size(), *length,
                              tree_.attribute(node, "lengthAdjust") == "spacingAndGlyphs"});
}

void TreeDrawer::collectSpan(Node node, const Place& around, TextSpan span, Texts& texts)
{
    const auto name = tree_.name(node);
    if (name != "tspan" && name != "a" && name != "textPath" && name != "tref") {
        report_.add(losses::text, name == "altGlyph");
        return;
    }
    refuseTooDeep(around);
    if (!isWanted(node))
        return;
    report_.turnTo(tree_.line(node));
    Place place = styled(node, around);
    place.matrix = around.matrix; // parts of a text have no transforms, opacities and clip paths
    place.opacity = around.opacity;
    if (!place.properties.displayed)
        return;
    span.raised += place.properties.baselineShift + scriptShift(place.properties, around);
    if (name == "textPath" && !turnToPath(node, place, span))
        return;
    if (name == "tref")
        collectReferred(node, place, span, texts);
    else
        collectText(node, place, span, texts);
}

// How far sub- and superscripts are above the baseline, by the font around them.
double TreeDrawer::scriptShift(const Properties& properties, const Place& around)
{
    using Script = Properties::Script;
    if (properties.script == Script::None)
        return 0;
    const LineMeasures high = lineFonts_.measuresOf(lineFontOf(around.properties));
    return properties.script == Script::Above ? high.superscript : high.subscript;
}

// The lines that an element asks for; those that elements around the text ask for have its style.
void TreeDrawer::addLines(const Place& place, TextSpan& span)
{
    const TextStyle& style = place.properties.text;
    for (const auto& [bit, kind] : {std::pair{TextStyle::underline, TextLineKind::Under},
                                    {TextStyle::overline, TextLineKind::Over},
                                    {TextStyle::lineThrough, TextLineKind::Through}}) {
        auto& line = span.lines[std::size_t(kind)];
        if ((style.lines & bit) || ((style.linesAround & bit) && !line))
            line = std::make_shared<const TextLineStyle>(
                TextLineStyle{place, lineFonts_.measuresOf(lineFontOf(place.properties))});
    }
}

// <tref>: the characters of another text, without its styles.
void TreeDrawer::collectReferred(Node node, const Place& place, TextSpan span, Texts& texts)
{
    const Node target = tree_.findReference(hrefOf(tree_, node));
    if (target == noNode)
        return;
    const qsizetype first = texts.content.text().size();
    addLines(place, span);
    addRun(place, span, texts);
    for (Node each = target + 1; each < tree_.end(target); ++each) {
        if (tree_.name(each) != textNode)
            continue;
        countLetters(tree_.attribute(each, textNode).size());
        appendText(each, texts.runs.size() - 1, span, texts);
    }
    texts.content.place(tree_, node, first, place.lengths, report_);
}

// Adds a piece of text in the style of a run.
void TreeDrawer::appendText(Node node, std::size_t run, const TextSpan& span, Texts& texts)
{
    const TextStyle& style = texts.places[run].properties.text;
    if (texts.runs[run].font.size >= leastFontSize)
        texts.content.append(
            inCase(QString::fromUtf8(tree_.attribute(node, textNode)), style.letterCase), run,
            span.keepsBlanks || style.keepsBlanks);
}

// False: there is no such path, so SVG does not draw the text either.
bool TreeDrawer::turnToPath(Node node, const Place& place, TextSpan& span)
{
    const Node target = tree_.findReference(hrefOf(tree_, node));
    const OutlineKind* kind = target == noNode ? nullptr : findOutlineKind(tree_.name(target));
    const auto data = tree_.attribute(node, "path"); // goes before a reference
    if ((!kind && data.empty()) || span.path) {      // a path in a path is none either
        report_.add(losses::pathlessText);
        return false;
    }
    Place own;
    own.lengths = place.lengths;
    if (data.empty())
        own = styled(target, own);
    auto paths =
        placed(data.empty() ? outlineOf(*kind, target, own) : parsePathData(data), own.matrix);
    if (tree_.attribute(node, "side") == "right") {
        std::ranges::reverse(paths);
        for (Subpath& path : paths)
            path = reversedPath(path);
    }
    span.path = std::make_shared<const PathWalk>(paths);
    const double whole = span.path->length();
    const auto counted = data.empty() ? tree_.attribute(target, "pathLength") : std::string_view();
    const auto given = Lengths().parse(counted, 0);
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
    TextRun run{.font = lineFontOf(p),
                .anchor = p.text.anchor,
                .rightToLeft = p.text.rightToLeft,
                .vertical = span.vertical && !span.path,
                .path = span.path,
                .startOffset = span.startOffset};
    if (span.vertical && span.path)
        report_.add(losses::property, "writing-mode");
    auto baseline = p.alignment.empty() ? p.text.baseline : p.alignment;
    if (run.vertical && baseline.empty())
        baseline = "central"; // on which both upright and turned letters are centred
    run.lowered = -span.raised;
    if (!baseline.empty())
        run.lowered += depthOfBaseline(baseline, lineFonts_.measuresOf(run.font));
    texts.runs.push_back(std::move(run));
    texts.places.push_back(place);
    texts.lines.push_back(span.lines);
    texts.replaced.push_back(
        font.missing.isEmpty() ? QString() : font.missing + QStringLiteral(" → ") + font.family);
}

LineFont TreeDrawer::lineFontOf(const Properties& p)
{
    return {.family = fontOf(p).family,
            .weight = p.text.weight,
            .italic = p.text.italic,
            .smallCapitals = p.text.smallCapitals,
            .kerning = p.text.kerning,
            .size = p.fontSize,
            .letterSpacing = p.text.letterSpacing,
            .wordSpacing = p.text.wordSpacing};
}

const NamedFont& TreeDrawer::fontOf(const Properties& p)
{
    const auto [at, isNew] = fonts_.try_emplace(std::string(p.text.families));
    if (isNew)
        at->second = namedFont(QString::fromUtf8(p.text.families));
    return at->second;
}

} // namespace app::svg

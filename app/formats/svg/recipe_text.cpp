// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/recipe_text.h"

#include "app/base/number.h"
#include "app/base/random.h"
#include "app/document/path.h"
#include "app/document/recipe_outline.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"

#include <cmath>
#include <vector>

namespace app::svg {
namespace {

constexpr std::string_view rectangle = "rectangle", ellipse = "ellipse", star = "star",
                           words = "text", outlines = "outlines";
constexpr char quote = '\'';
constexpr std::size_t mostNumbers = 6;
constexpr double mostPoints = 1000;

std::string withNumbers(std::string_view kind, const std::vector<double>& numbers)
{
    std::string all(kind);
    for (const double number : numbers)
        appendNumber(all += ' ', number);
    return all;
}

std::vector<double> numbersIn(std::string_view text)
{
    Scanner scanner(text);
    std::vector<double> numbers;
    while (numbers.size() < mostNumbers) {
        scanner.skipBlanks();
        const auto next = scanner.number();
        if (!next)
            break;
        numbers.push_back(*next);
    }
    return numbers;
}

/// 16 hexadecimal digits, which change with any point; -0 counts as 0, as in files.
QString checksum(std::span<const Subpath> subpaths)
{
    std::uint64_t sum = mixed(std::uint64_t(subpaths.size()));
    for (const Subpath& path : subpaths) {
        sum = mixed(sum ^ (2 * path.segments.size() + (path.closed ? 1 : 0)));
        forEachPoint(path, [&](const Point& p) {
            sum = mixed(sum ^ mixed(p.x + 0.0));
            sum = mixed(sum ^ mixed(p.y + 0.0));
        });
    }
    return QStringLiteral("%1").arg(sum, 16, 16, QChar(u'0'));
}

/// The text without line breaks, which an attribute cannot hold, and without the sign `quote`.
QString quoted(QString text)
{
    return text.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n"));
}
QString quotedFont(const QString& font)
{
    return quoted(font).replace(u'\'', QStringLiteral("\\q"));
}
QString unquotedText(const QString& quoted)
{
    QString text;
    for (qsizetype i = 0; i < quoted.size(); ++i) {
        const bool escapes = quoted[i] == u'\\' && i + 1 < quoted.size();
        if (escapes)
            ++i;
        const bool breaks = escapes && quoted[i] == u'n', quotes = escapes && quoted[i] == u'q';
        text += breaks ? QChar(u'\n') : quotes ? QChar(quote) : quoted[i];
    }
    return text;
}

struct InWords {
    const Path& path;

    std::string operator()(const RectangleRecipe& r) const
    {
        const auto& [corner, size, radius, turn] = r;
        std::vector<double> numbers{corner.x, corner.y, size.x, size.y};
        if (radius != 0 || turn != 0)
            numbers.push_back(radius);
        if (turn != 0)
            numbers.push_back(turn);
        return withNumbers(rectangle, numbers);
    }
    std::string operator()(const EllipseRecipe& e) const
    {
        const auto& [centre, radii, turn] = e;
        std::vector<double> numbers{centre.x, centre.y, radii.x, radii.y};
        if (turn != 0)
            numbers.push_back(turn);
        return withNumbers(ellipse, numbers);
    }
    std::string operator()(const StarRecipe& s) const
    {
        return withNumbers(star,
                           {s.centre.x, s.centre.y, s.outer, s.inner, s.turn, double(s.points)});
    }
    std::string operator()(const TextRecipe& t) const
    {
        const bool strokes = findStrokeFont(t.font);
        std::vector<double> numbers{t.at.x, t.at.y, t.size};
        const bool hasFace = t.face != FontFace{};
        if (t.turn != 0 || t.mirrored || hasFace)
            numbers.push_back(t.turn);
        if (t.mirrored || hasFace)
            numbers.push_back(t.mirrored);
        if (hasFace)
            numbers.push_back(t.face.bold + 2 * t.face.italic);
        QString rest = QStringLiteral(" '") + quotedFont(t.font) + QStringLiteral("' ");
        if (!strokes)
            rest += checksum(path.subpaths()) + u' ';
        return withNumbers(strokes ? words : outlines, numbers) + escaped(rest + quoted(t.text));
    }
    std::string operator()(std::monostate) const { return {}; }
};

/// A text, and the checksum of its path if it has one.
struct ReadText {
    TextRecipe recipe;
    QString checksum{};
};

std::optional<ReadText> readText(std::string_view text, bool hasChecksum)
{
    const auto open = text.find(quote);
    const auto close = open == text.npos ? open : text.find(quote, open + 1);
    if (close == text.npos || close + 2 > text.size() || text.size() > 8 * longestText)
        return std::nullopt;
    const auto v = numbersIn(text.substr(0, open));
    if (v.size() < 3 || v.size() > (hasChecksum ? 6 : 5))
        return std::nullopt;
    const int face = v.size() > 5 && v[5] >= 0 && v[5] <= 3 ? int(v[5]) : 0;
    QString rest = QString::fromUtf8(text.substr(close + 2)), sum;
    if (hasChecksum) {
        sum = rest.section(u' ', 0, 0);
        rest.remove(0, sum.size() + 1);
    }
    const auto font = QString::fromUtf8(text.substr(open + 1, close - open - 1));
    return ReadText{{unquotedText(rest),
                     unquotedText(font),
                     v[2],
                     {v[0], v[1]},
                     v.size() > 3 ? v[3] : 0,
                     v.size() > 4 && v[4] != 0,
                     {(face & 1) != 0, (face & 2) != 0}},
                    sum};
}

Recipe readShape(std::string_view text)
{
    for (const std::string_view kind : {rectangle, ellipse, star}) {
        if (!text.starts_with(kind))
            continue;
        const auto v = numbersIn(text.substr(kind.size()));
        const auto more = [&](std::size_t i) { return i < v.size() ? v[i] : 0; };
        if (kind == rectangle && v.size() >= 4)
            return RectangleRecipe{{v[0], v[1]}, {v[2], v[3]}, more(4), more(5)};
        if (kind == ellipse && (v.size() == 4 || v.size() == 5))
            return EllipseRecipe{{v[0], v[1]}, {v[2], v[3]}, more(4)};
        const bool isStar = kind == star && v.size() == 6;
        if (isStar && v[5] >= 3 && v[5] <= mostPoints && v[5] == std::floor(v[5]))
            return StarRecipe{{v[0], v[1]}, v[2], v[3], v[4], int(v[5])};
    }
    return {};
}

} // namespace

std::string textOf(const Recipe& recipe, const Path& path)
{
    return std::visit(InWords{path}, recipe);
}

Recipe readRecipe(std::string_view text, std::span<const Subpath> subpaths)
try {
    if (text.starts_with(words)) {
        const auto read = readText(text.substr(words.size()), false);
        return read && findStrokeFont(read->recipe.font) && makes(read->recipe, subpaths)
                   ? Recipe(read->recipe)
                   : Recipe{};
    }
    if (text.starts_with(outlines)) {
        const auto read = readText(text.substr(outlines.size()), true);
        return read && read->recipe.text.size() <= longestText
                       && read->checksum == checksum(subpaths)
                   ? Recipe(read->recipe)
                   : Recipe{};
    }
    Recipe shape = readShape(text);
    return makes(shape, subpaths) ? shape : Recipe{};
} catch (const Refused&) { // a number is not finite
    return {};
}

} // namespace app::svg

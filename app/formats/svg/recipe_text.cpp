// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/recipe_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/scanner.h"
#include "app/lettering/lettering.h"

#include <cmath>
#include <initializer_list>
#include <vector>

namespace app::svg {
namespace {

constexpr std::string_view rectangle = "rectangle", ellipse = "ellipse", star = "star",
                           words = "text";
constexpr char quote = '\'';
constexpr std::size_t mostNumbers = 6;
constexpr double mostPoints = 1000;

std::string text(std::string_view kind, std::initializer_list<double> numbers)
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

struct Text {
    std::string operator()(const RectangleRecipe& r) const
    {
        const auto& [corner, size, radius] = r;
        return radius == 0 ? text(rectangle, {corner.x, corner.y, size.x, size.y})
                           : text(rectangle, {corner.x, corner.y, size.x, size.y, radius});
    }
    std::string operator()(const EllipseRecipe& e) const
    {
        return text(ellipse, {e.centre.x, e.centre.y, e.radii.x, e.radii.y});
    }
    std::string operator()(const StarRecipe& s) const
    {
        return text(star, {s.centre.x, s.centre.y, s.outer, s.inner, s.turn, double(s.points)});
    }
    std::string operator()(const TextRecipe& t) const
    {
        if (t.font.contains(quote))
            return {};
        QString quoted = t.text;
        quoted.replace(u'\\', QStringLiteral("\\\\")).replace(u'\n', QStringLiteral("\\n"));
        return text(words, {t.at.x, t.at.y, t.size})
               + escaped(QStringLiteral(" '%1' ").arg(t.font) + quoted);
    }
    std::string operator()(std::monostate) const { return {}; }
};

/// The text with the line breaks that the attribute could not hold.
QString unquoted(const QString& quoted)
{
    QString text;
    for (qsizetype i = 0; i < quoted.size(); ++i) {
        const bool escapes = quoted[i] == u'\\' && i + 1 < quoted.size();
        if (escapes)
            ++i;
        text += escapes && quoted[i] == u'n' ? QChar(u'\n') : quoted[i];
    }
    return text;
}

Recipe readWords(std::string_view text)
{
    const auto open = text.find(quote);
    const auto close = open == text.npos ? open : text.find(quote, open + 1);
    if (close == text.npos || close + 2 > text.size() || text.size() > 8 * longestText)
        return {};
    const auto v = numbersIn(text.substr(0, open));
    const auto font = text.substr(open + 1, close - open - 1);
    if (v.size() != 3)
        return {};
    return TextRecipe{unquoted(QString::fromUtf8(text.substr(close + 2))),
                      QString::fromUtf8(font),
                      v[2],
                      {v[0], v[1]}};
}

} // namespace

std::string textOf(const Recipe& recipe) { return std::visit(Text{}, recipe); }

Recipe readRecipe(std::string_view text)
{
    if (text.starts_with(words))
        return readWords(text.substr(words.size()));
    for (const std::string_view kind : {rectangle, ellipse, star}) {
        if (!text.starts_with(kind))
            continue;
        const auto v = numbersIn(text.substr(kind.size()));
        if (kind == rectangle && (v.size() == 4 || v.size() == 5))
            return RectangleRecipe{{v[0], v[1]}, {v[2], v[3]}, v.size() == 5 ? v[4] : 0};
        if (kind == ellipse && v.size() == 4)
            return EllipseRecipe{{v[0], v[1]}, {v[2], v[3]}};
        const bool isStar = kind == star && v.size() == 6;
        if (isStar && v[5] >= 3 && v[5] <= mostPoints && v[5] == std::floor(v[5]))
            return StarRecipe{{v[0], v[1]}, v[2], v[3], v[4], int(v[5])};
    }
    return {};
}

} // namespace app::svg

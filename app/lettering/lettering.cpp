// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/lettering.h"

#include "app/document/recipe_outline.h"
#include "app/lettering/accents.h"
#include "app/lettering/stroke_fonts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <set>

namespace app {
namespace {

constexpr double accentGap = 4; // from the letter to the middle of its accent
constexpr double boxWidth = 14, boxMargin = 3;
constexpr double largest = 1e300;

QString textOf(char32_t character) { return QString::fromUcs4(&character, 1); }

/// Writes letters one after the other.
class Writer {
public:
    explicit Writer(const TextRecipe& text, const StrokeFont& font)
        : text_(text), font_(font), unit_(text.size / hersheyCapital)
    {
    }

    void write()
    {
        for (const char32_t c : text_.text.normalized(QString::NormalizationForm_C).toUcs4())
            if (c == U'\n')
                breakLine();
            else if (!letter(c) && !accented(c))
                box(c);
    }
    Lettering done;

private:
    void breakLine()
    {
        x_ = 0;
        y_ += linePitch * hersheyCapital;
    }
    bool letter(char32_t c)
    {
        const auto [glyph, scale] = glyphOf(c, font_);
        if (!glyph)
            return false;
        x_ -= glyph->left * scale;
        for (const auto& stroke : glyph->strokes)
            add(stroke, scale, {0, 0});
        x_ += glyph->right * scale;
        return true;
    }
    /// A letter that Unicode composes of a letter of the font and accents.
    bool accented(char32_t c)
    {
        const auto parts = textOf(c).normalized(QString::NormalizationForm_D).toUcs4();
        const auto [glyph, scale] = glyphOf(parts.front(), font_);
        const auto known = [](char32_t mark) { return findAccent(mark) != nullptr; };
        if (parts.size() < 2 || !glyph || !std::all_of(parts.begin() + 1, parts.end(), known))
            return false;
        const double before = x_ - glyph->left * scale;
        double top = 0, bottom = 0;
        for (const auto& stroke : glyph->strokes)
            for (const Point& p : stroke) {
                top = std::min(top, p.y * scale);
                bottom = std::max(bottom, p.y * scale);
            }
        letter(parts.front());
        const double after = std::exchange(x_, before);
        for (const char32_t mark : parts.sliced(1)) {
            const Accent& accent = *findAccent(mark);
            const double at = accent.below ? bottom += accentGap : top -= accentGap;
            for (const auto& stroke : accent.strokes)
                add(stroke, 1, {0, at});
        }
        x_ = after;
        return true;
    }
    void box(char32_t c)
    {
        const double right = boxWidth - boxMargin;
        add({{boxMargin, 0},
             {boxMargin, -hersheyCapital},
             {right, -hersheyCapital},
             {right, 0},
             {boxMargin, 0}},
            1, {0, 0});
        x_ += boxWidth;
        if (known_.insert(c).second)
            done.missing << textOf(c);
    }
    void add(const std::vector<Point>& stroke, double scale, const Point& shift)
    {
        const auto place = [&](const Point& p) {
            return text_.at + (Point(x_, y_) + p * scale + shift) * unit_;
        };
        Subpath path{place(stroke.front()), {}};
        for (const Point& p : std::span(stroke).subspan(1))
            path.segments.push_back({place(p)});
        done.paths.push_back(std::move(path));
    }

    const TextRecipe& text_;
    const StrokeFont& font_;
    std::set<char32_t> known_;    // missing characters
    double unit_, x_ = 0, y_ = 0; // x and y in the font's units
};

} // namespace

Lettering lettered(const TextRecipe& text)
{
    const StrokeFont* const font = findStrokeFont(text.font);
    const auto small = [](double number) { return std::abs(number) < largest; }; // not for NaN
    const bool drawable = text.size > 0 && small(text.size * double(longestText))
                          && small(text.at.x) && small(text.at.y);
    if (!font || !drawable || text.text.size() > longestText)
        return {};
    Writer writer(text, *font);
    writer.write();
    return std::move(writer.done);
}

QString missingText(const Lettering& lettering)
{
    if (lettering.missing.isEmpty())
        return {};
    constexpr qsizetype named = 10;
    QStringList first = lettering.missing.first(std::min(named, lettering.missing.size()));
    if (lettering.missing.size() > named)
        first << QStringLiteral("…");
    return QCoreApplication::translate("Lettering",
                                       "The font has no %1: a box stands in its place.", nullptr)
        .arg(first.join(QStringLiteral(", ")));
}

bool makes(const TextRecipe& text, std::span<const Subpath> subpaths)
{
    const Lettering letters = lettered(text);
    return !letters.paths.empty() && alike(letters.paths, subpaths);
}

} // namespace app

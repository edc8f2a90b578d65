// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/stroke_letters.h"

#include "app/lettering/composed_letters.h"

#include <algorithm>
#include <array>
#include <set>

namespace app {
namespace {

constexpr double accentGap = 4; // from the letter to the middle of its accent
constexpr double boxWidth = 14, boxMargin = 3;

QString textOf(char32_t character) { return QString::fromUcs4(&character, 1); }

/// Writes letters one after the other.
class StrokeWriter {
public:
    explicit StrokeWriter(const StrokeFont& font) : font_(font) {}

    void write(const QString& text)
    {
        for (const char32_t c : text.normalized(QString::NormalizationForm_C).toUcs4())
            if (c == U'\n')
                breakLine();
            else if (!letter(c) && !accented(c) && !composed(c))
                box(c);
    }
    Letters done{hersheyCapital};

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
    /// A sign that is made of letters of the font.
    bool composed(char32_t c)
    {
        const ComposedLetter* const sign = findComposed(c);
        const auto isThere = [&](const LetterPart& part) {
            return glyphOf(part.letter, font_).glyph != nullptr;
        };
        if (!sign || !std::ranges::all_of(sign->parts, isThere))
            return false;
        const auto [first, firstScale] = glyphOf(sign->parts.front().letter, font_);
        const double middle = x_ - first->left * firstScale * sign->parts.front().scale;
        for (const LetterPart& part : sign->parts) {
            const auto [glyph, own] = glyphOf(part.letter, font_);
            const double scale = own * part.scale;
            x_ -= part.pull + glyph->left * scale;
            for (const auto& stroke : glyph->strokes)
                add(stroke, scale, {0, -part.rise});
            x_ += glyph->right * scale;
        }
        const double after = std::exchange(x_, middle);
        for (const auto& stroke : sign->strokes)
            add(stroke, 1, {0, 0});
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
        const auto place = [&](const Point& p) { return Point(x_, y_) + p * scale + shift; };
        Subpath path{place(stroke.front()), {}};
        for (const Point& p : std::span(stroke).subspan(1))
            path.segments.push_back({place(p)});
        done.paths.push_back(std::move(path));
    }

    const StrokeFont& font_;
    std::set<char32_t> known_; // missing characters
    double x_ = 0, y_ = 0;     // in the font's units
};

} // namespace

Letters strokeLetters(const QString& text, const StrokeFont& font)
{
    StrokeWriter writer(font);
    writer.write(text);
    return std::move(writer.done);
}

const Accent* findAccent(char32_t mark)
{
    // THE CATALOGUE: the Hershey fonts have no letters with accents.
    static const std::array accents{
        Accent{0x300, {{{-3, -2}, {1, 2}}}},                                     // grave
        Accent{0x301, {{{3, -2}, {-1, 2}}}},                                     // acute
        Accent{0x302, {{{-3, 2}, {0, -1}, {3, 2}}}},                             // circumflex
        Accent{0x303, {{{-4, 1}, {-3, -1}, {-1, -1}, {1, 1}, {3, 1}, {4, -1}}}}, // tilde
        Accent{0x304, {{{-3, 0}, {3, 0}}}},                                      // macron
        Accent{0x306, {{{-3, -1}, {-2, 1}, {2, 1}, {3, -1}}}},                   // breve
        Accent{0x308, {{{-3, -1}, {-3, 1}}, {{3, -1}, {3, 1}}}},                 // diaeresis
        Accent{0x30a, {{{0, -2}, {2, 0}, {0, 2}, {-2, 0}, {0, -2}}}},            // ring
        Accent{0x30b, {{{0, -2}, {-3, 2}}, {{4, -2}, {1, 2}}}},                  // two acutes
        Accent{0x30c, {{{-3, -1}, {0, 2}, {3, -1}}}},                            // caron
        Accent{0x327, {{{0, -2}, {2, 0}, {1, 2}, {-2, 2}}}, true},               // cedilla
        Accent{0x328, {{{2, -2}, {0, 0}, {1, 2}, {3, 2}}}, true},                // ogonek
        Accent{0x342, {{{-4, 1}, {-3, -1}, {-1, -1}, {1, 1}, {3, 1}, {4, -1}}}}, // perispomeni
    };
    const auto found = std::ranges::find(accents, mark, &Accent::mark);
    return found == accents.end() ? nullptr : &*found;
}

} // namespace app

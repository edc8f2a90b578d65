// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/stroke_fonts.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

namespace app {
namespace {

constexpr std::string_view thinGreek = "greeks", wideGreek = "greekc";

/// A character that is another place in the files: `code` is the ASCII character of the place.
struct Elsewhere {
    char32_t character;
    std::string_view file; ///< empty: the font's own
    char code;
    double scale = 1;
};

constexpr std::string_view all = "cyrillic";
// Letters that the alphabetic order of the Cyrillic file does not have, and signs of other shapes.
constexpr std::array elsewhere{
    Elsewhere{U'Ъ', all, ']'},
    Elsewhere{U'Ы', all, '$'},
    Elsewhere{U'Ь', all, '_'},
    Elsewhere{U'Э', all, 'C'},
    Elsewhere{U'Ю', all, 'U'},
    Elsewhere{U'Я', all, '^'},
    Elsewhere{U'ъ', all, '|'},
    Elsewhere{U'ы', all, '&'},
    Elsewhere{U'ь', all, '~'},
    Elsewhere{U'э', all, 'C', 2.0 / 3}, // the file has the capital twice
    Elsewhere{U'ю', all, 'u'},
    Elsewhere{U'я', all, '}'},
    Elsewhere{U'ς', thinGreek, 'r'},
    Elsewhere{U'°', thinGreek, 127},
    Elsewhere{U'×', "greek", 'j'},
    Elsewhere{U'÷', "greek", 'v'},
    Elsewhere{U'·', "greek", 'J'},
    Elsewhere{0xa0, {}, ' '},
    Elsewhere{U'–', {}, '-'},
    Elsewhere{U'—', {}, '-'},
    Elsewhere{U'−', {}, '-'},
    Elsewhere{U'‘', {}, '`'},
    Elsewhere{U'’', {}, '\''},
    Elsewhere{U'“', {}, '"'},
    Elsewhere{U'”', {}, '"'},
    Elsewhere{U'\t', {}, ' '},
};

const HersheyGlyph* at(std::string_view file, int code)
{
    const auto& glyphs = hersheyGlyphs(file);
    const std::size_t index = std::size_t(code - ' ');
    return index < glyphs.size() ? &glyphs[index] : nullptr;
}

/// Both Greek files have the letters in alphabetic order, without the final sigma.
const HersheyGlyph* greek(char32_t c, std::string_view file)
{
    const auto place = [&](char32_t first, char32_t gap, char start) {
        return at(file, start + int(c - first) - (c > gap ? 1 : 0));
    };
    if (c == U'µ') // the micro sign
        return greek(U'μ', file);
    if (c >= U'Α' && c <= U'Ω' && c != 0x3a2)
        return place(U'Α', 0x3a2, 'A');
    return c >= U'α' && c <= U'ω' && c != U'ς' ? place(U'α', U'ς', 'a') : nullptr;
}

/// The file cyrilc_1 has А to Щ in alphabetic order.
const HersheyGlyph* cyrillic(char32_t c)
{
    constexpr std::string_view ordered = "cyrilc_1";
    if (c >= U'А' && c <= U'Щ')
        return at(ordered, 'A' + int(c - U'А'));
    return c >= U'а' && c <= U'щ' ? at(ordered, 'a' + int(c - U'а')) : nullptr;
}

} // namespace

std::span<const StrokeFont> strokeFonts()
{
    // THE CATALOGUE, with the names that Inkscape gives these fonts. To add one, add its row.
    static const std::array fonts{
        StrokeFont{QStringLiteral("Hershey Sans 1-stroke"), "futural", thinGreek},
        StrokeFont{QStringLiteral("Hershey Sans medium"), "futuram", wideGreek},
        StrokeFont{QStringLiteral("Hershey Serif medium"), "timesr", wideGreek},
        StrokeFont{QStringLiteral("Hershey Serif medium italic"), "timesi", wideGreek},
        StrokeFont{QStringLiteral("Hershey Serif bold"), "timesrb", wideGreek},
        StrokeFont{QStringLiteral("Hershey Serif bold italic"), "timesib", wideGreek},
        StrokeFont{QStringLiteral("Hershey Script 1-stroke"), "scripts", thinGreek},
        StrokeFont{QStringLiteral("Hershey Script medium"), "scriptc", wideGreek},
        StrokeFont{QStringLiteral("Hershey Gothic English"), "gothiceng", wideGreek},
    };
    return fonts;
}

const StrokeFont* findStrokeFont(const QString& name)
{
    const auto found = std::ranges::find(strokeFonts(), name, &StrokeFont::name);
    return found == strokeFonts().end() ? nullptr : &*found;
}

const std::vector<HersheyGlyph>& hersheyGlyphs(std::string_view file)
{
    static std::mutex access; // files are read on other threads
    static std::map<std::string_view, std::vector<HersheyGlyph>> known;
    const std::scoped_lock lock(access);
    if (const auto found = known.find(file); found != known.end())
        return found->second;
    QFile font(QStringLiteral(":/hershey/%1.jhf")
                   .arg(QLatin1StringView(file.data(), qsizetype(file.size()))));
    auto glyphs = font.open(QIODevice::ReadOnly) ? readHershey(font.readAll()).value : std::nullopt;
    return known.emplace(file, std::move(glyphs).value_or(std::vector<HersheyGlyph>()))
        .first->second;
}

FoundGlyph glyphOf(char32_t character, const StrokeFont& font)
{
    if (const auto other = std::ranges::find(elsewhere, character, &Elsewhere::character);
        other != elsewhere.end())
        return {at(other->file.empty() ? font.file : other->file, other->code), other->scale};
    if (character >= U' ' && character <= U'~')
        return {at(font.file, int(character))};
    const HersheyGlyph* const letter = greek(character, font.greekFile);
    return {letter ? letter : cyrillic(character)};
}

} // namespace app

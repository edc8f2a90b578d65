// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/text_layout.h"

#include "app/formats/svg/scanner.h"
#include "app/lettering/lettering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace app::svg {
namespace {

bool isGiven(double number) { return !std::isnan(number); }
double orZero(double number) { return isGiven(number) ? number : 0; }

Matrix turnedTo(const Point& at, const Point& along, const Point& from)
{
    return translation(at) * Matrix{along.x, along.y, -along.y, along.x, 0, 0} * translation(-from);
}

// Whether letters of this script are joined to each other, so that no gaps are between them.
bool isJoined(QChar letter)
{
    const auto script = letter.script();
    return script == QChar::Script_Arabic || script == QChar::Script_Syriac
           || script == QChar::Script_Mongolian || script == QChar::Script_Nko
           || script == QChar::Script_Devanagari || script == QChar::Script_Bengali;
}

// How much of the square of an East Asian letter is above the baseline, as its fonts have it (the
// baseline "ideo" of OpenType). A side of the square is as long as the font's size.
constexpr double ideographicAscent = 0.88;

// Whether a letter stands upright in a vertical line, as those of East Asian scripts do (UTR 50,
// roughly); the others are turned to the right.
bool isUpright(QChar letter)
{
    const auto script = letter.script();
    const auto within = [&](char16_t first, char16_t last) {
        return letter.unicode() >= first && letter.unicode() <= last;
    };
    return script == QChar::Script_Han || script == QChar::Script_Hiragana
           || script == QChar::Script_Katakana || script == QChar::Script_Hangul
           || script == QChar::Script_Bopomofo || script == QChar::Script_Yi
           || within(0x3000, 0x303f) || within(0xff01, 0xff60) || letter.isSurrogate();
}

/// Characters that are laid out together: from one absolute position to the next.
struct Chunk {
    qsizetype first, end;
};

class TextSetter {
public:
    TextSetter(const TextContent& content, const std::vector<TextRun>& runs,
               const std::vector<TextFit>& fits, LineFonts& fonts)
        : content_(content), runs_(runs), fits_(fits), fonts_(fonts), fitted_(fits.size())
    {
    }

    TextParts set()
    {
        for (qsizetype first = 0; first < content_.text().size();) {
            const Chunk chunk{first, endOfChunk(first)};
            setChunk(chunk);
            first = chunk.end;
        }
        parts_.unfitted = int(std::ranges::count(fitted_, false));
        return std::move(parts_);
    }

private:
    const TextRun& runAt(qsizetype index) const { return runs_[content_.runOf(index)]; }

    qsizetype endOfChunk(qsizetype first) const
    {
        qsizetype end = first + 1;
        const auto path = runAt(first).path;
        while (end < content_.text().size() && end - first < longestText && runAt(end).path == path
               && (content_.text()[end].isLowSurrogate()
                   || (!isGiven(content_.placeOf(end).x)
                       && (path || !isGiven(content_.placeOf(end).y)))))
            ++end;
        return end;
    }

    /// With more spacing after each character.
    TextLine lineOf(const Chunk& chunk, const std::vector<double>& spacing) const
    {
        std::vector<TextLine::Span> spans;
        for (qsizetype i = chunk.first; i < chunk.end; ++i) {
            LineFont font = runAt(i).font;
            if (isJoined(content_.text()[i]))
                font.letterSpacing = 0;
            font.letterSpacing += spacing[std::size_t(i - chunk.first)];
            if (spans.empty() || spans.back().font != font)
                spans.push_back({0, std::move(font)});
            ++spans.back().length;
        }
        return {content_.text().mid(chunk.first, chunk.end - chunk.first), spans,
                runAt(chunk.first).rightToLeft, fonts_};
    }

    void setChunk(const Chunk& chunk)
    {
        std::vector<double> spacing(std::size_t(chunk.end - chunk.first), 0);
        TextLine line = lineOf(chunk, spacing);
        double stretch = 1;
        for (std::size_t i = 0; i < fits_.size(); ++i)
            if (fitsInto(chunk, fits_[i]) && fit(chunk, fits_[i], line, spacing, stretch))
                fitted_[i] = true;
        const LetterPlace& place = content_.placeOf(chunk.first);
        pen_ = {isGiven(place.x) && !runAt(chunk.first).path ? place.x : pen_.x,
                isGiven(place.y) ? place.y : pen_.y};
        pen_ += Point{orZero(place.dx), orZero(place.dy)};
        if (runAt(chunk.first).path)
            setOnPath(chunk, line, stretch);
        else if (runAt(chunk.first).vertical)
            setDown(chunk, line, stretch);
        else
            setStraight(chunk, line, stretch);
    }

    static bool fitsInto(const Chunk& chunk, const TextFit& fit)
    {
        return fit.first >= chunk.first && fit.end <= chunk.end;
    }

    /// Makes a chunk, or a part of it, as long as it is to be. Parts come before what they are in.
    bool fit(const Chunk& chunk, const TextFit& fit, TextLine& line, std::vector<double>& spacing,
             double& stretch) const
    {
        const qsizetype first = fit.first - chunk.first, count = fit.end - fit.first;
        const bool whole = count == chunk.end - chunk.first;
        if (!whole && (fit.stretches || line.isMixed()))
            return false;
        const auto [left, right] = line.reach(first, count);
        const double width = whole ? line.width() : right - left;
        if (fit.stretches && width > 0)
            stretch = fit.length / width;
        if (fit.stretches || count < 2)
            return true;
        const qsizetype letters = lettersIn(line, first, first + count);
        const double more = (fit.length - width) / double(letters - 1);
        // What follows a part begins at its end, so that its last letter has no gap after it.
        const qsizetype end = whole ? first + count : lastLetter(line, first, first + count);
        for (qsizetype i = first; i < end; ++i)
            spacing[std::size_t(i)] += more;
        line = lineOf(chunk, spacing);
        return true;
    }

    static qsizetype lastLetter(const TextLine& line, qsizetype i, qsizetype end)
    {
        qsizetype last = i;
        for (; i < end; i = std::max(line.nextLetter(i), i + 1))
            last = i;
        return last;
    }

    static qsizetype lettersIn(const TextLine& line, qsizetype i, qsizetype end)
    {
        qsizetype count = 0;
        for (; i < end; ++count)
            i = std::max(line.nextLetter(i), i + 1);
        return std::max<qsizetype>(count, 2);
    }

    /// Characters that stay together, as far as they have the same style and no place of their own.
    struct Piece {
        qsizetype first, end;       ///< in the chunk
        Point shift;                ///< by dx and dy
        double turn;                ///< degrees
        double left = 0, right = 0; ///< on the line
    };

    std::vector<Piece> piecesOf(const Chunk& chunk, const TextLine& line, double stretch) const
    {
        std::vector<Piece> pieces;
        Point shift{};
        const bool single = static_cast<bool>(runAt(chunk.first).path);
        const qsizetype count = chunk.end - chunk.first;
        for (qsizetype i = 0; i < count;) {
            const qsizetype next = std::clamp(line.nextLetter(i), i + 1, count);
            const LetterPlace& place = content_.placeOf(chunk.first + i);
            if (i > 0)
                shift += Point{orZero(place.dx), orZero(place.dy)};
            const double turn = orZero(place.rotate);
            const bool upright = runAt(chunk.first).vertical
                                 && (isUpright(content_.text()[chunk.first + i])
                                     || (!pieces.empty() && isUprightAt(chunk, pieces.back())));
            const bool apart = pieces.empty() || single || upright || turn != 0
                               || pieces.back().turn != 0 || shift != pieces.back().shift
                               || content_.runOf(chunk.first + i)
                                      != content_.runOf(chunk.first + pieces.back().first);
            if (apart)
                pieces.push_back({i, next, shift, turn});
            pieces.back().end = next;
            i = next;
        }
        for (Piece& piece : pieces)
            measure(piece, line, stretch);
        return pieces;
    }

    bool isUprightAt(const Chunk& chunk, const Piece& piece) const
    {
        return isUpright(content_.text()[chunk.first + piece.first]);
    }

    // Where a piece lies on its line. Both directions of writing may be in it.
    static void measure(Piece& piece, const TextLine& line, double stretch)
    {
        const auto whole = line.reach(piece.first, piece.end - piece.first);
        piece.left = whole.first;
        piece.right = whole.second;
        for (qsizetype i = piece.first; line.isMixed() && i < piece.end; ++i) {
            const auto [left, right] = line.reach(i, 1);
            piece.left = std::min(piece.left, left);
            piece.right = std::max(piece.right, right);
        }
        piece.left *= stretch;
        piece.right *= stretch;
    }

    // How far the chunk begins to the right of its position.
    double anchored(const Chunk& chunk, const std::vector<Piece>& pieces) const
    {
        using Anchor = TextStyle::Anchor;
        double left = 0, right = 0;
        for (const Piece& piece : pieces) {
            left = std::min(left, piece.left + piece.shift.x);
            right = std::max(right, piece.right + piece.shift.x);
        }
        right -= gapAfter(chunk.end - 1);
        const TextRun& run = runAt(chunk.first);
        if (run.anchor == Anchor::Middle)
            return -(left + right) / 2;
        return (run.anchor == Anchor::Start) == run.rightToLeft ? -right : -left;
    }

    // The spacing after a letter, which does not count as part of it.
    double gapAfter(qsizetype index) const
    {
        return isJoined(content_.text()[index]) ? 0 : runAt(index).font.letterSpacing;
    }

    void setStraight(const Chunk& chunk, TextLine& line, double stretch)
    {
        const auto pieces = piecesOf(chunk, line, stretch);
        const Point begin = pen_ + Point{anchored(chunk, pieces), 0};
        for (const Piece& piece : pieces) {
            const Point baseline =
                begin + piece.shift + Point{0, runAt(chunk.first + piece.first).lowered};
            const double angle = piece.turn * std::numbers::pi / 180;
            const Matrix where = turnedTo(baseline + Point{piece.left, 0},
                                          {std::cos(angle), std::sin(angle)}, {piece.left, 0});
            add(chunk, piece, line, stretch, piece.turn == 0 ? translation(baseline) : where);
        }
        pen_ = begin + Point{line.width() * stretch, 0};
        if (!pieces.empty())
            pen_ += pieces.back().shift;
    }

    // How long a piece is in a vertical line.
    double heightOf(const Chunk& chunk, const Piece& piece) const
    {
        return isUprightAt(chunk, piece) ? runAt(chunk.first + piece.first).font.size
                                         : piece.right - piece.left;
    }

    void setDown(const Chunk& chunk, TextLine& line, double stretch)
    {
        using Anchor = TextStyle::Anchor;
        const auto pieces = piecesOf(chunk, line, stretch);
        double height = -gapAfter(chunk.end - 1);
        for (const Piece& piece : pieces)
            height += heightOf(chunk, piece);
        const Anchor anchor = runAt(chunk.first).anchor;
        pen_.y -= anchor == Anchor::Start ? 0 : anchor == Anchor::End ? height : height / 2;
        for (const Piece& piece : pieces) {
            const TextRun& run = runAt(chunk.first + piece.first);
            const double angle = piece.turn * std::numbers::pi / 180;
            const Matrix turned = turnedTo({}, {std::cos(angle), std::sin(angle)}, {});
            const Matrix upright = translation(
                Point{-(piece.right - piece.left) / 2, ideographicAscent * run.font.size});
            const Matrix along = Matrix{0, 1, -1, 0, 0, 0} * translation({0, run.lowered});
            add(chunk, piece, line, stretch,
                translation(pen_ + piece.shift) * (isUprightAt(chunk, piece) ? upright : along)
                    * turned * translation({-piece.left, 0}));
            pen_.y += heightOf(chunk, piece);
        }
        if (!pieces.empty())
            pen_ += pieces.back().shift;
    }

    void setOnPath(const Chunk& chunk, TextLine& line, double stretch)
    {
        const auto pieces = piecesOf(chunk, line, stretch);
        const TextRun& run = runAt(chunk.first);
        const LetterPlace& place = content_.placeOf(chunk.first);
        const double from = isGiven(place.x) ? place.x : run.path == walked_ ? walkedTo_ : 0;
        const double begin = run.startOffset + from + orZero(place.dx) + anchored(chunk, pieces);
        for (const Piece& piece : pieces) {
            const double gap = gapAfter(chunk.first + piece.end - 1);
            const double middle = (piece.left + piece.right - gap) / 2;
            const auto step = run.path->at(begin + piece.shift.x + middle);
            parts_.leavesPath = parts_.leavesPath || !step;
            if (!step)
                continue;
            const double angle = piece.turn * std::numbers::pi / 180;
            const double across =
                piece.shift.y + orZero(place.dy) + runAt(chunk.first + piece.first).lowered;
            const Matrix turned = turnedTo({}, {std::cos(angle), std::sin(angle)}, {});
            add(chunk, piece, line, stretch,
                turnedTo(step->at, step->along, {middle, -across}) * translation({piece.left, 0})
                    * turned * translation({-piece.left, 0}));
        }
        walked_ = run.path;
        walkedTo_ = begin - run.startOffset + line.width() * stretch;
        if (const auto end = run.path->at(run.path->length()))
            pen_ = end->at;
    }

    void add(const Chunk& chunk, const Piece& piece, TextLine& line, double stretch,
             const Matrix& where)
    {
        LineLetters letters = line.letters(piece.first, piece.end - piece.first);
        parts_.missing << letters.missing;
        parts_.pictures += letters.pictures;
        if (letters.paths.empty())
            return;
        for (Subpath& path : letters.paths)
            transform(path, where * Matrix{stretch, 0, 0, 1, 0, 0});
        const bool plain = piece.turn == 0 && stretch == 1 && letters.ofOneFont
                           && letters.missing.isEmpty() && !runAt(chunk.first).path
                           && !runAt(chunk.first).vertical;
        const QString text =
            content_.text().mid(chunk.first + piece.first, piece.end - piece.first);
        LaidLetters laid{std::move(letters.paths), content_.runOf(chunk.first + piece.first),
                         plain ? text : QString(), where({piece.left, 0}),
                         piece.right - piece.left, {{where, piece.left, piece.right}}};
        if (!joins(laid))
            parts_.letters.push_back(std::move(laid));
    }

    // Joins letters to those before them, where each letter has a place of its own that is near
    // its usual one.
    bool joins(LaidLetters& laid)
    {
        constexpr double near = 0.3; // of the font's size
        if (parts_.letters.empty() || laid.text.isEmpty())
            return false;
        LaidLetters& last = parts_.letters.back();
        const double size = runs_[laid.run].font.size;
        const double gap = laid.at.x - (last.at.x + last.width);
        if (last.text.isEmpty() || last.run != laid.run || last.at.y != laid.at.y
            || !(std::abs(gap) <= near * size) || last.text.size() + laid.text.size() > longestText)
            return false;
        std::ranges::move(laid.paths, std::back_inserter(last.paths));
        std::ranges::move(laid.cells, std::back_inserter(last.cells));
        last.text += laid.text;
        last.width = laid.at.x + laid.width - last.at.x;
        return true;
    }

    const TextContent& content_;
    const std::vector<TextRun>& runs_;
    const std::vector<TextFit>& fits_;
    LineFonts& fonts_;
    std::vector<bool> fitted_;
    TextParts parts_;
    Point pen_{};
    std::shared_ptr<const PathWalk> walked_{}; ///< the path of the last chunk
    double walkedTo_ = 0;                      ///< where that chunk ends on it
};

struct NamedBaseline {
    std::string_view name;
    double ascent, descent, xHeight; ///< how far it lies above the baseline, in shares of these
};
constexpr std::array namedBaselines{
    NamedBaseline{"middle", 0, 0, 0.5},
    NamedBaseline{"central", 0.5, -0.5, 0},
    NamedBaseline{"center", 0.5, -0.5, 0},
    NamedBaseline{"hanging", 0.8, 0, 0},
    NamedBaseline{"mathematical", 0.5, 0, 0},
    NamedBaseline{"text-before-edge", 1, 0, 0},
    NamedBaseline{"before-edge", 1, 0, 0},
    NamedBaseline{"text-top", 1, 0, 0},
    NamedBaseline{"top", 1, 0, 0},
    NamedBaseline{"text-after-edge", 0, -1, 0},
    NamedBaseline{"after-edge", 0, -1, 0},
    NamedBaseline{"text-bottom", 0, -1, 0},
    NamedBaseline{"bottom", 0, -1, 0},
    NamedBaseline{"ideographic", 0, -1, 0},
};

} // namespace

double depthOfBaseline(std::string_view line, const LineMeasures& measures)
{
    const auto found = std::ranges::find_if(namedBaselines, [&](const NamedBaseline& each) {
        return equalsIgnoringCase(each.name, line);
    });
    if (found == namedBaselines.end())
        return 0;
    return found->ascent * measures.ascent + found->descent * measures.descent
           + found->xHeight * measures.xHeight;
}

Subpath LetterCell::box(double top, double bottom) const
{
    Subpath path{{left, top}, {{{right, top}}, {{right, bottom}}, {{left, bottom}}}, true};
    transform(path, where);
    return path;
}

TextParts laidOut(const TextContent& content, const std::vector<TextRun>& runs,
                  const std::vector<TextFit>& fits, LineFonts& fonts)
{
    return TextSetter(content, runs, fits, fonts).set();
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"
#include "app/lettering/glyph_outlines.h"

#include <QStringList>
#include <QTextLayout>

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace app {

constexpr double leastFontSize = 1e-100; ///< smaller letters are not laid out

/// The font of a part of a line, as style sheets name it. Lengths are in any unit, the same for
/// all; letters are as large in it.
struct LineFont {
    QString family; ///< one that is installed
    int weight = 400;
    bool italic = false, smallCapitals = false, kerning = true;
    double size = 16; ///< of the em
    double letterSpacing = 0, wordSpacing = 0;
    friend bool operator==(const LineFont&, const LineFont&) = default;
};

/// Heights above the baseline; `descent` below it.
struct LineMeasures {
    double ascent = 0, descent = 0, capital = 0, xHeight = 0;
    double underline = 0, strikeOut = 0; ///< the middles of lines under and through the letters
    double thickness = 0;                ///< of these lines
    double superscript = 0, subscript = 0;
};
LineMeasures operator*(const LineMeasures& measures, double scale);

/// What is known of fonts, shared by the lines of a drawing: looking it up takes longer than laying
/// out a line. To be used in one thread.
class LineFonts {
public:
    LineMeasures measuresOf(const LineFont& font);
    const QString& familyOf(const LineFont& font); ///< that Qt really takes
    GlyphOutlines& glyphsOf(const QRawFont& font);

private:
    struct Known {
        LineMeasures ofUnit; ///< for letters of size 1
        QString family;
    };
    const Known& known(const LineFont& font);

    std::map<QString, Known> known_;
    std::map<QString, GlyphOutlines> glyphs_;
};

/// The letters of a part of a line, y down, from the start of the line's baseline.
struct LineLetters {
    std::vector<Subpath> paths{};
    QStringList missing{}; ///< characters that no font has; boxes stand in their places
    int pictures = 0;      ///< letters that are pictures in their font, and have no outline
    bool ofOneFont = true; ///< no letter is taken from another font than the one that was asked for
};

/// One line of text in one or several fonts, as Qt lays it out: with kerning, ligatures and both
/// directions of writing. At most `longestText` characters. Needs a QGuiApplication; each line may
/// be used in one thread.
class TextLine {
public:
    struct Span {
        qsizetype length;
        LineFont font;
    };
    TextLine(const QString& text, std::span<const Span> spans, bool rightToLeft, LineFonts& fonts);

    double width() const;
    /// Where these characters begin and end, from the left end of the line.
    std::pair<double, double> reach(qsizetype first, qsizetype count) const;
    /// The first character after `index` that is not joined to it, as accents and surrogates are.
    qsizetype nextLetter(qsizetype index) const { return layout_->nextCursorPosition(int(index)); }
    bool isMixed() const { return mixed_; } ///< whether some of it is written from right to left
    LineLetters letters(qsizetype first, qsizetype count);

private:
    double unit_ = 1; ///< of the result in pixels
    bool mixed_ = false;
    QString text_;
    std::unique_ptr<QTextLayout> layout_;
    LineFonts* fonts_;
    QStringList families_; ///< that were asked for
};

} // namespace app

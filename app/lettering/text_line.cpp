// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/text_line.h"

#include "app/document/path.h"

#include <QFont>
#include <QGlyphRun>
#include <QRawFont>
#include <QtEndian>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// Gaps between so many letters stay within 2^24 pixels: Qt's lines are shorter than 2^25.
QFont lineFontOf(const LineFont& font, double pixelsPerUnit, qsizetype letters = 1)
{
    const double most = double(1 << 24) / double(std::max<qsizetype>(letters, 1));
    const auto pixels = [&](double spacing) {
        return std::clamp(spacing * pixelsPerUnit, -most, most);
    };
    QFont made(font.family);
    made.setWeight(QFont::Weight(std::clamp(font.weight, 1, 1000)));
    made.setItalic(font.italic);
    made.setPixelSize(std::max(int(std::lround(font.size * pixelsPerUnit)), 1));
    if (font.smallCapitals)
        made.setCapitalization(QFont::SmallCaps);
    made.setKerning(font.kerning);
    if (font.letterSpacing != 0)
        made.setLetterSpacing(QFont::AbsoluteSpacing, pixels(font.letterSpacing));
    if (font.wordSpacing != 0)
        made.setWordSpacing(pixels(font.wordSpacing));
    made.setHintingPreference(QFont::PreferNoHinting);
    made.setStyleStrategy(QFont::PreferOutline);
    return made;
}

/// A signed number of a table of the font, in shares of the em; 0 if it has none.
double numberOf(const QRawFont& font, const char* table, qsizetype at)
{
    const QByteArray bytes = font.fontTable(table);
    const double units = font.unitsPerEm();
    return bytes.size() >= at + 2 && units > 0
               ? qFromBigEndian<qint16>(bytes.constData() + at) / units
               : 0;
}

LineMeasures measuresOfUnit(const QRawFont& font)
{
    constexpr qsizetype subscriptOffset = 16, superscriptOffset = 24, strikeOutPosition = 28;
    constexpr double usualThickness = 0.05, usualSub = 0.2, usualSuper = 1.0 / 3; // CSS Inline 3
    constexpr double unit = 1.0 / pixelsPerEm;
    LineMeasures made{font.ascent() * unit, font.descent() * unit, capitalOf(font) * unit,
                      font.xHeight() * unit};
    const double thickness = numberOf(font, "post", 10);
    made.thickness = thickness > 0 ? thickness : usualThickness;
    made.underline = numberOf(font, "post", 8);
    if (made.underline == 0)
        made.underline = -0.1;
    made.strikeOut = numberOf(font, "OS/2", strikeOutPosition);
    if (made.strikeOut <= 0)
        made.strikeOut = made.xHeight / 2;
    const double above = numberOf(font, "OS/2", superscriptOffset);
    const double below = numberOf(font, "OS/2", subscriptOffset);
    made.superscript = above > 0 ? above : usualSuper;
    made.subscript = -(below > 0 ? below : usualSub);
    return made;
}

// Whether a glyph without outline is neither a blank nor of no width: a picture.
bool isSeen(const QRawFont& font, quint32 glyph)
{
    static const QString blankLetters = QStringLiteral(" \u00a0\u2002\u2003\u2009\u3000");
    return glyph != 0 && font.advancesForGlyphIndexes({glyph}).first().x() > 0
           && !font.glyphIndexesForString(blankLetters).contains(glyph);
}

double largestSize(std::span<const TextLine::Span> spans)
{
    double size = 0;
    for (const auto& span : spans)
        size = std::max(size, span.font.size);
    return size >= leastFontSize ? size : 1;
}

} // namespace

const LineFonts::Known& LineFonts::known(const LineFont& font)
{
    const auto [at, isNew] = known_.try_emplace(
        QStringLiteral("%1 %2 %3").arg(font.family).arg(font.weight).arg(font.italic));
    if (isNew) {
        const QRawFont raw = QRawFont::fromFont(
            lineFontOf({font.family, font.weight, font.italic, false, true, 1}, pixelsPerEm));
        at->second = {measuresOfUnit(raw), raw.familyName()};
    }
    return at->second;
}

LineMeasures LineFonts::measuresOf(const LineFont& font) { return known(font).ofUnit * font.size; }

LineMeasures operator*(const LineMeasures& m, double scale)
{
    return {m.ascent * scale,    m.descent * scale,     m.capital * scale,
            m.xHeight * scale,   m.underline * scale,   m.strikeOut * scale,
            m.thickness * scale, m.superscript * scale, m.subscript * scale};
}

const QString& LineFonts::familyOf(const LineFont& font) { return known(font).family; }

GlyphOutlines& LineFonts::glyphsOf(const QRawFont& font)
{
    return glyphs_[QStringLiteral("%1 %2 %3 %4 %5")
                       .arg(font.familyName(), font.styleName())
                       .arg(font.pixelSize())
                       .arg(font.weight())
                       .arg(int(font.style()))];
}

TextLine::TextLine(const QString& text, std::span<const Span> spans, bool rightToLeft,
                   LineFonts& fonts)
    : unit_(largestSize(spans) / pixelsPerEm), text_(text),
      layout_(std::make_unique<QTextLayout>()), fonts_(&fonts)
{
    mixed_ =
        rightToLeft || std::ranges::any_of(text, [](QChar c) {
            return c.direction() == QChar::DirR || c.direction() == QChar::DirAL || c.isSurrogate();
        });
    QList<QTextLayout::FormatRange> formats;
    qsizetype from = 0;
    for (const Span& span : spans) {
        QTextCharFormat format;
        format.setFont(lineFontOf(span.font, 1 / unit_, text.size()));
        formats << QTextLayout::FormatRange{int(from), int(span.length), format};
        families_ << fonts.familyOf(span.font);
        from += span.length;
    }
    QTextOption option(Qt::AlignLeft | Qt::AlignAbsolute);
    option.setWrapMode(QTextOption::NoWrap);
    option.setUseDesignMetrics(true);
    option.setTextDirection(rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
    layout_->setText(text);
    if (!spans.empty())
        layout_->setFont(lineFontOf(spans.front().font, 1 / unit_));
    layout_->setTextOption(option);
    layout_->setFormats(formats);
    layout_->beginLayout();
    QTextLine line = layout_->createLine();
    if (line.isValid())
        line.setNumColumns(int(text.size()));
    layout_->endLayout();
}

double TextLine::width() const
{
    return layout_->lineCount() > 0 ? layout_->lineAt(0).horizontalAdvance() * unit_ : 0;
}

std::pair<double, double> TextLine::reach(qsizetype first, qsizetype count) const
{
    if (layout_->lineCount() == 0)
        return {0, 0};
    const QTextLine line = layout_->lineAt(0);
    const double a = line.cursorToX(int(first)), b = line.cursorToX(int(first + count));
    return {std::min(a, b) * unit_, std::max(a, b) * unit_};
}

LineLetters TextLine::letters(qsizetype first, qsizetype count)
{
    LineLetters result;
    if (layout_->lineCount() == 0 || count == 0)
        return result;
    const QTextLine line = layout_->lineAt(0);
    const double baseline = line.y() + line.ascent();
    for (const QGlyphRun& run : line.glyphRuns(int(first), int(count))) {
        const QRawFont font = run.rawFont();
        result.ofOneFont = result.ofOneFont && families_.contains(font.familyName());
        GlyphOutlines& glyphs = fonts_->glyphsOf(font);
        const auto indexes = run.glyphIndexes();
        const auto positions = run.positions();
        for (qsizetype i = 0; i < indexes.size(); ++i) {
            for (Subpath path : glyphs.glyph(font, indexes[i])) {
                forEachPoint(path, [&](Point& p) {
                    p = (p + Point{positions[i].x(), positions[i].y() - baseline}) * unit_;
                });
                result.paths.push_back(std::move(path));
            }
            if (glyphs.glyph(font, indexes[i]).empty() && isSeen(font, indexes[i]))
                ++result.pictures;
            if (indexes[i] == 0)
                result.missing << text_.mid(first, count).simplified();
        }
    }
    return result;
}

} // namespace app

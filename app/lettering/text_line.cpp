// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/text_line.h"

#include "app/document/path.h"

#include <QFont>
#include <QGlyphRun>
#include <QRawFont>

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
    if (font.letterSpacing != 0)
        made.setLetterSpacing(QFont::AbsoluteSpacing, pixels(font.letterSpacing));
    if (font.wordSpacing != 0)
        made.setWordSpacing(pixels(font.wordSpacing));
    made.setHintingPreference(QFont::PreferNoHinting);
    made.setStyleStrategy(QFont::PreferOutline);
    return made;
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
            lineFontOf({font.family, font.weight, font.italic, false, 1}, pixelsPerEm));
        constexpr double unit = 1.0 / pixelsPerEm;
        at->second = {{raw.ascent() * unit, raw.descent() * unit, capitalOf(raw) * unit,
                       raw.xHeight() * unit},
                      raw.familyName()};
    }
    return at->second;
}

LineMeasures LineFonts::measuresOf(const LineFont& font)
{
    const LineMeasures& unit = known(font).ofUnit;
    return {unit.ascent * font.size, unit.descent * font.size, unit.capital * font.size,
            unit.xHeight * font.size};
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
            if (indexes[i] == 0)
                result.missing << text_.mid(first, count).simplified();
        }
    }
    return result;
}

} // namespace app

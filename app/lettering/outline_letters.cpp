// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/outline_letters.h"

#include "app/document/path.h"
#include "app/lettering/glyph_outlines.h"

#include <QFont>
#include <QGlyphRun>
#include <QRawFont>
#include <QTextLayout>

#include <algorithm>

namespace app {
namespace {

QFont fontOf(const QString& family, const FontFace& face)
{
    QFont font(family);
    font.setBold(face.bold);
    font.setItalic(face.italic);
    font.setPixelSize(pixelsPerEm);
    font.setHintingPreference(QFont::PreferNoHinting);
    // A letter that the font lacks is named, not taken from another font.
    font.setStyleStrategy(QFont::StyleStrategy(QFont::PreferOutline | QFont::NoFontMerging));
    return font;
}

class OutlineWriter {
public:
    OutlineWriter(const QString& family, const FontFace& face)
        : font_(fontOf(family, face)), raw_(QRawFont::fromFont(font_))
    {
        done.capital = capitalOf(raw_);
    }

    void write(QString text)
    {
        text = text.normalized(QString::NormalizationForm_C).replace(u'\t', u' ');
        double baseline = 0;
        for (const QString& line : text.split(u'\n')) {
            add(line, baseline);
            baseline += linePitch * done.capital;
        }
        name(text);
    }
    Letters done;

private:
    void add(const QString& text, double baseline)
    {
        QTextOption option(Qt::AlignLeft | Qt::AlignAbsolute);
        option.setWrapMode(QTextOption::NoWrap);
        option.setUseDesignMetrics(true);
        QTextLayout layout(text, font_);
        layout.setTextOption(option);
        layout.beginLayout();
        QTextLine line = layout.createLine();
        if (line.isValid())
            line.setNumColumns(int(text.size()));
        layout.endLayout();
        for (const QGlyphRun& run : layout.glyphRuns()) {
            const auto indexes = run.glyphIndexes();
            const auto positions = run.positions();
            for (qsizetype i = 0; i < indexes.size(); ++i)
                add(glyphs_.glyph(raw_, indexes[i]),
                    {positions[i].x(), positions[i].y() - line.ascent() - line.y() + baseline});
        }
    }
    void add(const std::vector<Subpath>& glyph, const Point& at)
    {
        for (Subpath path : glyph) {
            forEachPoint(path, [&](Point& p) { p += at; });
            done.paths.push_back(std::move(path));
        }
    }
    bool has(char32_t c) const { return raw_.supportsCharacter(c); }
    void name(const QString& text)
    {
        for (const char32_t c : text.toUcs4()) {
            const QString letter = QString::fromUcs4(&c, 1);
            const auto parts = letter.normalized(QString::NormalizationForm_D).toUcs4();
            const bool invisible = !QChar::isPrint(c) || QChar::isSpace(c);
            if (!invisible && !has(c)
                && !(parts.size() > 1
                     && std::ranges::all_of(parts, [&](char32_t p) { return has(p); }))
                && !done.missing.contains(letter))
                done.missing << letter;
        }
    }

    const QFont font_;
    const QRawFont raw_;
    GlyphOutlines glyphs_;
};

} // namespace

Letters outlineLetters(const QString& text, const QString& family, const FontFace& face)
{
    OutlineWriter writer(family, face);
    writer.write(text);
    return std::move(writer.done);
}

} // namespace app

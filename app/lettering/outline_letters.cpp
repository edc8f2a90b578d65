// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/outline_letters.h"

#include "app/document/path.h"

#include <QFont>
#include <QGlyphRun>
#include <QPainterPath>
#include <QRawFont>
#include <QTextLayout>

#include <algorithm>
#include <map>
#include <span>

namespace app {
namespace {

// Qt places letters to 1/64 pixel; a line of 10,000 letters must stay below 2^25 pixels.
constexpr int pixelsPerEm = 1000;
constexpr double usualCapital = 0.7; // of the em, for a font without capitals

Point pointOf(const QPainterPath::Element& e) { return {e.x, e.y}; }

/// The subpaths of a glyph. Qt ends each with a line to its start where it does not lie there.
std::vector<Subpath> subpathsOf(const QPainterPath& glyph)
{
    std::vector<Subpath> paths;
    for (int i = 0; i < glyph.elementCount(); ++i) {
        const QPainterPath::Element e = glyph.elementAt(i);
        if (e.isMoveTo()) {
            paths.push_back({pointOf(e), {}, true});
        } else if (e.isLineTo()) {
            paths.back().segments.push_back({pointOf(e)});
        } else {
            const Point second = pointOf(glyph.elementAt(i + 1)),
                        to = pointOf(glyph.elementAt(i + 2));
            paths.back().segments.push_back({to, pointOf(e), second, true});
            i += 2;
        }
    }
    for (Subpath& path : paths)
        if (!path.segments.empty() && !path.segments.back().curved
            && path.segments.back().to == path.start)
            path.segments.pop_back(); // a closed subpath has this line
    std::erase_if(paths, [](const Subpath& path) { return path.segments.empty(); });
    return paths;
}

std::vector<Subpath> frame(double width, double height)
{
    const auto ring = [](const Point& min, const Point& max) {
        return std::vector<Point>{min, {max.x, min.y}, max, {min.x, max.y}};
    };
    const double margin = width / 8, pen = width / 12;
    auto outer = ring({margin, -height}, {width - margin, 0});
    auto inner = ring({margin + pen, pen - height}, {width - margin - pen, -pen});
    std::ranges::reverse(inner); // a hole by the rule `nonzero`
    std::vector<Subpath> paths;
    for (const auto& corners : {outer, inner}) {
        Subpath path{corners.front(), {}, true};
        for (const Point& corner : std::span(corners).subspan(1))
            path.segments.push_back({corner});
        paths.push_back(std::move(path));
    }
    return paths;
}

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
        const double capital = raw_.capHeight();
        done.capital = capital > 0 ? capital : usualCapital * pixelsPerEm;
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
                add(glyph(indexes[i]),
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
    const std::vector<Subpath>& glyph(quint32 index)
    {
        const auto [known, isNew] = glyphs_.try_emplace(index);
        if (!isNew)
            return known->second;
        known->second = subpathsOf(raw_.pathForGlyph(index));
        if (index == 0 && known->second.empty()) // the font draws nothing for what it lacks
            known->second = frame(raw_.advancesForGlyphIndexes({0}).first().x(), done.capital);
        return known->second;
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
    std::map<quint32, std::vector<Subpath>> glyphs_;
};

} // namespace

Letters outlineLetters(const QString& text, const QString& family, const FontFace& face)
{
    OutlineWriter writer(family, face);
    writer.write(text);
    return std::move(writer.done);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/writer.h"

#include "app/document/cut.h"
#include "app/document/legacy.h"
#include "app/formats/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/outline_text.h"
#include "app/formats/svg/style_text.h"
#include "app/formats/write_all.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

constexpr std::size_t bufferSize = 1 << 16;

std::string lengthText(const Length& length)
{
    const Unit unit =
        length.unit == Unit::User ? Unit::Px : length.unit; // SVG's bare numbers are px
    std::string text;
    appendNumber(text, length.value);
    return text += infoOf(unit).suffix;
}

// SVG fills what does not say otherwise; a line, which has no area, is read without a fill.
Style writtenStyle(const Shape& shape)
{
    Style style = shape.style;
    if (!hasArea(shape))
        style.fill.reset();
    return style;
}

class Writer {
public:
    Writer(QIODevice& out, const WriteOptions& options) : out_(out), outlines_(options) {}

    /// `added`, if there is one, is the last shape of its layer.
    std::optional<QString> write(const Sheet& sheet, const Shape* added)
    {
        appendHead(sheet);
        auto shape = sheet.shapes.begin();
        for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
            const auto end = std::find_if(shape, sheet.shapes.end(),
                                          [&](const Shape& s) { return s.layer != i; });
            openLayer(sheet.layers[i]);
            appendRuns({shape, end});
            if (added && added->layer == i)
                appendRuns({added, 1});
            text_ += "</g>\n";
            shape = end;
        }
        text_ += "</svg>\n";
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    void appendHead(const Sheet& sheet)
    {
        const Page& page = sheet.page;
        const clipping::Window& window = sheet.window;
        text_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        appendLine(sheet.about.comments);
        text_ += "<svg xmlns=\"http://www.w3.org/2000/svg\""
                 " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
                 " xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\""
                 " xmlns:clearcut=\"urn:clearcut:1\"";
        if (!sheet.about.id.isEmpty())
            appendAttribute(text_, "id", escaped(sheet.about.id));
        appendAttribute(text_, "width", lengthText(page.width));
        appendAttribute(text_, "height", lengthText(page.height));
        appendAttribute(text_, "viewBox",
                        std::array{page.min.x, page.min.y, page.size.x, page.size.y});
        text_ += ">\n";
        appendLine(sheet.about.title);
        appendLine(sheet.about.description);
        appendLine(sheet.about.metadata);
        text_ += "<metadata><clearcut:window";
        appendAttribute(text_, "xmin", window.min.x);
        appendAttribute(text_, "ymin", window.min.y);
        appendAttribute(text_, "xmax", window.max.x);
        appendAttribute(text_, "ymax", window.max.y);
        text_ += "/></metadata>\n";
    }

    // XML that stands in a line of its own; nothing for nothing.
    void appendLine(const QString& xml)
    {
        if (!xml.isEmpty())
            (text_ += xml.toStdString()) += '\n';
    }

    void openLayer(const Layer& layer)
    {
        text_ += "<g inkscape:groupmode=\"layer\"";
        if (!layer.id.isEmpty())
            appendAttribute(text_, "id", escaped(layer.id));
        appendAttribute(text_, "inkscape:label", escaped(layer.name));
        if (layer.locked)
            appendAttribute(text_, "sodipodi:insensitive", "true");
        if (!layer.visible)
            appendAttribute(text_, "display", "none");
        text_ += ">\n";
    }

    void appendRuns(std::span<const Shape> shapes)
    {
        for (auto first = shapes.begin(); first != shapes.end();) {
            const Style style = writtenStyle(*first);
            const auto last = std::find_if(first, shapes.end(), [&](const Shape& shape) {
                return writtenStyle(shape) != style;
            });
            appendRun({first, last}, styleText(style));
            first = last;
        }
    }

    // Shapes of one style, which is written once.
    void appendRun(std::span<const Shape> shapes, const std::string& style)
    {
        const bool grouped = shapes.size() > 1;
        if (grouped)
            text_ += "<g" + style + ">\n";
        for (const Shape& shape : shapes)
            appendShape(shape, grouped ? std::string_view() : style);
        if (grouped)
            text_ += "</g>\n";
    }

    void appendShape(const Shape& shape, std::string_view style)
    {
        if (shape.paths.empty())
            return; // SVG has no element for nothing
        outlines_.append(text_, shape.paths);
        if (!shape.id.isEmpty())
            appendAttribute(text_, "id", escaped(shape.id));
        if (shape.hidden)
            appendAttribute(text_, "display", "none");
        (text_ += style) += "/>\n";
        if (text_.size() > bufferSize)
            flush();
    }

    void flush()
    {
        failed_ = failed_ || !writeAll(out_, text_);
        text_.clear();
    }

    QIODevice& out_;
    OutlineText outlines_;
    std::string text_;
    bool failed_ = false;
};

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    return Writer(out, options).write(sheetOf(document), nullptr);
}

std::optional<QString> writeWith(const Shape& added, const Document& document, QIODevice& out,
                                 const WriteOptions& options)
{
    return Writer(out, options).write(sheetOf(document), &added);
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/writer.h"

#include "app/base/number.h"
#include "app/base/write_all.h"
#include "app/document/object_view.h"
#include "app/formats/painted.h"
#include "app/formats/rounded.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/clip_text.h"
#include "app/formats/svg/guide_text.h"
#include "app/formats/svg/image_text.h"
#include "app/formats/svg/length.h"
#include "app/formats/svg/outline_text.h"
#include "app/formats/svg/recipe_text.h"
#include "app/formats/svg/scale_text.h"
#include "app/formats/svg/sheets_text.h"
#include "app/formats/svg/style_text.h"
#include "app/formats/svg/window_text.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace app::svg {
namespace {

constexpr std::size_t drawingBufferSize = 1 << 16;

// Drawings of more objects share styles by <g>, which makes their files about half as large; other
// programs show such a <g> as a group.
constexpr std::size_t mostApart = 10'000;

std::string lengthText(const Length& length)
{
    const Unit unit =
        length.unit == Unit::User ? Unit::Px : length.unit; // bare numbers are px in SVG
    std::string text;
    appendNumber(text, length.value);
    return text += infoOf(unit).suffix;
}

// SVG fills shapes by default. Single lines have no area and are read without a fill.
bool isFilled(const ObjectView& object) { return object.style().fill && hasArea(object); }

Style writtenStyle(const ObjectView& object)
{
    Style style = object.style();
    if (!isFilled(object))
        style.fill.reset();
    return style;
}

bool sameStyle(const ObjectView& a, const ObjectView& b)
{
    if (a.styleIndex() == b.styleIndex() && isFilled(a) == isFilled(b))
        return true;
    return writtenStyle(a) == writtenStyle(b);
}

class DrawingWriter {
public:
    /// The drawing is written `scale` times as large, by a group around everything.
    DrawingWriter(const Document& document, QIODevice& out, const WriteOptions& options,
                  double scale)
        : document_(document), out_(out), outlines_(options), plain_(options.plain), scale_(scale)
    {
    }

    std::optional<QString> write()
    {
        appendHead();
        if (scale_ != 1) {
            text_ += "<g transform=\"scale(";
            appendNumber(text_, scale_);
            text_ += ")\">\n";
        }
        for (const ContainerId layer : tree().childrenOf(0))
            appendContainer(layer);
        text_ += scale_ != 1 ? "</g>\n</svg>\n" : "</svg>\n";
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    const Containers& tree() const { return document_.containers(); }

    void appendHead()
    {
        const Page& page = document_.page();
        const About& about = document_.about();
        text_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        appendLine(about.comments);
        text_ += "<svg xmlns=\"http://www.w3.org/2000/svg\"";
        if (!plain_)
            text_ += " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
                     " xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\""
                     " xmlns:clearcut=\"urn:clearcut:1\"";
        if (tree().isUnderlaid())
            text_ += " xmlns:xlink=\"http://www.w3.org/1999/xlink\"";
        appendName("id", about.id);
        const Point min = page.min * scale_, size = page.size * scale_;
        appendAttribute(text_, "width",
                        lengthText(scale_ == 1 ? page.width : Length{size.x, Unit::Px}));
        appendAttribute(text_, "height",
                        lengthText(scale_ == 1 ? page.height : Length{size.y, Unit::Px}));
        appendAttribute(text_, "viewBox", std::array{min.x, min.y, size.x, size.y});
        text_ += ">\n";
        appendLine(about.title);
        appendLine(about.description);
        appendLine(about.metadata);
        if (!plain_)
            appendOwn(page);
        clips_.append(text_, document_, outlines_);
    }

    void appendOwn(const Page& page)
    {
        if (const std::string own = textOf(document_.windows()) + textOf(page.guides)
                                    + textOf(page.sheets)
                                    + (scale_ == 1 ? scaleTextOf(page) : std::string());
            !own.empty())
            text_.append("<metadata>").append(own).append("</metadata>\n");
    }

    // Appends XML on a line of its own; nothing for an empty text.
    void appendLine(const QString& xml)
    {
        if (!xml.isEmpty())
            (text_ += xml.toStdString()) += '\n';
    }

    // Appends a name or id, unless it is empty.
    bool appendName(std::string_view attribute, const QString& name)
    {
        const std::string value = escaped(name);
        if (!value.empty())
            appendAttribute(text_, attribute, value);
        return !value.empty();
    }

    // Appends a container with its objects and containers in painting order. Recursion is bounded
    // by Containers::deepest.
    void appendContainer(ContainerId id)
    {
        openContainer(tree()[id]);
        if (const SharedUnderlay& image = tree()[id].underlay) {
            appendImage(text_, *image, id);
            flush();
        }
        const ObjectRange all = tree().rangeOf(id);
        std::size_t next = all.first;
        for (const ContainerId inner : tree().childrenOf(id)) {
            const ObjectRange range = tree().rangeOf(inner);
            appendRuns(next, range.first);
            appendContainer(inner);
            next = range.end;
        }
        appendRuns(next, all.end);
        text_ += "</g>\n";
    }

    void openContainer(const Container& container)
    {
        if (plain_)
            return openPlain(container);
        const bool isLayer = container.kind == Container::Kind::Layer;
        text_ += isLayer ? "<g inkscape:groupmode=\"layer\"" : "<g";
        bool isNamed = appendName("id", container.svgId);
        if (isLayer)
            appendAttribute(text_, "inkscape:label", escaped(container.name));
        else
            isNamed = appendName("inkscape:label", container.name) || isNamed;
        if (!isLayer && !isNamed && container.title.isEmpty() && container.description.isEmpty())
            appendAttribute(text_, "clearcut:group", ""); // otherwise it would be read as a group
                                                          // that only sets a style
        appendName("clearcut:new-objects", container.newStyle);
        if (container.locked)
            appendAttribute(text_, "sodipodi:insensitive", "true");
        if (!container.visible)
            appendAttribute(text_, "display", "none");
        text_ += ">\n";
        appendLine(container.title);
        appendLine(container.description);
    }

    void openPlain(const Container& container)
    {
        text_ += "<g";
        appendName("id", container.svgId);
        if (!container.visible)
            appendAttribute(text_, "display", "none");
        text_ += ">\n";
        appendLine(container.title);
        appendLine(container.description);
    }

    // In large drawings, puts consecutive objects of one style into a <g> with that style.
    void appendRuns(std::size_t first, std::size_t end)
    {
        std::optional<ObjectView> begin; // first object of the run
        std::string style;
        bool grouped = false;
        const bool shares = document_.objects().size() > mostApart;
        const auto endRun = [&] {
            if (grouped)
                text_ += "</g>\n";
            else if (begin)
                appendObject(*begin, style);
            grouped = false;
        };
        document_.objects().forEach(first, end - first, [&](std::size_t, const ObjectView& object) {
            const bool same = begin && sameStyle(*begin, object);
            if (same && shares) {
                if (!grouped) {
                    text_ += "<g" + style + ">\n";
                    appendObject(*begin, {});
                }
                grouped = true;
                appendObject(object, {});
            } else {
                endRun();
                begin = object;
                if (!same)
                    style = styleText(writtenStyle(object));
            }
        });
        endRun();
    }

    void appendObject(const ObjectView& object, std::string_view style)
    {
        const Path path = object.path();
        if (path.subpathCount() == 0)
            return; // SVG has no element for an empty path
        const auto line = path.singleLine();
        const auto name = line ? outlines_.appendLine(text_, line->a, line->b)
                               : outlines_.append(text_, path.subpaths());
        const Particulars& particulars = object.particulars();
        if (!particulars.id.isEmpty())
            appendAttribute(text_, "id", escaped(particulars.id));
        if (const std::string recipe =
                plain_ ? std::string() : svg::textOf(particulars.recipe, path);
            !recipe.empty())
            appendAttribute(text_, "clearcut:recipe", recipe);
        if (object.hidden())
            appendAttribute(text_, "display", "none");
        clips_.appendReference(text_, particulars.clips);
        text_ += style;
        if (particulars.title.isEmpty() && particulars.description.isEmpty())
            text_ += "/>\n";
        else
            text_.append(">")
                .append(particulars.title.toStdString())
                .append(particulars.description.toStdString())
                .append("</")
                .append(name)
                .append(">\n");
        if (text_.size() > drawingBufferSize)
            flush();
    }

    void flush()
    {
        failed_ = failed_ || !writeAll(out_, text_);
        text_.clear();
    }

    const Document& document_;
    QIODevice& out_;
    OutlineText outlines_;
    ClipText clips_;
    const bool plain_;
    const double scale_;
    std::string text_;
    bool failed_ = false;
};

std::optional<QString> writeScaled(const Document& document, QIODevice& out,
                                   const WriteOptions& options, double scale)
{
    if (auto fault = faultOf(document.page()))
        return fault;
    const Document made = rounded(document, options).document;
    return DrawingWriter(made, out, options, scale).write();
}

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    return writeScaled(document, out, options, 1);
}

std::optional<QString> writeInPixels(const Document& document, QIODevice& out,
                                     const WriteOptions& options)
{
    assert(document.windows().list.empty());
    const double pixelsPerUnit = document.page().millimetresPerUnit() / pixel;
    return writeScaled(document, out, options, pixelsPerUnit);
}

} // namespace app::svg

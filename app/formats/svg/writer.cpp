// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/writer.h"

#include "app/formats/number.h"

#include <algorithm>
#include <limits>

namespace app::svg {
namespace {

constexpr std::size_t bufferSize = 1 << 16;

std::string escaped(const QString& text)
{
    std::string result;
    for (const char c : text.toStdString()) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\t':
            result += "&#9;";
            break;
        case '\n':
            result += "&#10;";
            break;
        case '\r':
            result += "&#13;";
            break;
        default:
            if (static_cast<unsigned char>(c) >= 0x20) // XML has no way to write the others
                result += c;
        }
    }
    return result;
}

class Writer {
public:
    Writer(QIODevice& out, const WriteOptions& options) : out_(out), options_(options) {}

    std::optional<QString> write(const Sheet& sheet)
    {
        head(sheet);
        auto shape = sheet.shapes.begin();
        for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
            const auto end = std::find_if(shape, sheet.shapes.end(),
                                          [&](const Shape& s) { return s.layer != i; });
            layer(sheet.layers[i], {shape, end});
            shape = end;
        }
        text_ += "</svg>\n";
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    void head(const Sheet& sheet)
    {
        const Page& page = sheet.page;
        text_ += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                 "<svg xmlns=\"http://www.w3.org/2000/svg\""
                 " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\""
                 " xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\""
                 " xmlns:clearcut=\"urn:clearcut:1\"";
        length("width", page.width);
        length("height", page.height);
        text_ += " viewBox=\"";
        numbers({page.min.x, page.min.y, page.size.x, page.size.y});
        text_ += "\">\n<metadata><clearcut:window";
        number("xmin", sheet.window.min.x);
        number("ymin", sheet.window.min.y);
        number("xmax", sheet.window.max.x);
        number("ymax", sheet.window.max.y);
        text_ += "/></metadata>\n";
    }

    void layer(const Layer& layer, std::span<const Shape> shapes)
    {
        text_ += "<g inkscape:groupmode=\"layer\"";
        word("inkscape:label", escaped(layer.name));
        if (layer.locked)
            word("sodipodi:insensitive", "true");
        if (!layer.visible)
            word("display", "none");
        text_ += ">\n";
        for (auto first = shapes.begin(); first != shapes.end();) {
            const auto last = std::find_if(first, shapes.end(), [&](const Shape& shape) {
                return shape.style != first->style;
            });
            run({first, last});
            first = last;
        }
        text_ += "</g>\n";
    }

    // Shapes of one style.
    void run(std::span<const Shape> shapes)
    {
        const std::string style = styleAttributes(shapes.front().style);
        const bool grouped = shapes.size() > 1;
        if (grouped)
            text_ += "<g" + style + ">\n";
        for (const Shape& one : shapes)
            shape(one, grouped ? std::string() : style);
        if (grouped)
            text_ += "</g>\n";
    }

    std::string styleAttributes(const Style& style)
    {
        std::string attributes;
        std::swap(attributes, text_);
        const Style initial{.fill = Colour{}};
        if (style.fill != initial.fill)
            paint("fill", "fill-opacity", style.fill);
        if (style.stroke)
            paint("stroke", "stroke-opacity", style.stroke);
        if (style.width != initial.width)
            number("stroke-width", style.width);
        if (style.cap != initial.cap)
            word("stroke-linecap", style.cap == Cap::Round ? "round" : "square");
        if (style.join != initial.join)
            word("stroke-linejoin", style.join == Join::Round ? "round" : "bevel");
        if (style.miterLimit != initial.miterLimit)
            number("stroke-miterlimit", style.miterLimit);
        if (std::ranges::any_of(style.dashes, [](double dash) { return dash > 0; })) {
            text_ += " stroke-dasharray=\"";
            numbers(style.dashes);
            text_ += '"';
        }
        if (style.dashOffset != initial.dashOffset)
            number("stroke-dashoffset", style.dashOffset);
        if (style.fillRule != initial.fillRule)
            word("fill-rule", "evenodd");
        std::swap(attributes, text_);
        return attributes;
    }

    void shape(const Shape& shape, const std::string& style)
    {
        if (shape.paths.empty())
            return; // SVG has no element for nothing
        const auto rest = [&] {
            if (!shape.id.isEmpty())
                word("id", escaped(shape.id));
            if (shape.hidden)
                word("display", "none");
            text_ += style;
            text_ += "/>\n";
        };
        geometry(shape.paths);
        rest();
        if (text_.size() > bufferSize)
            flush();
    }

    void geometry(const std::vector<Path>& paths)
    {
        const Path& path = paths.front();
        const bool straight = std::ranges::none_of(path.stretches, &Stretch::curved);
        if (paths.size() > 1 || !straight || (path.closed && path.stretches.empty())) {
            text_ += "<path d=\"";
            for (const Path& one : paths)
                pathData(one);
            text_ += '"';
        } else if (path.stretches.size() <= 1 && !path.closed) {
            line(path.start, path.stretches.empty() ? path.start : path.stretches.front().to);
        } else {
            text_ += path.closed ? "<polygon points=\"" : "<polyline points=\"";
            point(path.start);
            for (const Stretch& stretch : path.stretches) {
                text_ += ' ';
                point(stretch.to);
            }
            text_ += '"';
        }
    }

    void line(const Point& from, const Point& to)
    {
        const auto one = [&](std::string_view name, double value, int axis) {
            text_ += name;
            coordinate(value, axis);
        };
        one("<line x1=\"", from.x, 0);
        one("\" y1=\"", from.y, 1);
        one("\" x2=\"", to.x, 0);
        one("\" y2=\"", to.y, 1);
        text_ += '"';
    }

    void pathData(const Path& path)
    {
        text_ += 'M';
        point(path.start);
        for (const Stretch& stretch : path.stretches) {
            text_ += stretch.curved ? 'C' : 'L';
            if (stretch.curved) {
                control(stretch.control1);
                text_ += ' ';
                control(stretch.control2);
                text_ += ' ';
            }
            point(stretch.to);
        }
        if (path.stretches.empty() && !path.closed) {
            text_ += 'L'; // a point is a line without length
            point(path.start);
        }
        if (path.closed)
            text_ += 'Z';
    }

    void point(const Point& p)
    {
        coordinate(p.x, 0);
        text_ += ' ';
        coordinate(p.y, 1);
    }

    // The curve's own points are in the bounds when its ends are not: controls may lie anywhere.
    void control(const Point& p)
    {
        constexpr double all = std::numeric_limits<double>::infinity();
        for (int axis : {0, 1}) {
            if (axis == 1)
                text_ += ' ';
            if (options_.precision < 0)
                appendNumber(text_, p[axis]);
            else
                appendNumber(text_, p[axis], options_.precision, -all, all);
        }
    }

    void coordinate(double value, int axis)
    {
        constexpr double all = std::numeric_limits<double>::infinity();
        if (options_.precision < 0)
            appendNumber(text_, value);
        else if (options_.bounds)
            appendNumber(text_, value, options_.precision, options_.bounds->min[axis],
                         options_.bounds->max[axis]);
        else
            appendNumber(text_, value, options_.precision, -all, all);
    }

    void paint(std::string_view name, std::string_view opacity, const std::optional<Colour>& colour)
    {
        if (!colour) {
            word(name, "none");
            return;
        }
        constexpr std::string_view digits = "0123456789abcdef";
        std::string text = "#";
        for (const std::uint8_t part : {colour->red, colour->green, colour->blue}) {
            text += digits[part >> 4];
            text += digits[part & 15];
        }
        word(name, text);
        if (colour->alpha != 255) {
            std::string alpha;
            appendNumber(alpha, colour->alpha / 255.0, 3, 0, 1); // enough to read the same byte
            word(opacity, alpha);
        }
    }

    void word(std::string_view name, std::string_view value)
    {
        (((text_ += ' ') += name) += "=\"") += value;
        text_ += '"';
    }

    void number(std::string_view name, double value)
    {
        ((text_ += ' ') += name) += "=\"";
        appendNumber(text_, value);
        text_ += '"';
    }

    void length(std::string_view name, const Length& length)
    {
        const Unit unit = length.unit == Unit::User ? Unit::Px : length.unit;
        std::string text;
        appendNumber(text, length.value);
        word(name, text += infoOf(unit).suffix);
    }

    void numbers(std::span<const double> values)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0)
                text_ += ' ';
            appendNumber(text_, values[i]);
        }
    }
    void numbers(std::initializer_list<double> values)
    {
        numbers(std::span(values.begin(), values.size()));
    }

    void flush()
    {
        failed_ = failed_ || out_.write(text_.data(), qint64(text_.size())) != qint64(text_.size());
        text_.clear();
    }

    QIODevice& out_;
    const WriteOptions& options_;
    std::string text_;
    bool failed_ = false;
};

} // namespace

std::optional<QString> write(const Sheet& sheet, QIODevice& out, const WriteOptions& options)
{
    return Writer(out, options).write(sheet);
}

} // namespace app::svg

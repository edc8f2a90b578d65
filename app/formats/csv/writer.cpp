// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/writer.h"

#include "app/document/cut.h"
#include "app/document/flatten.h"
#include "app/document/legacy.h"
#include "app/formats/coordinates.h"
#include "app/formats/csv/columns.h"
#include "app/formats/csv/text.h"
#include "app/formats/number.h"
#include "app/formats/write_all.h"

#include <algorithm>
#include <numeric>

namespace app::csv {
namespace {

constexpr std::size_t bufferSize = 1 << 16;

std::string colourText(const Colour& colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    const auto append = [&](std::uint8_t part) {
        text += digits[part >> 4];
        text += digits[part & 15];
    };
    append(colour.red);
    append(colour.green);
    append(colour.blue);
    if (colour.alpha != 255)
        append(colour.alpha);
    return text;
}

class Writer {
public:
    Writer(const Sheet& sheet, QIODevice& out, const WriteOptions& options)
        : sheet_(sheet), out_(out), options_(options),
          tolerance_(options.tolerance > 0 ? options.tolerance : usualTolerance(sheet.page))
    {
    }

    std::optional<QString> write()
    {
        const std::size_t columns = columnNames.size() - (options_.sources.empty() ? 1 : 0);
        for (std::size_t i = 0; i < columns; ++i)
            (text_ += i > 0 ? "," : "") += columnNames[i];
        text_ += '\n';
        for (const std::size_t shape : order())
            if (sheet_.shown(sheet_.shapes[shape]))
                write(shape);
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    std::vector<std::size_t> order() const
    {
        std::vector<std::size_t> order(sheet_.shapes.size());
        std::iota(order.begin(), order.end(), 0);
        if (!options_.sources.empty())
            std::ranges::stable_sort(order, {}, [&](std::size_t i) { return options_.sources[i]; });
        return order;
    }

    void write(std::size_t index)
    {
        const Shape& shape = sheet_.shapes[index];
        const auto ink = lineInk(shape);
        if (!ink)
            return; // nothing is drawn
        std::string rest = ",";
        appendField(rest, sheet_.layers[shape.layer].name.toStdString());
        (rest += ',') += colourText(*ink);
        rest += ',';
        appendNumber(rest, shape.style.width);
        if (!options_.sources.empty())
            (rest += ',') += std::to_string(options_.sources[index]);
        rest += '\n';
        chords_.clear();
        for (const Subpath& path : shape.paths)
            flatten(path, tolerance_, chords_);
        for (const Chord& chord : chords_) {
            appendPoint(text_, chord.segment.a, ',', options_);
            text_ += ',';
            appendPoint(text_, chord.segment.b, ',', options_);
            text_ += rest;
            if (text_.size() > bufferSize)
                flush();
        }
    }

    void flush()
    {
        failed_ = failed_ || !writeAll(out_, text_);
        text_.clear();
    }

    const Sheet& sheet_;
    QIODevice& out_;
    const WriteOptions& options_;
    const double tolerance_;
    std::string text_;
    std::vector<Chord> chords_;
    bool failed_ = false;
};

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    const Sheet sheet = sheetOf(document);
    return Writer(sheet, out, options).write();
}

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/writer.h"

#include "app/base/write_all.h"
#include "app/document/flatten.h"
#include "app/document/line_colour.h"
#include "app/formats/coordinates.h"
#include "app/formats/csv/look_columns.h"

#include <algorithm>
#include <numeric>

namespace app::csv {
namespace {

constexpr std::size_t bufferSize = 1 << 16;

class Writer {
public:
    Writer(const Document& document, QIODevice& out, const WriteOptions& options)
        : document_(document), out_(out), options_(options),
          tolerance_(options.tolerance > 0 ? options.tolerance : usualTolerance(document.page()))
    {
    }

    std::optional<QString> write()
    {
        text_ = headerText(!options_.sources.empty());
        const ObjectRanges hidden = document_.containers().hiddenRanges();
        for (const std::uint32_t i : order())
            if (!hidden.contains(i))
                write(i, document_.objects()[i]);
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    std::vector<std::uint32_t> order() const
    {
        std::vector<std::uint32_t> order(document_.objects().size());
        std::iota(order.begin(), order.end(), 0);
        if (!options_.sources.empty())
            std::ranges::stable_sort(order, {}, [&](std::size_t i) { return options_.sources[i]; });
        return order;
    }

    void write(std::size_t index, const ObjectView& object)
    {
        const auto strokeColour = lineColour(object);
        if (object.hidden() || !strokeColour)
            return; // such an object is invisible
        lines_.clear();
        appendSegments(object.path(), tolerance_, lines_);
        std::string rest =
            columnsOf({document_.containers().layerOf(index), object.styleIndex(), *strokeColour});
        if (!options_.sources.empty())
            (rest += ',') += std::to_string(options_.sources[index]);
        rest += '\n';
        for (const auto& line : lines_) {
            if (becomesPoint(line, options_))
                continue;
            appendPoint(text_, line.a, ',', options_);
            text_ += ',';
            appendPoint(text_, line.b, ',', options_);
            text_ += rest;
            if (text_.size() > bufferSize)
                flush();
        }
    }

    // Everything in a row except the coordinates.
    struct Look {
        ContainerId layer;
        StyleIndex style;
        Colour strokeColour;
        friend bool operator==(const Look&, const Look&) = default;
    };

    // ",layer,colour,width"; often the same as for the previous line.
    const std::string& columnsOf(const Look& look)
    {
        if (look_ == look)
            return columns_;
        look_ = look;
        columns_ = lookColumns(document_.containers()[look.layer].name, look.strokeColour,
                               document_.styles()[look.style].width);
        return columns_;
    }

    void flush()
    {
        failed_ = failed_ || !writeAll(out_, text_);
        text_.clear();
    }

    const Document& document_;
    QIODevice& out_;
    const WriteOptions& options_;
    const double tolerance_;
    std::string text_;
    std::vector<clipping::Segment> lines_; ///< of the current object
    std::optional<Look> look_;
    std::string columns_;
    bool failed_ = false;
};

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    return Writer(document, out, options).write();
}

} // namespace app::csv

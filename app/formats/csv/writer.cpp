// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/writer.h"

#include "app/base/write_all.h"
#include "app/document/flatten.h"
#include "app/document/object_view.h"
#include "app/formats/coordinates.h"
#include "app/formats/csv/columns.h"
#include "app/view/caps.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ranges>

namespace app::csv {
namespace {

constexpr std::size_t tableBufferSize = 1 << 16;

class TableWriter {
public:
    TableWriter(const Document& document, QIODevice& out, const WriteOptions& options)
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
        appendLines(object);
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
            if (text_.size() > tableBufferSize)
                flush();
        }
    }

    // Each dash is a line, as dashes cannot be told from other lines in a table.
    void appendLines(const ObjectView& object)
    {
        const Style& style = object.style();
        if (style.dashes.empty() || !style.stroke) {
            appendSegments(object.path(), tolerance_, lines_);
            return;
        }
        for (const Subpath& path : object.path().subpaths())
            appendDashes(path, style, lines_);
    }

    void appendDashes(const Subpath& path, const Style& style,
                      std::vector<clipping::Segment>& lines) const
    {
        constexpr double mostDashes = 1e6; // of a path; it becomes solid beyond
        std::vector<Chord> chords;
        flatten(path, tolerance_, chords);
        std::vector<QPointF> points{{path.start.x, path.start.y}};
        Point min = path.start, max = path.start;
        double length = 0;
        for (const auto& [a, b] : chords | std::views::transform(&Chord::segment)) {
            points.emplace_back(b.x, b.y);
            length += std::hypot(b.x - a.x, b.y - a.y);
            min = glm::min(min, b);
            max = glm::max(max, b);
        }
        const auto inside = [&](const QPointF& p) { // where rounding of a part put it outside
            return glm::clamp(Point{p.x(), p.y()}, min, max);
        };
        const double shortest = length * double(style.dashes.size()) / mostDashes;
        for (const auto& dash : dashes(points, style.dashes, style.dashOffset, shortest))
            for (std::size_t i = 1; i < dash.size(); ++i)
                lines.push_back({inside(dash[i - 1]), inside(dash[i])});
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
    return TableWriter(document, out, options).write();
}

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_block.h"

#include <algorithm>

namespace app {
namespace {

bool isNone(const Shared<Particulars>& particulars)
{
    return sameAddress(particulars, noParticulars()) || *particulars == Particulars{};
}

template <class T>
void addSome(std::vector<T>& column, const std::vector<T>& more, std::size_t first,
             std::size_t count)
{
    const auto from = more.begin() + std::ptrdiff_t(first);
    column.insert(column.end(), from, from + std::ptrdiff_t(count));
}

// Appends the next object's value to a column, which stays empty while all values are usual.
template <class T>
void add(std::vector<T>& column, std::size_t before, const T& value, const T& usual, bool isUsual)
{
    if (column.empty() && isUsual)
        return;
    column.resize(before, usual); // if it was empty
    column.push_back(isUsual ? usual : value);
}

template <class T>
void add(std::vector<T>& column, std::size_t before, const std::vector<T>& more, std::size_t first,
         std::size_t count, const T& usual)
{
    if (column.empty() && more.empty())
        return;
    column.resize(before, usual); // if it was empty
    if (more.empty())
        column.resize(before + count, usual);
    else
        addSome(column, more, first, count);
}

void addStyle(std::vector<StyleIndex>& styles, std::size_t before, StyleIndex style)
{
    if (before > 0 && styles.size() == 1) {
        if (styles[0] == style)
            return;
        styles.resize(before, styles[0]);
    }
    styles.push_back(style);
}

void addStyles(std::vector<StyleIndex>& styles, std::size_t before,
               const std::vector<StyleIndex>& more, std::size_t first, std::size_t count)
{
    if (more.size() > 1) {
        if (before > 0)
            styles.resize(before, styles[0]); // if one value was for all
        addSome(styles, more, first, count);
    } else if (before == 0) {
        styles = more;
    } else if (styles.size() > 1 || styles[0] != more[0]) {
        styles.resize(before, styles[0]);
        styles.resize(before + count, more[0]);
    }
}

void toPaths(ObjectBlock& block)
{
    for (const clipping::Segment& line : block.lines)
        block.paths.emplace_back(line);
    block.lines = {};
}

} // namespace

std::uint32_t weight(const Path& path)
{
    return std::uint32_t(std::max<std::size_t>(path.pointCount(), 2));
}

std::uint32_t ObjectBlock::pointsOf(std::size_t first, std::size_t count) const
{
    if (count == size())
        return points;
    if (paths.empty())
        return std::uint32_t(2 * count);
    std::uint32_t sum = 0;
    for (const Path& path : std::span(paths).subspan(first, count))
        sum += weight(path);
    return sum;
}

std::size_t ObjectBlock::heapBytes() const
{
    return app::heapBytes(lines) + app::heapBytes(paths) + app::heapBytes(styles)
           + app::heapBytes(hidden) + app::heapBytes(particulars);
}

HeapPart ObjectBlock::pathPart(std::size_t i) const
{
    return paths.empty() ? HeapPart{} : paths[i].heapPart();
}

HeapPart ObjectBlock::particularsPart(std::size_t i) const
{
    const Shared<Particulars>& own = particularsOf(i);
    if (sameAddress(own, noParticulars()))
        return {};
    std::size_t bytes = heapBlock(Shared<Particulars>::allocated()) + app::heapBytes(own->id)
                        + app::heapBytes(own->title) + app::heapBytes(own->description);
    if (const auto* text = std::get_if<TextRecipe>(&own->recipe))
        bytes += app::heapBytes(text->text) + app::heapBytes(text->font);
    return {&*own, bytes, own.isShared()};
}

void ObjectBlock::append(const clipping::Segment& line, StyleIndex style)
{
    const std::size_t before = size();
    if (paths.empty())
        lines.push_back(line);
    else
        paths.emplace_back(line);
    addStyle(styles, before, style);
    add<std::uint8_t>(hidden, before, 0, 0, true);
    add(particulars, before, noParticulars(), noParticulars(), true);
    points += 2;
}

void ObjectBlock::append(const ObjectRow& row, StyleIndex style)
{
    const std::size_t before = size();
    const auto line = row.path.singleLine();
    if (line && paths.empty()) {
        lines.push_back(*line);
    } else {
        toPaths(*this);
        paths.push_back(row.path);
    }
    addStyle(styles, before, style);
    add<std::uint8_t>(hidden, before, row.hidden, 0, !row.hidden);
    add(particulars, before, row.particulars, noParticulars(), isNone(row.particulars));
    points += weight(row.path);
}

void ObjectBlock::append(const ObjectBlock& from, std::size_t first, std::size_t count)
{
    const std::size_t before = size();
    points += from.pointsOf(first, count);
    if (!from.paths.empty()) {
        toPaths(*this);
        addSome(paths, from.paths, first, count);
    } else if (paths.empty()) {
        addSome(lines, from.lines, first, count);
    } else {
        for (const clipping::Segment& line : std::span(from.lines).subspan(first, count))
            paths.emplace_back(line);
    }
    addStyles(styles, before, from.styles, first, count);
    add<std::uint8_t>(hidden, before, from.hidden, first, count, 0);
    add(particulars, before, from.particulars, first, count, noParticulars());
}

void ObjectBlock::narrow()
{
    if (std::ranges::all_of(paths,
                            [](const Path& path) { return path.singleLine().has_value(); })) {
        for (const Path& path : paths)
            lines.push_back(*path.singleLine());
        paths.clear();
    }
    if (styles.size() > 1
        && std::ranges::adjacent_find(styles, std::ranges::not_equal_to{}) == styles.end())
        styles.erase(styles.begin() + 1, styles.end());
    if (std::ranges::none_of(hidden, [](std::uint8_t one) { return one; }))
        hidden.clear();
    if (std::ranges::all_of(particulars, isNone))
        particulars.clear();
    lines.shrink_to_fit();
    paths.shrink_to_fit();
    styles.shrink_to_fit();
    hidden.shrink_to_fit();
    particulars.shrink_to_fit();
}

} // namespace app

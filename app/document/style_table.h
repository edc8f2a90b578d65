// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

namespace app {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
    friend bool operator==(const Colour&, const Colour&) = default;
};

enum class Cap : std::uint8_t { Butt, Round, Square };
enum class Join : std::uint8_t { Miter, Round, Bevel };
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// How an object is painted, with the meaning and defaults of SVG. Widths and dashes are in user
/// units.
struct Style {
    std::optional<Colour> stroke{};
    std::optional<Colour> fill{};
    double width = 1;
    double miterLimit = 4;
    double dashOffset = 0;
    std::vector<double> dashes{};
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    FillRule fillRule = FillRule::NonZero;
    friend bool operator==(const Style&, const Style&) = default;
};

using StyleIndex = std::uint32_t; ///< the index of a style in its document's table

class StyleTable;

/// A style in its table; valid as long as the table. Only tables make entries, so that the index of
/// one table is never taken for that of another.
class StyleEntry {
public:
    const Style& operator*() const;
    const StyleTable& table() const { return *table_; }
    StyleIndex index() const { return index_; }

private:
    friend class StyleTable;
    StyleEntry(const StyleTable& table, StyleIndex index) : table_(&table), index_(index) {}

    const StyleTable* table_;
    StyleIndex index_;
};

/// The styles of a document, each stored once; styles that differ in any bit are different. The
/// table only grows, and its elements never move, so any threads may read it while others add to
/// it. A thread may use an index that it got from the table, or that was handed to it after the
/// style was added.
class StyleTable {
public:
    StyleTable() = default;
    StyleTable(const StyleTable& other); ///< the same styles with the same indices
    StyleTable& operator=(const StyleTable&) = delete;
    ~StyleTable();

    StyleIndex indexOf(const Style& style); ///< adds the style if it is new
    StyleIndex indexOf(const StyleEntry& entry)
    {
        return &entry.table() == this ? entry.index() : indexOf(*entry);
    }
    const Style& operator[](StyleIndex index) const;
    StyleEntry entry(StyleIndex index) const;
    StyleEntry entryOf(const Style& style) { return entry(indexOf(style)); }
    std::size_t size() const { return size_.load(std::memory_order_acquire); }

private:
    // Step k has room for 256 * 2^k styles and never moves.
    std::array<std::atomic<Style*>, 24> steps_{};
    std::atomic<std::size_t> size_{0}; // written last when a style is added
    std::mutex adding_;
    std::unordered_multimap<std::size_t, StyleIndex> found_; // indices by hash of the style
};

inline const Style& StyleEntry::operator*() const { return (*table_)[index_]; }

} // namespace app

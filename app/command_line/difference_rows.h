// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/differences_at.h"

#include <QStringList>

#include <functional>
#include <string>

// The rows that `clearcut compare` prints.

namespace app {

/// Two variants, and the one window at which both clip.
struct ComparedAt {
    Comparison comparison;
    ClipRegion window;
};

struct DifferenceTotals {
    std::size_t lines = 0; ///< compared
    DifferenceCounts counts;

    void add(const DifferenceTotals& more);
};

/// The names of the fields of a row, and of what CSV repeats in each row.
QStringList differenceNames();
/// The first line of the table as CSV, with its line break.
std::string differenceHeader();
/// The names and values of what is compared, which are the same for all rows.
std::vector<std::pair<QString, QString>> factsOf(const ComparedAt& at);

/// Compares lines, and makes a row for each one that differs.
class DifferenceRows {
public:
    enum class Form : std::uint8_t { None, Csv, Fields };

    /// `at` must outlive this object.
    DifferenceRows(const ComparedAt& at, Form form);

    /// The numbers of a line and of its shape that a row prints. Both count from 1.
    struct Numbers {
        std::size_t line, shape;
    };
    /// Replaces the rows by those of these lines. `numbersOf` is called with the index of a line.
    void compare(std::span<const clipping::Segment> lines,
                 const std::function<Numbers(std::size_t)>& numbersOf);

    const std::string& csv() const { return csv_; }
    const std::vector<QStringList>& fields() const { return fields_; }
    const DifferenceTotals& totals() const { return totals_; }

private:
    using Piece = std::optional<clipping::Segment>;
    void add(const Difference& difference, const Numbers& numbers, const Piece& a, const Piece& b);

    const ComparedAt& at_;
    Form form_;
    std::string facts_; ///< as the end of a row of CSV
    std::string csv_;
    std::vector<QStringList> fields_;
    DifferenceTotals totals_;
};

} // namespace app

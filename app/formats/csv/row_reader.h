// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "app/formats/csv/columns.h"
#include "app/formats/format.h"

#include <QCoreApplication>

#include <optional>
#include <span>
#include <vector>

namespace app::csv {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(csv)
};

using Fields = std::span<const std::string_view>;

/// The line in a row of a table, and how it is drawn. The texts lie in the row's fields.
struct Row {
    clipping::Segment line;
    std::string_view layer;         ///< as written
    std::string_view colour, width; ///< without spaces around them; may be empty
};

/// The meaning of the columns of one file. All functions throw Refused (app/base/csv_text.h), with
/// the given line number, for what is not a row of lines.
class RowReader {
public:
    /// Reads the first record. False if it is no header but a row: its first field is a number.
    bool readHeader(Fields fields, std::size_t line);

    Row row(Fields fields, std::size_t line) const;

    /// Whether rows may begin with a colour, so that a # does not begin a comment.
    bool beginsWithColour() const { return positions_[StrokeColour] == 0; }
    /// The columns that are not read.
    const std::vector<Loss>& report() const { return report_; }

private:
    void readName(std::string_view field, std::size_t index, std::size_t line);
    std::string_view field(Fields fields, Column column) const;
    double number(Fields fields, Column column, std::size_t line) const;

    static constexpr std::size_t none = ~std::size_t(0);
    std::array<std::size_t, columnNames.size()> positions_{}; ///< of each column in a record
    std::size_t mostFields_ = columnNames.size();
    std::vector<Loss> report_;
};

/// The style of a row's line; throws Refused.
Style styleOf(const Row& row, std::size_t line);

} // namespace app::csv

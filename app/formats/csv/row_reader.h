// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/formats/csv/columns.h"
#include "app/formats/csv/dialect.h"
#include "app/formats/csv/wkt.h"
#include "app/formats/format.h"

#include <optional>
#include <span>
#include <vector>

namespace app::csv {

/// The line in a row of a table, and how it is drawn. The texts lie in the row's fields.
struct Row {
    clipping::Segment line;         ///< if the table has no geometries
    std::string_view layer;         ///< as written
    std::string_view colour, width; ///< without spaces around them; may be empty
};

/// The meaning of the columns of one file. All functions throw Refused (app/base/csv_text.h), with
/// the given line number, for what is not a row of lines.
class RowReader {
public:
    /// Reads the first record. False if it is no header but a row: its first field is a number.
    bool readHeader(std::string_view record, std::size_t line);

    char separator() const { return dialect_.separator; } ///< of the fields, or anyBlanks

    Row row(Fields fields, std::size_t line) const;
    /// Whether rows hold WKT in place of coordinates.
    bool hasGeometries() const { return geometry_ != none; }
    std::vector<Subpath> geometry(Fields fields, std::size_t line) const;

    const Dialect& dialect() const { return dialect_; }
    /// Whether rows may begin with a colour, so that a # does not begin a comment.
    bool beginsWithColour() const { return positions_[StrokeColour] == 0; }
    /// The columns that are not read, and a remark on separators other than commas.
    const std::vector<Loss>& report() const { return report_; }

private:
    void readNames(Fields fields, std::size_t line);
    std::string_view field(Fields fields, Column column) const;
    clipping::Segment lineOf(Fields fields, std::size_t line) const;
    double number(Fields fields, Column column, std::size_t line) const;
    void refuseMixture(Fields fields, std::size_t line) const;

    static constexpr std::size_t none = ~std::size_t(0);
    std::array<std::size_t, columnNames.size()> positions_{}; ///< of each column in a record
    std::size_t geometry_ = none;                             ///< the column of geometries
    std::size_t mostFields_ = columnNames.size();
    Dialect dialect_;
    std::vector<Loss> report_;
};

/// The style of a row's line; throws Refused.
Style styleOf(const Row& row, const RowReader& rows, std::size_t line);

} // namespace app::csv

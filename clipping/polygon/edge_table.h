// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/polygon_table.h"
#include "clipping/polygon/prepared.h"

namespace clipping {

/// The numbers of a polygon with area that the vector kernel reads.
class EdgeTable {
public:
    explicit EdgeTable(const PreparedPolygon& polygon);
    EdgeTable(const EdgeTable&) = delete; // the table points into the numbers
    EdgeTable& operator=(const EdgeTable&) = delete;
    const PolygonTable& table() const { return table_; }

private:
    std::vector<double> numbers_;
    PolygonTable table_;
};

} // namespace clipping

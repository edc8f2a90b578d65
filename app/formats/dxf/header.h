// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/dxf/record.h"
#include "app/formats/svg/report.h"

#include <QString>

#include <optional>

namespace app::dxf {

using svg::Report;

/// A unit of $INSUNITS: its size in millimetres, and the unit in which its lengths are shown.
struct DrawingUnit {
    int code;
    double millimetres;
    Unit shown;
};
/// Empty: there is no such unit, or the file has none (0).
std::optional<DrawingUnit> drawingUnit(int code);

/// The settings of a drawing that reading it needs.
struct Header {
    std::string_view version{}, codePage{};
    std::optional<DrawingUnit> unit{};
    double lineTypeScale = 1;
    bool utf8 = false;

    double millimetres() const { return unit ? unit->millimetres : 1; } ///< of the unit
};

/// Reads the section HEADER, which is one record. Throws svg::Refused for a version before R12.
void readHeader(const Record& section, Header& header, Report& report);

} // namespace app::dxf

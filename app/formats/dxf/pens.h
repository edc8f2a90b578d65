// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/formats/dxf/tables.h"

namespace app::dxf {

/// How an entity is drawn, after "as its layer" and "as its block" have been looked up.
struct Pen {
    Colour colour{};
    int weight = -3;                    ///< hundredths of a millimetre; -3: usual
    const LineType* lineType = nullptr; ///< null: continuous
    double lineTypeScale = 1;
};

/// How a shape is painted: its line, its area, or as letters, which have no dashes.
enum class Paint : std::uint8_t { Stroke, Fill, Letters };

class Pens {
public:
    Pens(const Header& header, const Tables& tables, Report& report)
        : header_(header), tables_(tables), report_(report)
    {
    }

    /// The pen of an entity on a layer. `block` is the pen of the insertion that it is in.
    Pen penOf(const Record& record, const LayerEntry& layer, const Pen& block);
    /// `width`: of the line in drawing units; 0: as the pen says.
    Style styleOf(const Pen& pen, Paint paint, double width) const;

private:
    const LineType* lineTypeOf(const std::string& name);

    const Header& header_;
    const Tables& tables_;
    Report& report_;
};

} // namespace app::dxf

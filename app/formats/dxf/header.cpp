// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/header.h"

#include "app/base/text.h"
#include "app/formats/dxf/aci.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/svg/refused.h"

#include <algorithm>
#include <array>

namespace app::dxf {

std::optional<DrawingUnit> drawingUnit(int code)
{
    constexpr double inch = 25.4, metre = 1000, surveyFoot = 1200.0 / 3937 * metre;
    static constexpr std::array all{
        DrawingUnit{1, inch, Unit::Inch},
        DrawingUnit{2, 12 * inch, Unit::Foot},
        DrawingUnit{3, 63'360 * inch, Unit::Foot},
        DrawingUnit{4, 1, Unit::Mm},
        DrawingUnit{5, 10, Unit::Cm},
        DrawingUnit{6, metre, Unit::Metre},
        DrawingUnit{7, 1e3 * metre, Unit::Metre},
        DrawingUnit{8, 1e-6 * inch, Unit::Inch},
        DrawingUnit{9, 1e-3 * inch, Unit::Inch},
        DrawingUnit{10, 36 * inch, Unit::Foot},
        DrawingUnit{11, 1e-7, Unit::Mm},
        DrawingUnit{12, 1e-6, Unit::Mm},
        DrawingUnit{13, 1e-3, Unit::Mm},
        DrawingUnit{14, 100, Unit::Cm},
        DrawingUnit{15, 10 * metre, Unit::Metre},
        DrawingUnit{16, 100 * metre, Unit::Metre},
        DrawingUnit{17, 1e9 * metre, Unit::Metre},
        DrawingUnit{18, 149'597'870'700 * metre, Unit::Metre},
        DrawingUnit{19, 9'460'730'472'580'800 * metre, Unit::Metre},
        DrawingUnit{20, 3.0856775814913673e16 * metre, Unit::Metre},
        DrawingUnit{21, surveyFoot, Unit::Foot},
    };
    const auto found = std::ranges::find(all, code, &DrawingUnit::code);
    return found == all.end() ? std::nullopt : std::optional(*found);
}

namespace {

void takeVersion(std::string_view value, Header& header, Report& report)
{
    header.version = value;
    const auto found = std::ranges::find(versions, value, &Version::key);
    if (found == versions.end()) {
        report.add(losses::newerVersion, value);
        header.utf8 = true;
        return;
    }
    if (!found->read)
        throw svg::Refused{Text::tr("DXF version %1 is not read. Save the drawing as DXF R12 to "
                                    "2018 in the program that made it.")
                               .arg(latin(found->name)),
                           svg::Refused::wholeFile};
    header.utf8 = value >= firstInUtf8;
}

struct Setting {
    std::string_view name;
    void (*take)(std::string_view value, Header& header, Report& report);
};
constexpr std::array settings{
    Setting{"$ACADVER", takeVersion},
    Setting{"$DWGCODEPAGE",
            [](std::string_view value, Header& header, Report&) { header.codePage = value; }},
    Setting{"$INSUNITS", [](std::string_view value, Header& header,
                            Report&) { header.unit = drawingUnit(integerOf(value)); }},
    Setting{"$LTSCALE", [](std::string_view value, Header& header,
                           Report&) { header.lineTypeScale = numberOf(value); }},
};

} // namespace

void readHeader(const Record& section, Header& header, Report& report)
{
    constexpr int name = 9;
    for (std::size_t i = 0; i + 1 < section.pairs.size(); ++i) {
        const auto& [code, value] = section.pairs[i];
        const auto setting = std::ranges::find(settings, value, &Setting::name);
        if (code != name || setting == settings.end())
            continue;
        try {
            setting->take(withoutBlanks(section.pairs[i + 1].value), header, report);
        } catch (const BadValue&) {
            report.turnTo(section.line);
            report.add(losses::badTableEntry);
        }
    }
}

} // namespace app::dxf

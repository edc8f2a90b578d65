// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/dialect.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"
#include "app/formats/csv/columns.h"
#include "app/formats/csv/record_fields.h"
#include "app/formats/csv/wkt.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace app::csv {
namespace {

constexpr double largest = 1e300; // keeps sums and differences finite
constexpr std::array separators{',', ';', '\t', anyBlanks};

// How well a separator divides the first record.
struct Fit {
    bool isTable = false; ///< four numbers, or a header
    std::size_t numbers = 0, fields = 0;
    friend auto operator<=>(const Fit&, const Fit&) = default;
};

Fit fitOf(const Dialect& dialect, std::string_view record, std::size_t line)
try {
    RecordFields divided(dialect.separator);
    const auto fields = divided.of(record, line);
    Fit fit{.fields = fields.size()};
    while (fit.numbers < fields.size()
           && (coordinateOf(fields[fit.numbers], dialect) || isTooLarge(fields[fit.numbers])))
        ++fit.numbers;
    fit.isTable = fit.numbers >= coordinateColumns || namesCoordinates(fields)
                  || std::ranges::any_of(fields, namesGeometry) || isWkt(fields.front());
    return fit;
} catch (const Refused&) { // a fault of a table with commas, unless it has other separators
    return {.fields = dialect.separator == ',' ? record.size() : 0};
}

} // namespace

std::string_view trimmed(std::string_view field)
{
    constexpr std::string_view blank = " \t";
    const auto first = std::min(field.find_first_not_of(blank), field.size());
    return field.substr(first, field.find_last_not_of(blank) + 1 - first);
}

std::optional<double> coordinateOf(std::string_view field, const Dialect& dialect)
{
    field = trimmed(field);
    auto number = parseNumber(field);
    const auto comma = field.find(',');
    if (!number && comma != field.npos && dialect.hasDecimalCommas()
        && field.find('.') == field.npos) {
        std::string pointed(field);
        pointed[comma] = '.';
        number = parseNumber(pointed);
    }
    return number && std::abs(*number) <= largest ? number : std::nullopt;
}

bool isTooLarge(std::string_view field)
{
    field = trimmed(field);
    long double value = 0; // its range exceeds that of double
    const char* const last = field.data() + field.size();
    const auto [end, error] = std::from_chars(field.data(), last, value);
    return error == std::errc{} && end == last && std::isfinite(value) && std::abs(value) > largest;
}

Dialect dialectOf(std::string_view record, std::size_t line)
{
    Dialect best;
    Fit bestFit;
    for (const char separator : separators) {
        const Fit fit = fitOf({separator}, record, line);
        if (fit.isTable)
            return {separator};
        // Words of a sentence are no columns if anything else divides it.
        if (fit > bestFit && (separator != anyBlanks || bestFit.fields < 2)) {
            best.separator = separator;
            bestFit = fit;
        }
    }
    return best;
}

} // namespace app::csv

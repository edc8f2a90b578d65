// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exactness/exactness_columns.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace app {

namespace {

template <ErrorUnit errorUnit>
QString errorCell(const LineExactness& line)
{
    return line.fault == Fault::None ? errorText(errorOf(line, errorUnit)) : QStringLiteral("–");
}

/// Faults rank above any error, by length.
template <ErrorUnit errorUnit>
double errorKey(const LineExactness& line)
{
    constexpr double most = 1e100, fault = 1e150;
    switch (line.fault) {
    case Fault::None:
        return std::min(errorOf(line, errorUnit), most);
    case Fault::NotFinite:
        return std::numeric_limits<double>::max();
    default:
        return fault * (1 + std::min(line.lost, most));
    }
}

double verdictKey(const LineExactness& line)
{
    return int(line.fault) * 4 + line.outside() * 2 + line.orderMatters;
}

} // namespace

std::span<const ExactnessColumn> exactnessColumns()
{
    static const std::array columns{
        ExactnessColumn{
            Text::tr("Line"), Text::tr("The line's number"),
            [](const LineExactness& line) { return countText(line.source + std::size_t(1)); },
            [](const LineExactness& line) { return double(line.source); }, true},
        ExactnessColumn{
            Text::tr("Verdict"),
            Text::tr(
                "What is wrong with the result, and whether it depends on the order of the ends"),
            verdictText, verdictKey, false},
        ExactnessColumn{Text::tr("Error"),
                        Text::tr("How far the worse end is from the true one, in units in the last "
                                 "place of the largest coordinate of line and window (ulps)"),
                        errorCell<ErrorUnit::Largest>, errorKey<ErrorUnit::Largest>, true},
        ExactnessColumn{
            Text::tr("Own ulps"),
            Text::tr("The same distance in units in the last place of the end's own coordinate"),
            errorCell<ErrorUnit::Own>, errorKey<ErrorUnit::Own>, true}};
    return columns;
}

std::vector<std::uint32_t> sortedBy(std::span<const LineExactness> list,
                                    const ExactnessColumn& column, Qt::SortOrder order)
{
    std::vector<double> keys(list.size());
    std::ranges::transform(list, keys.begin(), column.key);
    std::vector<std::uint32_t> rows(list.size());
    std::iota(rows.begin(), rows.end(), 0u);
    std::ranges::stable_sort(rows, [&](std::uint32_t one, std::uint32_t other) {
        return order == Qt::AscendingOrder ? keys[one] < keys[other] : keys[other] < keys[one];
    });
    return rows;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <cstdint>
#include <span>
#include <string_view>

namespace app {

/// The order of the lines in each block of a million: as generated, at random, or sorted by class
/// (line_class.h), which makes branches predictable for the processor.
enum class Order : std::uint8_t { AsTheyCome, Shuffled, ByClass };

/// The names of an order: one row each, in the enum's order.
struct OrderName {
    std::string_view key;   ///< on the command line
    std::string_view words; ///< in tables and for people: "by class"
};
std::span<const OrderName> orders();
const OrderName& nameOf(Order order);

} // namespace app

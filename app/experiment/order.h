// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <cstdint>
#include <span>
#include <string_view>

namespace app {

/// The order of the lines, block by block of a million: as they come, at random, or those of one
/// class (line_class.h) together, which spares the processor from guessing.
enum class Order : std::uint8_t { AsTheyCome, Shuffled, ByClass };

/// How an order is called: one row each, in the enum's order.
struct OrderName {
    std::string_view key;   ///< on the command line
    std::string_view words; ///< in tables and for people: "by class"
};
std::span<const OrderName> orders();
const OrderName& nameOf(Order order);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/order.h"

#include <array>

namespace app {

std::span<const OrderName> orders()
{
    static constexpr std::array all{OrderName{"as-they-come", "as they come"},
                                    OrderName{"shuffled", "shuffled"},
                                    OrderName{"sorted", "by class"}};
    return all;
}

const OrderName& nameOf(Order order) { return orders()[std::size_t(order)]; }

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app::svg {

/// What the address of data holds: url(data:text/css;base64,…), also in quotation marks. Empty for
/// any other address. Nothing is fetched.
std::optional<std::string> dataOf(std::string_view address);

} // namespace app::svg

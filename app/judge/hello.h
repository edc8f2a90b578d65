// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app::plug_in {

/// The child's second line: a word for the result, a space, and the name of the algorithm or the
/// loader's message.
namespace hello {
inline constexpr auto ready = "ready", notLoadable = "not-loadable", noFunction = "no-function",
                      otherVersion = "other-version";
} // namespace hello

} // namespace app::plug_in

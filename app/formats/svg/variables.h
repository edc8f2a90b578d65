// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace app::svg {

/// The custom properties of CSS that an element declares itself, with those around it: "--pen".
struct Variables {
    std::shared_ptr<const Variables> around;
    std::unordered_map<std::string_view, std::string_view> own; ///< values by name
};

/// Whether a value refers to a variable.
bool usesVariables(std::string_view value);

/// The value with each var(--name, fallback) replaced by the variable's value, or else by its
/// fallback. Empty if one has neither, or if the text becomes too long, as it does for variables
/// that refer to themselves. `work` is the number of steps.
struct Substituted {
    std::optional<std::string> text;
    std::size_t work;
};
Substituted substituted(std::string_view value, const Variables* variables);

} // namespace app::svg

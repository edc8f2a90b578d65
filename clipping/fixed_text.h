// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace clipping {

/// Text that is put together when the program is compiled, so that what two forms have in common
/// is written once.
template <std::size_t capacity>
struct FixedText {
    std::array<char, capacity> letters{};
    std::size_t size = 0;

    constexpr void add(std::string_view text)
    {
        for (const char letter : text)
            letters[size++] = letter; // beyond the capacity it does not compile
    }
    constexpr std::string_view view() const { return {letters.data(), size}; }
};

} // namespace clipping

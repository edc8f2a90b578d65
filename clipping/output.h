// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <concepts>
#include <ranges>

namespace CLEARCUT_API clipping {

/// The element types of the arrays that an Output can be: a piece, an index or a mask's byte.
template <class Reference, class Piece>
concept OutputElement =
    std::same_as<Reference, Piece&> || std::same_as<Reference, std::uint32_t&> || std::same_as<
        Reference, std::uint8_t&> || std::same_as<Reference, bool&>;

/// Where `clipAll` (clip.h) writes what it finds, in memory of the caller: an array of
/// - pieces (BasicClipped): each visible piece, with its source and where it was cut;
/// - sources (std::uint32_t): only the indices of the visible segments;
/// - a mask (std::uint8_t or bool): for each segment 1 if it is visible, else 0.
template <class T>
class Output {
public:
    using Piece = BasicClipped<BasicSegment<T>>; ///< a visible piece

    /// An array of the caller: a vector, an array, a span.
    template <std::ranges::contiguous_range Array>
    requires OutputElement<std::ranges::range_reference_t<Array>, Piece>
    constexpr Output(Array&& array) noexcept // NOLINT: it is meant to convert
        : room_(std::ranges::size(array))
    {
        using Element = std::ranges::range_value_t<Array>;
        if constexpr (std::same_as<Element, Piece>)
            pieces_ = std::ranges::data(array);
        else if constexpr (std::same_as<Element, std::uint32_t>)
            sources_ = std::ranges::data(array);
        else
            mask_ = reinterpret_cast<std::uint8_t*>(std::ranges::data(array));
    }

    /// The array, as one of the three; the other two are null. All three are null if it is empty.
    /// @{
    constexpr Piece* pieces() const noexcept { return pieces_; }
    constexpr std::uint32_t* sources() const noexcept { return sources_; }
    constexpr std::uint8_t* mask() const noexcept { return mask_; }
    /// @}
    constexpr std::size_t room() const noexcept { return room_; } ///< the array's size

private:
    Piece* pieces_ = nullptr;
    std::uint32_t* sources_ = nullptr;
    std::uint8_t* mask_ = nullptr;
    std::size_t room_ = 0;
};

/// How far `clipAll` got. It takes all segments, unless the output is full before, or there are
/// 2^32 or more of them: then call it again with `view.from(segments)` and the rest of the output;
/// sources count from there.
struct [[nodiscard]] Progress {
    std::size_t segments = 0; ///< number of segments that were clipped
    std::size_t visible = 0;  ///< number of these that are visible
    /// Whether both numbers are equal.
    friend constexpr bool operator==(const Progress&, const Progress&) = default;
};

} // namespace clipping

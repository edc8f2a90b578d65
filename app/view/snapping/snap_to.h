// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/snapping/snap_offers.h"

namespace app {

/// A set of kinds to snap to.
class SnapTo {
public:
    static const SnapTo Nothing, All;
    static SnapTo usual(); ///< the kinds that are on until a person chooses

    bool has(const SnapKind& kind) const { return bits_ & bitOf(kind); }
    bool has(std::string_view key) const { return has(snapKind(key)); }
    SnapTo with(std::string_view key) const { return SnapTo(bits_ | bitOf(snapKind(key))); }
    SnapTo without(std::string_view key) const { return SnapTo(bits_ & ~bitOf(snapKind(key))); }
    std::size_t size() const; ///< the number of kinds in it

    /// For settings: "+ends -grid …".
    QString text() const;
    /// Reads such a text. Kinds that it does not name are as usual; unknown words are ignored.
    static SnapTo fromText(const QString& text);

    friend SnapTo operator&(SnapTo a, SnapTo b) { return SnapTo(a.bits_ & b.bits_); }
    friend bool operator==(SnapTo, SnapTo) = default;

private:
    constexpr explicit SnapTo(std::uint32_t bits) : bits_(bits) {}
    static std::uint32_t bitOf(const SnapKind& kind)
    {
        return std::uint32_t(1) << (&kind - snapKinds().data());
    }

    std::uint32_t bits_; // a bit for each row of the catalogue
};

inline constexpr SnapTo SnapTo::Nothing{0};
inline constexpr SnapTo SnapTo::All{~std::uint32_t(0)};

} // namespace app

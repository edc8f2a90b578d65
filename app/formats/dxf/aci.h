// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// The AutoCAD Color Index and the versions of DXF, for the reader and the writer.

namespace app::dxf {

/// Special values of group 62.
constexpr int byBlock = 0, byLayer = 256, blackOrWhite = 7;

/// The colours of the index as 0xrrggbb; blackOrWhite is black, as on paper. From 10 on a row of
/// ten for each 15° of hue: five levels of brightness, each pure and mixed with white.
inline constexpr std::array<std::uint32_t, 256> aciColours = [] {
    constexpr std::array<std::uint32_t, 10> first{0,        0xff0000, 0xffff00, 0x00ff00, 0x00ffff,
                                                  0x0000ff, 0xff00ff, 0,        0x808080, 0xc0c0c0};
    constexpr std::array<std::uint32_t, 6> greys{0x333333, 0x5b5b5b, 0x848484,
                                                 0xadadad, 0xd6d6d6, 0xffffff};
    constexpr std::array<std::uint32_t, 5> levels{255, 165, 127, 76, 38};
    constexpr std::size_t firstHue = first.size(), firstGrey = 250;
    std::array<std::uint32_t, 256> colours{};
    for (std::size_t i = 0; i < firstHue; ++i)
        colours[i] = first[i];
    for (std::size_t i = firstHue; i < firstGrey; ++i) {
        const std::size_t hue = (i - firstHue) / 10; // of 24
        const auto quarters = [hue](std::size_t shift) -> std::uint32_t {
            const std::size_t at = (hue + shift) % 24; // 0: where the channel is full
            return at <= 4 || at >= 20 ? 4 : at < 8 ? 8 - at : at > 16 ? at - 16 : 0;
        };
        const std::uint32_t level = levels[i % 10 / 2];
        for (const std::size_t shift : {0, 16, 8}) {            // red, green, blue
            const std::uint32_t pure = quarters(shift) * level; // in quarters
            colours[i] = colours[i] << 8 | (i % 2 == 0 ? pure / 4 : (pure + 4 * level) / 8);
        }
    }
    for (std::size_t i = 0; i < greys.size(); ++i)
        colours[firstGrey + i] = greys[i];
    return colours;
}();

/// A version of the format: what $ACADVER says, and what people call it.
struct Version {
    std::string_view key, name;
    bool read = true;
};
inline constexpr std::array versions{
    Version{"MC0.0", "R1.0", false},  Version{"AC1.2", "R1.2", false},
    Version{"AC1.40", "R1.4", false}, Version{"AC1.50", "R2.0", false},
    Version{"AC2.10", "R2.1", false}, Version{"AC2.21", "R2.2", false},
    Version{"AC2.22", "R2.2", false}, Version{"AC1001", "R2.2", false},
    Version{"AC1002", "R2.5", false}, Version{"AC1003", "R2.6", false},
    Version{"AC1004", "R9", false},   Version{"AC1006", "R10", false},
    Version{"AC1009", "R12"},         Version{"AC1012", "R13"},
    Version{"AC1014", "R14"},         Version{"AC1015", "2000"},
    Version{"AC1018", "2004"},        Version{"AC1021", "2007"},
    Version{"AC1024", "2010"},        Version{"AC1027", "2013"},
    Version{"AC1032", "2018"},
};
inline constexpr std::string_view firstInUtf8 =
    "AC1021"; ///< the first version whose texts are UTF-8

} // namespace app::dxf

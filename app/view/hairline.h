// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"

#include <QImage>
#include <QPointF>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace app {

/// An opaque line of at most one device pixel, as its painters step along it: each pixel of the
/// longer axis ("along") shares its ink between two pixels of the other one ("across"), as
/// QPainter's cosmetic pens do (Wu 1991). Places have 32 binary places and are those of the whole
/// image, so that every band and tile steps through the same ones.
struct Hairline {
    double from, to;         ///< along, from <= to
    std::int64_t zero, step; ///< across, between two centres: at pixel 0, and from pixel to pixel
    unsigned opacity;        ///< of 256
    bool steep;              ///< along is y

    /// Between device pixels of the image; `width`, at most 1, makes it lighter. Caps that are not
    /// butt lengthen it by half a pixel. Empty if a number is too large.
    static std::optional<Hairline> of(QPointF a, QPointF b, double width, Cap cap);

    std::int64_t at(int along) const { return zero + along * step; }
    static int pixelOf(std::int64_t across) { return int(across >> 32); }

    /// Calls visit(along, across, share of 256) for the pixels from `first` to `last` along.
    template <class Visit>
    void visitPixels(int first, int last, Visit visit) const
    {
        std::int64_t across = at(first);
        for (int along = first; along <= last; ++along, across += step) {
            const unsigned share = along > from && along + 1 < to ? opacity : shareOf(along);
            const unsigned second = std::uint32_t(across) >> 24;
            visit(along, pixelOf(across), (256 - second) * share >> 8);
            visit(along, pixelOf(across) + 1, second * share >> 8);
        }
    }

private:
    unsigned shareOf(int along) const
    {
        const double covered = std::min(to, along + 1.0) - std::max(from, double(along));
        return unsigned(std::clamp(covered, 0.0, 1.0) * opacity);
    }
};

/// `share` of 255 of one premultiplied colour, above the rest of another.
inline QRgb mixed(QRgb above, QRgb below, std::uint32_t share)
{
    constexpr std::uint32_t channels = 0x00ff00ff, half = 0x00800080; // two channels at once
    const auto mix = [share](QRgb a, QRgb b) {
        const QRgb sum = (a & channels) * share + (b & channels) * (255 - share);
        return ((sum + ((sum >> 8) & channels) + half) >> 8) & channels;
    };
    return mix(above, below) | mix(above >> 8, below >> 8) << 8;
}

/// Paints the line on a band of an image (32 bits, premultiplied) that begins at row `top`.
void paintHairline(QImage& band, int top, const Hairline& line, const Colour& colour);

} // namespace app

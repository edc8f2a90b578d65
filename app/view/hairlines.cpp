// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairlines.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int tileWidth = 64, tileHeight = 32, tileSize = tileWidth * tileHeight;
constexpr int visitsBetweenSearches = 24;
constexpr std::uint16_t bare = 65'535;
constexpr std::uint16_t shows = 128; // less is half a step of 255: nothing is seen of it

/// `share` of 256 of what shows is covered. Rounded down: lines above each other cover a pixel in
/// the end.
void hide(std::uint16_t& shown, unsigned share)
{
    shown = std::uint16_t(shown * (256 - share) >> 8);
}

} // namespace

Hairlines::Hairlines(int width, Band band)
    : width_(width), columns_((width + tileWidth - 1) / tileWidth), band_(band),
      tiles_(std::size_t(columns_) * std::size_t((band.height + tileHeight - 1) / tileHeight)),
      shown_(std::make_unique_for_overwrite<std::uint16_t[]>(tiles_.size() * tileSize))
{
}

void Hairlines::add(const Hairline& line) { line.steep ? walk<true>(line) : walk<false>(line); }

template <bool steep>
void Hairlines::walk(const Hairline& line)
{
    const int begin = steep ? band_.top : 0, end = steep ? band_.top + band_.height : width_;
    const int beside = steep ? 0 : band_.top, endBeside = steep ? width_ : band_.top + band_.height;
    constexpr int length = steep ? tileHeight : tileWidth, depth = steep ? tileWidth : tileHeight;
    const int first = std::max(int(std::floor(line.from)), begin);
    const int last = std::min(int(std::floor(line.to)), end - 1);
    for (int along = (first - begin) / length; first <= last && along <= (last - begin) / length;
         ++along) {
        const auto [low, high] =
            std::minmax({line.at(std::max(first, begin + along * length)),
                         line.at(std::min(last, begin + (along + 1) * length - 1))});
        const int nearest = std::max(Hairline::pixelOf(low), beside);
        const int farthest = std::min(Hairline::pixelOf(high) + 1, endBeside - 1);
        for (int across = (nearest - beside) / depth;
             nearest <= farthest && across <= (farthest - beside) / depth; ++across)
            walkTile<steep>(line, along, across);
    }
}

template <bool steep>
void Hairlines::walkTile(const Hairline& line, int along, int across)
{
    constexpr int length = steep ? tileHeight : tileWidth, depth = steep ? tileWidth : tileHeight;
    constexpr int next = steep ? tileWidth : 1, beside = steep ? 1 : tileWidth;
    const int tile = steep ? along * columns_ + across : across * columns_ + along;
    if (tiles_[std::size_t(tile)].full)
        return;
    std::uint16_t* const shown = shownIn(tile);
    const int start = (steep ? band_.top : 0) + along * length;
    const int level = (steep ? 0 : band_.top) + across * depth;
    const int first = std::max(int(std::floor(line.from)), start);
    const int last = std::min(int(std::floor(line.to)), start + length - 1);
    line.visitPixels(first, last, [&](int pixel, int row, unsigned share) {
        if (row >= level && row < level + depth)
            hide(shown[(pixel - start) * next + (row - level) * beside], share);
    });
    visited(tile);
}

std::uint16_t* Hairlines::shownIn(int tile)
{
    std::uint16_t* const shown = shown_.get() + std::size_t(tile) * tileSize;
    if (!tiles_[std::size_t(tile)].begun) {
        tiles_[std::size_t(tile)] = {.begun = true};
        begun_.push_back(tile);
        const int columns = width_ - tile % columns_ * tileWidth;
        const int rows = band_.height - tile / columns_ * tileHeight;
        for (int y = 0; y < tileHeight; ++y) // what lies outside the band counts as full
            for (int x = 0; x < tileWidth; ++x)
                shown[y * tileWidth + x] = x < columns && y < rows ? bare : 0;
    }
    return shown;
}

void Hairlines::visited(int tile)
{
    Tile& it = tiles_[std::size_t(tile)];
    if (++it.visits < visitsBetweenSearches)
        return;
    it.visits = 0;
    const std::uint16_t* const shown = shownIn(tile);
    it.full = std::all_of(shown, shown + tileSize, [](std::uint16_t here) { return here < shows; });
}

void Hairlines::paintOn(QImage& band, const Colour& colour)
{
    const QRgb above = qRgb(colour.red, colour.green, colour.blue);
    for (const int tile : begun_) {
        const int left = tile % columns_ * tileWidth, top = tile / columns_ * tileHeight;
        const std::uint16_t* const shown = shownIn(tile);
        for (int y = 0; y < std::min(tileHeight, band_.height - top); ++y) {
            QRgb* const row = reinterpret_cast<QRgb*>(band.scanLine(top + y)) + left;
            for (int x = 0; x < std::min(tileWidth, width_ - left); ++x)
                if (const unsigned share = 255 - (shown[y * tileWidth + x] * 255U + 32'767) / bare)
                    row[x] = mixed(above, row[x], share);
        }
        tiles_[std::size_t(tile)] = {};
    }
    begun_.clear();
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairlines.h"

#include <algorithm>

namespace app {
namespace {

constexpr int tileWidth = 64, tileHeight = 32, tileSize = tileWidth * tileHeight;
constexpr int visitsBetweenSearches = 24;
constexpr std::uint16_t bare = 65'535;
constexpr std::uint16_t shows = 128; // less is half a step of 255: nothing is seen of it
constexpr int columnsWithBits = 64;

/// std::floor is a call where the processor need not have SSE 4.1.
int floorOf(double x)
{
    const int whole = int(x);
    return whole - (whole > x);
}

} // namespace

template <class Pixel>
HairlineTiles<Pixel>::HairlineTiles(int width, Band band)
    : width_(width), columns_((width + tileWidth - 1) / tileWidth), band_(band),
      tiles_(std::size_t(columns_) * std::size_t((band.height + tileHeight - 1) / tileHeight)),
      full_(tiles_.size() / std::size_t(std::max(columns_, 1))),
      pixels_(std::make_unique_for_overwrite<Pixel[]>(tiles_.size() * tileSize))
{
}

template <class Pixel>
void HairlineTiles<Pixel>::add(const Hairline& line, const Colour& colour)
{
    colour_ = colour;
    line.steep ? walk<true>(line) : walk<false>(line);
}

template <class Pixel>
bool HairlineTiles<Pixel>::areFull(const TileRange& tiles) const
{
    if (tiles.right >= columnsWithBits)
        return false;
    const std::uint64_t columns = (~std::uint64_t(0) >> (columnsWithBits - 1 - tiles.right))
                                  & (~std::uint64_t(0) << tiles.left);
    for (int row = tiles.top; row <= tiles.bottom; ++row)
        if ((full_[std::size_t(row)] & columns) != columns)
            return false;
    return true;
}

template <class Pixel>
template <bool steep>
void HairlineTiles<Pixel>::walk(const Hairline& line)
{
    const int begin = steep ? band_.top : 0, end = steep ? band_.top + band_.height : width_;
    const int beside = steep ? 0 : band_.top, endBeside = steep ? width_ : band_.top + band_.height;
    constexpr int length = steep ? tileHeight : tileWidth, depth = steep ? tileWidth : tileHeight;
    const int first = std::max(floorOf(line.from), begin);
    const int last = std::min(floorOf(line.to), end - 1);
    if (first > last)
        return;
    const auto [least, most] = std::minmax({line.at(first), line.at(last)});
    const int top = std::max(Hairline::pixelOf(least), beside) - beside;
    const int bottom = std::min(Hairline::pixelOf(most) + 1, endBeside - 1) - beside;
    if (top > bottom)
        return;
    const TileRange box{(first - begin) / length, (last - begin) / length, top / depth,
                        bottom / depth};
    if (areFull(steep ? TileRange{box.top, box.bottom, box.left, box.right} : box))
        return;
    for (int along = box.left; along <= box.right; ++along) {
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

template <class Pixel>
template <bool steep>
void HairlineTiles<Pixel>::walkTile(const Hairline& line, int along, int across)
{
    constexpr int length = steep ? tileHeight : tileWidth, depth = steep ? tileWidth : tileHeight;
    constexpr int next = steep ? tileWidth : 1, beside = steep ? 1 : tileWidth;
    const int tile = steep ? along * columns_ + across : across * columns_ + along;
    if (tiles_[std::size_t(tile)].full)
        return;
    Pixel* const pixels = pixelsIn(tile);
    const Colour colour = colour_;
    const int start = (steep ? band_.top : 0) + along * length;
    const int level = (steep ? 0 : band_.top) + across * depth;
    const int first = std::max(floorOf(line.from), start);
    const int last = std::min(floorOf(line.to), start + length - 1);
    line.visitPixels(first, last, [&](int pixel, int row, unsigned share) {
        if (row >= level && row < level + depth)
            pixels[(pixel - start) * next + (row - level) * beside].cover(share, colour);
    });
    visited(tile);
}

template <class Pixel>
Pixel* HairlineTiles<Pixel>::pixelsIn(int tile)
{
    Pixel* const pixels = pixels_.get() + std::size_t(tile) * tileSize;
    if (!tiles_[std::size_t(tile)].begun) {
        tiles_[std::size_t(tile)] = {.begun = true};
        begun_.push_back(tile);
        const int columns = width_ - tile % columns_ * tileWidth;
        const int rows = band_.height - tile / columns_ * tileHeight;
        for (int y = 0; y < tileHeight; ++y) // what lies outside the band counts as full
            for (int x = 0; x < tileWidth; ++x) {
                Pixel& pixel = pixels[y * tileWidth + x] = {};
                pixel.shown = x < columns && y < rows ? bare : 0;
            }
    }
    return pixels;
}

template <class Pixel>
void HairlineTiles<Pixel>::visited(int tile)
{
    Tile& it = tiles_[std::size_t(tile)];
    if (++it.visits < visitsBetweenSearches)
        return;
    it.visits = 0;
    const Pixel* const pixels = pixelsIn(tile);
    it.full = std::all_of(pixels, pixels + tileSize,
                          [](const Pixel& here) { return here.shown < shows; });
    if (it.full && tile % columns_ < columnsWithBits)
        full_[std::size_t(tile / columns_)] |= std::uint64_t(1) << (tile % columns_);
}

template <class Pixel>
void HairlineTiles<Pixel>::paintOn(QImage& band)
{
    for (const int tile : begun_) {
        const int left = tile % columns_ * tileWidth, top = tile / columns_ * tileHeight;
        const Pixel* const pixels = pixelsIn(tile);
        for (int y = 0; y < std::min(tileHeight, band_.height - top); ++y) {
            QRgb* const row = reinterpret_cast<QRgb*>(band.scanLine(top + y)) + left;
            for (int x = 0; x < std::min(tileWidth, width_ - left); ++x)
                row[x] = pixels[y * tileWidth + x].above(row[x], colour_);
        }
        tiles_[std::size_t(tile)] = {};
    }
    begun_.clear();
    std::ranges::fill(full_, 0);
}

template class HairlineTiles<ShownPixel>;
template class HairlineTiles<InkedPixel>;

} // namespace app

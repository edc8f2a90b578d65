// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/test_scene.h"

#include <memory>

namespace app {

/// Something off the screen to draw visible lines on, as large as the paper's space (1920 x 1440
/// pixels at most) and showing the whole space of the field.
class Easel {
public:
    virtual ~Easel() = default;
    /// What draws, for the record: "raster, Qt 6.4.2".
    virtual QString name() const = 0;
    virtual void wipe() = 0;
    /// Draws lines, white and one pixel wide; when it returns they are drawn.
    virtual void draw(std::span<const clipping::Clipped> lines) = 0;
    /// Of all pixels, read back.
    virtual std::uint64_t checksum() const = 0;
};
using EaselMaker = std::function<std::unique_ptr<Easel>(const Field& field)>;

/// QPainter on an image in memory: everywhere the same, and without a graphics card.
std::unique_ptr<Easel> rasterEasel(const Field& field);

} // namespace app

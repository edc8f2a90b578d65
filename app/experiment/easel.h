// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/test_scene.h"

#include <QSize>

#include <memory>

namespace app {

/// Something off the screen to draw visible lines on, as large as the paper's space (1920 x 1440
/// pixels at most) and showing the whole space of the field.
class Easel {
public:
    virtual ~Easel() = default;
    /// What draws, for the record: "raster, Qt 6.4.2", "OpenGL 4.5, llvmpipe".
    virtual QString name() const = 0;
    /// Whether other threads or a graphics card draw for the thread that asks: then only the wall
    /// clock tells how long it takes.
    virtual bool drawsElsewhere() const = 0;
    virtual void wipe() = 0;
    /// Draws lines, white and one pixel wide; when it returns they are drawn.
    virtual void draw(std::span<const clipping::Clipped> lines) = 0;
    /// Of all pixels, read back.
    virtual std::uint64_t checksum() const = 0;
};
using EaselMaker = std::function<std::unique_ptr<Easel>(const Field& field)>;

/// QPainter on an image in memory: everywhere the same, and without a graphics card.
std::unique_ptr<Easel> rasterEasel(const Field& field);

/// OpenGL 3.3 off the screen, nothing where there is none. To be asked in the thread of the
/// QGuiApplication; each easel may then be made and used in any one thread.
EaselMaker openGlEasel();

/// One row of the catalogue of what can draw.
struct EaselKind {
    QString key;           ///< "opengl"
    QString name;          ///< translated
    EaselMaker (*maker)(); ///< gives nothing where it cannot draw; asked as openGlEasel
};

/// The best first; the last one can draw everywhere.
std::vector<EaselKind> easelKinds();

/// The first that can draw here.
EaselMaker bestEasel();

/// How a field is shown on an easel.
struct EaselFit {
    QSize size;
    double scale; ///< pixels per unit
};
EaselFit fitOf(const Field& field);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/test_scene.h"

#include <QSize>

#include <memory>

namespace app {

/// An off-screen draw target for visible lines, as large as the paper's space (at most 1920 x 1440
/// pixels), showing the whole space of the field.
class Easel {
public:
    virtual ~Easel() = default;
    /// The drawing system, for the record: "raster, Qt 6.4.2", "OpenGL 4.5, llvmpipe".
    virtual QString name() const = 0;
    /// Whether other threads or a graphics card do the drawing: then only the wall clock measures
    /// its time.
    virtual bool drawsElsewhere() const = 0;
    virtual void wipe() = 0;
    /// Draws lines, white and one pixel wide; returns when they are drawn.
    virtual void draw(std::span<const clipping::Clipped> lines) = 0;
    /// The checksum of all pixels, read back.
    virtual std::uint64_t checksum() const = 0;
};
using EaselMaker = std::function<std::unique_ptr<Easel>(const Field& field)>;

/// QPainter on an image in memory: the same everywhere, without a graphics card.
std::unique_ptr<Easel> rasterEasel(const Field& field);

/// OpenGL 3.3 off the screen; null where it is not available. Call this in the thread of the
/// QGuiApplication; each draw target may then be created and used in any one thread.
EaselMaker openGlEasel();

/// One row of the catalogue of draw targets.
struct EaselKind {
    QString key;           ///< "opengl"
    QString name;          ///< translated
    EaselMaker (*maker)(); ///< null where it cannot draw; called like openGlEasel
};

/// The best first; the last one works everywhere.
std::vector<EaselKind> easelKinds();

/// The first that works on this machine.
EaselMaker bestEasel();

/// How a field is scaled to a draw target.
struct EaselFit {
    QSize size;
    double scale; ///< pixels per unit
};
EaselFit fitOf(const Field& field);

} // namespace app

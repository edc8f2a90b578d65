// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/test_scene.h"

#include <QSize>

#include <memory>

namespace app {

/// An off-screen draw target for visible lines, as large as the paper's space (at most 1920 x 1440
/// pixels), showing the whole space of the field.
class DrawTarget {
public:
    virtual ~DrawTarget() = default;
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
using DrawTargetMaker = std::function<std::unique_ptr<DrawTarget>(const Field& field)>;

/// QPainter on an image in memory: the same everywhere, without a graphics card.
std::unique_ptr<DrawTarget> rasterTarget(const Field& field);

/// OpenGL 3.3 off the screen; null where it is not available. Call this in the thread of the
/// QGuiApplication; each draw target may then be created and used in any one thread.
DrawTargetMaker openGlTarget();

/// One row of the catalogue of draw targets.
struct DrawTargetKind {
    QString key;                ///< "opengl"
    QString name;               ///< translated
    DrawTargetMaker (*maker)(); ///< null where it cannot draw; called like openGlTarget
};

/// The best first; the last one works everywhere.
std::vector<DrawTargetKind> drawTargetKinds();

/// The first that works on this machine.
DrawTargetMaker bestDrawTarget();

/// How a field is scaled to a draw target.
struct DrawTargetFit {
    QSize size;
    double scale; ///< pixels per unit
};
DrawTargetFit fitOf(const Field& field);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/instances.h"

#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>

#include <memory>

namespace ui {

/// A picture as draw calls, which any thread may make.
struct GlPicture {
    Batches selected, ghost, kept, differing, borders;
};
GlPicture glPicture(const app::Picture& picture, const glm::dvec2& viewSize);

/// Where a picture is shown that was made for another view of the same size: each point `p` of it,
/// in logical pixels from the middle, at `p * scale + shift`.
struct Placed {
    double scale = 1;
    glm::dvec2 shift{0};
};

/// Paints pictures with OpenGL 3.3 core: each straight piece of a stroke is one instance of a quad
/// whose fragment shader knows the distance to its edge; areas are written to the stencil and then
/// covered. Every call, also the destructor, needs the OpenGL context that was current in make().
class Renderer {
public:
    /// Null if the driver fails to provide what a 3.3 core context promises.
    static std::unique_ptr<Renderer> make();

    /// Paints over the current framebuffer, which must have a stencil. `viewSize` in logical
    /// pixels, `ghost` is the opacity of removed lines, 0 to 1.
    void paint(const GlPicture& picture, const Placed& placed, const glm::dvec2& viewSize,
               double pixelRatio, double ghost);

private:
    Renderer() = default;
    bool build();
    bool link(QOpenGLShaderProgram& program, const char* name);
    void describeInstances(std::size_t first);
    void paintBatches(const Batches& all);
    void paintStrokes(const Batches::Batch& batch);
    void paintArea(const Batches& all, const Batches::Batch& batch);
    void paintLayer(double opacity);
    void beginLayer();
    void use(QOpenGLShaderProgram& program);

    QOpenGLFunctions_3_3_Core* gl_ = nullptr;
    QOpenGLShaderProgram strokes_, areas_, layer_;
    QOpenGLVertexArrayObject strokeArray_, areaArray_, layerArray_;
    QOpenGLBuffer instances_, points_;
    std::unique_ptr<QOpenGLFramebufferObject> ghost_;
    glm::dvec2 viewSize_{1};
    Placed placed_;
    double pixelRatio_ = 1;
};

} // namespace ui

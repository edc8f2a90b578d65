// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/renderer.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>
#include <cstddef>

namespace ui {
namespace {

constexpr GLuint endsAt = 0, colourAt = 1, widthAt = 2, capsAt = 3,
                 pointAt = 0; // attribute locations, as in the shaders

// NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset into a buffer as a pointer
const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// Allocates new storage each frame, so that the driver need not wait for the last frame.
template <class T>
void upload(QOpenGLBuffer& buffer, const std::vector<T>& data)
{
    buffer.bind();
    buffer.allocate(data.data(), int(data.size() * sizeof(T)));
}

} // namespace

GlPicture glPicture(const app::Picture& picture, const glm::dvec2& viewSize)
{
    return {batches(picture.selected, viewSize), batches(picture.ghost, viewSize),
            batches(picture.kept, viewSize), batches(picture.differing, viewSize),
            batches(picture.borders, viewSize)};
}

std::unique_ptr<Renderer> Renderer::make()
{
    std::unique_ptr<Renderer> renderer(new Renderer);
    return renderer->build() ? std::move(renderer) : nullptr;
}

bool Renderer::link(QOpenGLShaderProgram& program, const char* name)
{
    const QString path = QStringLiteral(":/shaders/") + QLatin1StringView(name);
    return program.addShaderFromSourceFile(QOpenGLShader::Vertex, path + QStringLiteral(".vert"))
           && program.addShaderFromSourceFile(QOpenGLShader::Fragment,
                                              path + QStringLiteral(".frag"))
           && program.link();
}

bool Renderer::build()
{
    gl_ = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(
        QOpenGLContext::currentContext());
    if (!gl_ || !link(strokes_, "stroke") || !link(areas_, "fill") || !link(layer_, "layer"))
        return false;
    for (auto* buffer : {&instances_, &points_}) {
        buffer->create();
        buffer->setUsagePattern(QOpenGLBuffer::StreamDraw);
    }
    layerArray_.create();
    strokeArray_.create();
    areaArray_.create();
    const QOpenGLVertexArrayObject::Binder binder(&areaArray_);
    points_.bind();
    gl_->glEnableVertexAttribArray(pointAt);
    gl_->glVertexAttribPointer(pointAt, 2, GL_FLOAT, GL_FALSE, sizeof(Batches::Point), nullptr);
    return true;
}

// OpenGL 3.3 has no base instance, so the attribute pointers start at the first instance.
void Renderer::describeInstances(std::size_t first)
{
    instances_.bind();
    const auto at = [&](std::size_t member) { return offset(first * sizeof(Instance) + member); };
    gl_->glVertexAttribPointer(endsAt, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                               at(offsetof(Instance, ax)));
    gl_->glVertexAttribPointer(colourAt, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance),
                               at(offsetof(Instance, rgba)));
    gl_->glVertexAttribPointer(widthAt, 1, GL_FLOAT, GL_FALSE, sizeof(Instance),
                               at(offsetof(Instance, width)));
    gl_->glVertexAttribIPointer(capsAt, 1, GL_UNSIGNED_INT, sizeof(Instance),
                                at(offsetof(Instance, caps)));
    for (const GLuint attribute : {endsAt, colourAt, widthAt, capsAt}) {
        gl_->glEnableVertexAttribArray(attribute);
        gl_->glVertexAttribDivisor(attribute, 1);
    }
}

void Renderer::use(QOpenGLShaderProgram& program)
{
    program.bind();
    program.setUniformValue("viewport", float(viewSize_.x * pixelRatio_),
                            float(viewSize_.y * pixelRatio_));
    program.setUniformValue("pixelRatio", float(pixelRatio_));
    program.setUniformValue("scale", float(placed_.scale));
    program.setUniformValue("shift", float(placed_.shift.x), float(placed_.shift.y));
}

void Renderer::paint(const GlPicture& picture, const Placed& placed, const glm::dvec2& viewSize,
                     double pixelRatio, double ghost)
{
    viewSize_ = viewSize;
    placed_ = placed;
    pixelRatio_ = pixelRatio;
    gl_->glEnable(GL_BLEND);
    gl_->glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glDisable(GL_SCISSOR_TEST);
    gl_->glDisable(GL_CULL_FACE);
    gl_->glStencilMask(0xff);
    gl_->glClearStencil(0);
    gl_->glClear(GL_STENCIL_BUFFER_BIT);
    paintBatches(picture.selected);
    if (!picture.ghost.batches.empty()) {
        GLint target = 0;
        gl_->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
        beginLayer();
        paintBatches(picture.ghost);
        gl_->glBindFramebuffer(GL_FRAMEBUFFER, GLuint(target));
        paintLayer(ghost);
    }
    paintBatches(picture.kept);
    paintBatches(picture.differing);
    paintBatches(picture.borders);
    gl_->glDisable(GL_STENCIL_TEST);
}

void Renderer::beginLayer()
{
    const QSize size(qRound(viewSize_.x * pixelRatio_), qRound(viewSize_.y * pixelRatio_));
    if (!ghost_ || ghost_->size() != size)
        ghost_ = std::make_unique<QOpenGLFramebufferObject>(
            size, QOpenGLFramebufferObject::CombinedDepthStencil);
    ghost_->bind();
    gl_->glClearColor(0, 0, 0, 0);
    gl_->glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Renderer::paintLayer(double opacity)
{
    layer_.bind();
    layer_.setUniformValue("layer", 0);
    layer_.setUniformValue("opacity", float(opacity));
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, ghost_->texture());
    const QOpenGLVertexArrayObject::Binder binder(&layerArray_);
    gl_->glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Renderer::paintBatches(const Batches& all)
{
    upload(instances_, all.instances);
    upload(points_, all.points);
    for (const Batches::Batch& batch : all.batches)
        batch.filled ? paintArea(all, batch) : paintStrokes(batch);
}

void Renderer::paintStrokes(const Batches::Batch& batch)
{
    use(strokes_);
    const QOpenGLVertexArrayObject::Binder binder(&strokeArray_);
    describeInstances(batch.first);
    gl_->glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(batch.count));
}

// Draws each contour as a triangle fan into the stencil. A pixel is inside if an odd number of
// triangles covers it (even-odd), or unequal numbers of clockwise and counter-clockwise ones
// (nonzero). The second pass paints where the stencil is not 0 and resets it.
void Renderer::paintArea(const Batches& all, const Batches::Batch& batch)
{
    use(areas_);
    const float alpha = float(batch.colour.alpha) / 255.0F, scale = alpha / 255.0F;
    areas_.setUniformValue("ink", float(batch.colour.red) * scale,
                           float(batch.colour.green) * scale, float(batch.colour.blue) * scale,
                           alpha);
    const QOpenGLVertexArrayObject::Binder binder(&areaArray_);
    const auto fans = [&] {
        gl_->glMultiDrawArrays(GL_TRIANGLE_FAN, all.contourStarts.data() + batch.first,
                               all.contourCounts.data() + batch.first, GLsizei(batch.count));
    };
    gl_->glEnable(GL_STENCIL_TEST);
    gl_->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_->glStencilFunc(GL_ALWAYS, 0, 0xff);
    const bool evenOdd = batch.rule == app::FillRule::EvenOdd;
    gl_->glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, evenOdd ? GL_INVERT : GL_INCR_WRAP);
    gl_->glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, evenOdd ? GL_INVERT : GL_DECR_WRAP);
    fans();
    gl_->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->glStencilFunc(GL_NOTEQUAL, 0, 0xff);
    gl_->glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    fans();
    gl_->glDisable(GL_STENCIL_TEST);
}

} // namespace ui

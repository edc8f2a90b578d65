// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/random.h"
#include "app/experiment/draw_target.h"
#include "app/view/open_gl.h"

#include <QOpenGLExtraFunctions>

#include <array>

namespace app {
namespace {

constexpr const char* vertexShader = "#version 330 core\n"
                                     "layout(location = 0) in vec2 position;\n"
                                     "uniform vec2 size;\n"
                                     "void main()\n"
                                     "{ gl_Position = vec4(2.0 * position / size - 1.0, 0, 1); }\n";
constexpr const char* fragmentShader = "#version 330 core\n"
                                       "out vec4 colour;\n"
                                       "void main() { colour = vec4(1); }\n";

/// A vertex array and one buffer that is refilled for each draw.
class OpenGlTarget final : public DrawTarget {
public:
    OpenGlTarget(const Field& field, std::shared_ptr<QOffscreenSurface> surface,
                 std::unique_ptr<QOpenGLContext> context);
    ~OpenGlTarget() override { context_->makeCurrent(surface_.get()); }

    /// Whether it draws correctly.
    bool works() const { return works_; }
    QString name() const override;
    bool drawsElsewhere() const override { return true; }
    void wipe() override;
    void draw(std::span<const clipping::Clipped> lines) override;
    std::uint64_t checksum() const override;

private:
    bool makeCanvas();
    bool makeProgram();
    void makeBuffer();
    std::array<float, 4> shown(const clipping::Segment& line) const
    {
        const glm::dvec2 a = (line.a - corner_) * fit_.scale, b = (line.b - corner_) * fit_.scale;
        return {float(a.x), float(a.y), float(b.x), float(b.y)};
    }

    std::shared_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_; // owns all OpenGL objects created in it
    QOpenGLExtraFunctions& gl_;
    DrawTargetFit fit_;
    glm::dvec2 corner_;
    bool works_;
};

OpenGlTarget::OpenGlTarget(const Field& field, std::shared_ptr<QOffscreenSurface> surface,
                           std::unique_ptr<QOpenGLContext> context)
    : surface_(std::move(surface)), context_(std::move(context)), gl_(*context_->extraFunctions()),
      fit_(fitOf(field)), corner_(field.space.min)
{
    works_ = makeCanvas() && makeProgram();
    makeBuffer();
    wipe();
}

bool OpenGlTarget::makeCanvas()
{
    GLuint pixels = 0, frame = 0;
    gl_.glGenRenderbuffers(1, &pixels);
    gl_.glBindRenderbuffer(GL_RENDERBUFFER, pixels);
    gl_.glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, fit_.size.width(), fit_.size.height());
    gl_.glGenFramebuffers(1, &frame);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, frame);
    gl_.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
    gl_.glViewport(0, 0, fit_.size.width(), fit_.size.height());
    return gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool OpenGlTarget::makeProgram()
{
    const GLuint program = gl_.glCreateProgram();
    for (auto [kind, text] : {std::pair(GL_VERTEX_SHADER, vertexShader),
                              std::pair(GL_FRAGMENT_SHADER, fragmentShader)}) {
        const GLuint shader = gl_.glCreateShader(GLenum(kind));
        gl_.glShaderSource(shader, 1, &text, nullptr);
        gl_.glCompileShader(shader);
        gl_.glAttachShader(program, shader);
    }
    gl_.glLinkProgram(program); // fails if a shader was not compiled
    GLint linked = GL_FALSE;
    gl_.glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        return false;
    gl_.glUseProgram(program);
    gl_.glUniform2f(gl_.glGetUniformLocation(program, "size"), float(fit_.size.width()),
                    float(fit_.size.height()));
    return true;
}

void OpenGlTarget::makeBuffer()
{
    GLuint array = 0, buffer = 0;
    gl_.glGenVertexArrays(1, &array);
    gl_.glBindVertexArray(array);
    gl_.glGenBuffers(1, &buffer);
    gl_.glBindBuffer(GL_ARRAY_BUFFER, buffer);
    gl_.glEnableVertexAttribArray(0);
    gl_.glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

QString OpenGlTarget::name() const
{
    const auto [major, minor] = context_->format().version();
    return QStringLiteral("OpenGL %1.%2, %3").arg(major).arg(minor).arg(rendererOf(*context_));
}

void OpenGlTarget::wipe()
{
    context_->makeCurrent(surface_.get());
    gl_.glClearColor(0, 0, 0, 1);
    gl_.glClear(GL_COLOR_BUFFER_BIT);
    gl_.glFinish();
}

void OpenGlTarget::draw(std::span<const clipping::Clipped> lines)
{
    context_->makeCurrent(surface_.get());
    constexpr std::size_t most = 65'536; // a megabyte
    std::vector<std::array<float, 4>> some;
    some.reserve(std::min(most, lines.size()));
    for (; !lines.empty(); lines = lines.subspan(some.size())) {
        some.clear();
        for (const auto& line : lines.first(std::min(most, lines.size())))
            some.push_back(shown(line.segment));
        gl_.glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(some.size() * sizeof some[0]), some.data(),
                         GL_STREAM_DRAW);
        gl_.glDrawArrays(GL_LINES, 0, GLsizei(2 * some.size()));
    }
    gl_.glFinish();
}

std::uint64_t OpenGlTarget::checksum() const
{
    context_->makeCurrent(surface_.get());
    std::vector<std::uint32_t> pixels(std::size_t(fit_.size.width())
                                      * std::size_t(fit_.size.height()));
    gl_.glReadPixels(0, 0, fit_.size.width(), fit_.size.height(), GL_RGBA, GL_UNSIGNED_BYTE,
                     pixels.data());
    return checksumOf(pixels);
}

} // namespace

DrawTargetMaker openGlTarget()
{
    if (!platformHasGl())
        return nullptr;
    // Some platforms require creation and destruction in this thread, whichever thread holds the
    // maker last.
    std::shared_ptr<QOffscreenSurface> surface(
        new QOffscreenSurface, [](QOffscreenSurface* last) { last->deleteLater(); });
    surface->setFormat(coreFormat());
    surface->create();
    if (!contextOn(*surface))
        return nullptr;
    return [surface](const Field& field) -> std::unique_ptr<DrawTarget> {
        if (auto context = contextOn(*surface))
            if (auto target = std::make_unique<OpenGlTarget>(field, surface, std::move(context));
                target->works())
                return target;
        return rasterTarget(field); // its name says so
    };
}

} // namespace app

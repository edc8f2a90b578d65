// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/trace_file.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <numeric>

namespace app {

namespace {

PaintedCaption captionOf(const TraceExport& trace, std::size_t step)
{
    return {slideTitle(trace.tracedLine, trace.narration, step),
            slideSentence(trace.narration, step)};
}

QByteArray svg(const TraceExport& trace, std::span<const std::size_t> steps)
{
    return svgOf(slidePage(trace, steps.front()), captionOf(trace, steps.front()));
}

QByteArray png(const TraceExport& trace, std::span<const std::size_t> steps)
{
    return pngOf(slidePage(trace, steps.front()), captionOf(trace, steps.front()), trace.scale);
}

QByteArray pdf(const TraceExport& trace, std::span<const std::size_t> steps)
{
    std::vector<PaintedPage> pages;
    for (const std::size_t step : steps)
        pages.push_back(slidePage(trace, step));
    return pdfOf(pages, {titleOf(trace.tracedLine.variant), {}});
}

bool oneFile(const TraceExport& trace, const TraceFormat& format)
{
    return format.files == TraceFormat::Files::One || trace.only;
}

} // namespace

PaintedPage slidePage(const TraceExport& trace, std::size_t step)
{
    return {{slideWidth, slideHeight}, [&trace, step](QPainter& painter) {
                paintSlide(painter, {trace.tracedLine, trace.narration, step}, trace.parts,
                           trace.ground);
            }};
}

std::vector<std::size_t> TraceExport::steps() const
{
    if (only)
        return {*only};
    std::vector<std::size_t> all(std::max<std::size_t>(narration.steps.size(), 1));
    std::iota(all.begin(), all.end(), std::size_t(0));
    return all;
}

std::span<const TraceFormat> traceFormats()
{
    using Files = TraceFormat::Files;
    static const std::array all{
        TraceFormat{"pdf", "pdf", Text::tr("PDF document, one page for each step"), Files::One,
                    true, pdf},
        TraceFormat{"svg", "svg", Text::tr("SVG drawings, one for each step"), Files::OneAStep,
                    true, svg},
        TraceFormat{"png", "png", Text::tr("PNG pictures, one for each step"), Files::OneAStep,
                    true, png},
        TraceFormat{"gif", "gif", Text::tr("Animated GIF picture"), Files::One, true, traceGif},
        TraceFormat{"html", "html", Text::tr("Web page"), Files::One, false, traceHtml},
        TraceFormat{"text", "txt", Text::tr("Text"), Files::One, false, traceText},
        TraceFormat{"json", "json", Text::tr("JSON data"), Files::One, false, traceJson}};
    return all;
}

const TraceFormat* findTraceFormat(QStringView word)
{
    for (const TraceFormat& format : traceFormats())
        for (const std::string_view name : {format.key, format.ending})
            if (word.compare(latin(name), Qt::CaseInsensitive) == 0)
                return &format;
    return nullptr;
}

QString traceStem(const TraceExport& trace)
{
    return keyOf(trace.tracedLine.variant).replace(u':', u'-');
}

QStringList tracePaths(const TraceExport& trace, const TraceFormat& format, const QString& target)
{
    const QString ending = u'.' + latin(format.ending);
    QString stem = target;
    if (QFileInfo(target).isDir() || target.endsWith(u'/'))
        stem = QDir(target).filePath(traceStem(trace));
    else if (oneFile(trace, format))
        return {target};
    else if (target.endsWith(ending, Qt::CaseInsensitive))
        stem.chop(ending.size());
    const auto steps = trace.steps();
    if (format.files == TraceFormat::Files::One)
        return {stem + ending};
    const auto digits =
        std::max<qsizetype>(2, QString::number(trace.narration.steps.size()).size());
    QStringList paths;
    for (const std::size_t step : steps)
        paths << stem + u'-' + QString::number(step + 1).rightJustified(digits, u'0') + ending;
    return paths;
}

QStringList existingOf(const QStringList& paths)
{
    QStringList existing;
    for (const QString& path : paths)
        if (QFileInfo::exists(path))
            existing << path;
    return existing;
}

std::optional<std::vector<QByteArray>> traceBytes(const TraceExport& trace,
                                                  const TraceFormat& format)
{
    const auto steps = trace.steps();
    std::vector<QByteArray> files;
    if (format.files == TraceFormat::Files::One)
        files.push_back(format.bytes(trace, steps));
    else
        for (const std::size_t step : steps)
            files.push_back(format.bytes(trace, {&step, 1}));
    const bool all = std::ranges::none_of(files, &QByteArray::isEmpty);
    return all ? std::optional(std::move(files)) : std::nullopt;
}

std::optional<QString> writeTrace(const QStringList& paths, std::span<const QByteArray> bytes)
{
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const QString& path = paths[qsizetype(i)];
        const auto error = replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
            if (writeAll(out, {bytes[i].data(), std::size_t(bytes[i].size())}))
                return std::nullopt;
            return out.errorString() + u'.';
        });
        if (error)
            return Text::tr("Cannot write %1: %2").arg(path, *error);
    }
    return std::nullopt;
}

} // namespace app

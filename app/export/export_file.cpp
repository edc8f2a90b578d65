// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_file.h"

#include "app/base/text.h"

#include <QBuffer>

#include <new>

namespace app {
namespace {

constexpr double cuttingWeight = 4, writingWeight = 1; // for the progress

/// Takes everything, keeps nothing, and counts the bytes.
class CountingDevice final : public QIODevice {
public:
    CountingDevice() { open(QIODevice::WriteOnly); }
    qint64 bytes() const { return bytes_; }
    bool isSequential() const override { return true; }

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char*, qint64 size) override
    {
        bytes_ += size;
        return size;
    }

private:
    qint64 bytes_ = 0;
};

std::optional<QString> write(const ExportJob& job, const QString& path, const Follower& follower,
                             ExportResult& end)
{
    PhasedProgress phases(follower, {cuttingWeight, writingWeight});
    auto drawing = exportDrawing(job, phases.next());
    if (!drawing)
        return drawing.error;
    end.cut = drawing.value->cut;
    end.counts = drawing.value->counts;
    drawing.value->options.stop = follower.stop;
    return writeFile(drawing.value->document, path, drawing.value->options, &formatOf(job.choice));
}

} // namespace

ExportResult exportFile(const ExportJob& job, const QString& path, const Follower& follower)
{
    ExportResult end;
    const QString outOfMemory =
        Text::tr(
            "Cannot export %1: there is not enough memory. Close other programs, or export a part "
            "of the drawing.")
            .arg(path);
    static_cast<WriteResult&>(end) =
        resultOf([&] { return write(job, path, follower, end); }, follower.stop, outOfMemory);
    return end;
}

Result<QByteArray> exportedContent(const ExportJob& job, const Follower& follower)
{
    using Content = Result<QByteArray>;
    try {
        PhasedProgress phases(follower, {cuttingWeight, writingWeight});
        auto drawing = exportDrawing(job, phases.next());
        if (!drawing)
            return Content::failure(drawing.error);
        drawing.value->options.stop = follower.stop;
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        if (const auto error =
                formatOf(job.choice).write(drawing.value->document, buffer, drawing.value->options))
            return Content::failure(*error);
        return Content::of(buffer.data());
    } catch (const std::bad_alloc&) {
        return Content::failure(
            Text::tr("There is not enough memory for this. Export a part of the drawing."));
    }
}

Result<qint64> exportedBytes(const ExportDrawing& drawing, const Format& format,
                             const std::stop_token& stop)
{
    using Bytes = Result<qint64>;
    try {
        CountingDevice counter;
        WriteOptions options = drawing.options;
        options.stop = stop;
        if (const auto error = format.write(drawing.document, counter, options))
            return Bytes::failure(*error);
        return Bytes::of(counter.bytes());
    } catch (const std::bad_alloc&) {
        return Bytes::failure(Text::tr("there is not enough memory for this file."));
    }
}

} // namespace app

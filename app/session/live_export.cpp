// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/live_export.h"

#include "app/base/text.h"
#include "app/session/export_source.h"

#include <new>

namespace app {
namespace {

using Finished = Result<std::shared_ptr<const LiveExport::Made>>;

Finished madeBy(const ExportJob& job, const Follower& follower)
{
    try {
        auto drawing = exportDrawing(job, follower);
        if (!drawing)
            return Finished::failure(drawing.error);
        const ExportFacts facts = factsOf(*drawing.value, formatOf(job.choice));
        SceneLines lines = linesOf(drawing.value->document);
        return Finished::of(std::make_shared<const LiveExport::Made>(
            LiveExport::Made{std::move(*drawing.value), facts, std::move(lines)}));
    } catch (const std::bad_alloc&) {
        return Finished::failure(Text::tr("There is not enough memory to export this. Close other "
                                          "programs, or export a part of the drawing."));
    }
}

} // namespace

LiveExport::LiveExport(Session& session, QObject* parent) : QObject(parent), session_(session)
{
    connect(&session.document, &EditedDocument::changed, this, &LiveExport::remake);
    connect(&session, &Session::selectionChanged, this, &LiveExport::remake);
    connect(&session, &Session::displayChanged, this, &LiveExport::remake); // the algorithm
}

ExportJob LiveExport::job() const
{
    ExportJob job{exportSourceOf(session_), choice_};
    job.choice.area = usableArea(job.source, choice_.area);
    return job;
}

QString LiveExport::faultOf(const ExportArea& area) const
{
    return app::faultOf(exportSourceOf(session_), area);
}

void LiveExport::change(ExportChoice choice)
{
    choice_ = std::move(choice);
    remake();
}

void LiveExport::remake()
{
    counter_.cancel();
    bytes_.reset();
    maker_.start([job = job()](const Follower& follower) { return madeBy(job, follower); },
                 [this](Finished result) { take(std::move(result)); });
    emit changed();
}

void LiveExport::take(Finished result)
{
    made_ = result.value.value_or(nullptr);
    error_ = result.error;
    if (made_)
        count();
    emit changed();
}

void LiveExport::count()
{
    counter_.start(
        [made = made_, &format = formatOf(job().choice)](const Follower& follower) {
            return exportedBytes(made->drawing, format, follower.stop);
        },
        [this](const Result<qint64>& bytes) {
            bytes_ = bytes.value;
            error_ = bytes ? QString() : Text::tr("Nothing can be written: %1").arg(bytes.error);
            emit changed();
        });
}

void LiveExport::wait()
{
    maker_.wait();
    counter_.wait();
}

} // namespace app

#include "moc_live_export.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_losses.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/hidden_objects.h"
#include "app/formats/held.h"
#include "app/formats/map_edge.h"
#include "app/formats/rounded.h"

namespace app {
namespace {

/// One kind of loss: how much of it there is, and how it is said.
struct LossRow {
    std::size_t count;
    QString one, many; ///< `many` has a place for the number
};

QStringList saidOf(const LossRow& row)
{
    return row.count == 0
               ? QStringList()
               : QStringList(row.count == 1 ? row.one : row.many.arg(countText(row.count)));
}

std::size_t hiddenIn(const ExportJob& job)
{
    if (objectsOf(job.source, job.choice.area))
        return 0; // they were not chosen
    return hiddenObjects(job.source.document).size();
}

} // namespace

QStringList exportLosses(const ExportJob& job, const Document& chosen, const ObjectRanges& left,
                         const ExportDrawing& made)
{
    const Format& format = formatOf(job.choice);
    const LossRow hidden{format.hides == StoresHidden::No ? hiddenIn(job) : 0,
                         Text::tr("1 hidden object is left out"),
                         Text::tr("%1 hidden objects are left out")};
    const LossRow points{rounded(made.document, made.options).points,
                         Text::tr("1 line becomes a point at this precision and is left out"),
                         Text::tr("%1 lines become points at this precision and are left out")};
    return saidOf(hidden) + lossesOf(chosen, left, format, made.options)
           + outsideMap(made.document, format, made.options) + saidOf(points);
}

} // namespace app

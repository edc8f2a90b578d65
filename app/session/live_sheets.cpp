// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/live_sheets.h"

#include "app/base/text.h"
#include "app/commands/set_page_parts.h"
#include "app/cut/permanent_cuts.h"
#include "app/scene/bounds.h"
#include "app/tiles/empty_sheets.h"
#include "app/tiles/left_out.h"

namespace app {
namespace {

constexpr std::size_t mostLinesAtOnce = 20'000; // cut in some hundredths of a second

Document cutAtItsWindows(const Document& document, const CutOptions& options)
{
    Document made = withOwnStyles(document);
    Cut result = cut(made, options);
    result.edit.windows = ClipWindows();
    made.apply(result.edit);
    return made;
}

} // namespace

LiveSheets::LiveSheets(Session& session, QObject* parent) : QObject(parent), session_(session)
{
    connect(&session.document, &EditedDocument::changed, this, &LiveSheets::follow);
    connect(&session, &Session::displayChanged, this, &LiveSheets::follow); // the algorithm
    connect(&session, &Session::loaded, this, &LiveSheets::forget);
}

void LiveSheets::open()
{
    if (open_)
        return;
    open_ = true;
    take();
    cutDrawing();
    divide();
    emit openChanged();
}

void LiveSheets::close()
{
    if (!open_)
        return;
    keep();
    open_ = false;
    cutter_.cancel();
    emit openChanged();
    cut_.reset();
}

void LiveSheets::keep()
{
    const PageSheets now = settings_;
    if (!open_ || now == kept_)
        return;
    kept_ = now;
    session_.history.push(new SetSheets(session_.document, now, Text::tr("Divide among sheets")));
}

// The division of the document, if it has one that is not known yet.
void LiveSheets::take()
{
    const std::optional<PageSheets>& saved = session_.now().page().sheets;
    if (saved && saved != kept_)
        static_cast<PageSheets&>(settings_) = *saved;
    kept_ = saved ? *saved : settings_;
}

void LiveSheets::follow()
{
    if (!open_)
        return;
    if (const auto& saved = session_.now().page().sheets; saved && saved != kept_)
        take();
    cutDrawing();
    divide();
    emit changed();
}

void LiveSheets::forget()
{
    settings_.name.clear();
    settings_.plan.shift = Point(0);
    takeAllIn(settings_.plan);
    kept_.reset();
    if (open_)
        take();
    follow();
}

void LiveSheets::cutDrawing()
{
    CutOptions options = cutOptions();
    cutAt(options, session_.now().windows(), session_.now().page());
    if (options.region.everything()) {
        cutter_.cancel();
        cut_.reset();
        return;
    }
    const auto take = [this](Document drawing) {
        cut_ = std::make_unique<CutDrawing>(std::move(drawing));
        divide();
        emit changed();
    };
    if (session_.scene.lines().size() <= mostLinesAtOnce) {
        cutter_.cancel();
        cut_ = std::make_unique<CutDrawing>(cutAtItsWindows(session_.now(), options));
        return;
    }
    cutter_.start([document = session_.document.snapshot(),
                   options](const Follower&) { return cutAtItsWindows(document, options); },
                  take);
}

CutOptions LiveSheets::cutOptions() const
{
    CutOptions options = exportOptions(session_.display().cutting, session_.now().page());
    options.clipAll = session_.uses().clipAll;
    return options;
}

void LiveSheets::divide() { tiling_ = divided(settings_); }

Result<Tiling> LiveSheets::divided(const SheetSettings& settings)
{
    const TilePlan plan = planOf(settings);
    const auto drawn = open_ ? boundsOf(scene().lines()) : std::nullopt;
    Result<Tiling> made = tilingOf(session_.now().page(), plan, drawn);
    if (made && open_)
        made.value = withoutEmptySheets(std::move(*made.value), plan, scene().lines(),
                                        drawing().objects(), cutOptions().leastLength);
    return made;
}

std::optional<QString> LiveSheets::change(SheetSettings next)
{
    if (next == settings_)
        return std::nullopt;
    Result<Tiling> made = divided(next);
    const bool other = made && tiling_
                       && (made.value->columns != tiling_.value->columns
                           || made.value->rows != tiling_.value->rows);
    if (other && !next.plan.leftOut.empty()) { // they were other sheets
        takeAllIn(next.plan);
        made = divided(next);
    }
    if (!made && tiling_)
        return made.error;
    settings_ = std::move(next);
    tiling_ = std::move(made);
    emit changed();
    return tiling_ ? std::nullopt : std::optional(tiling_.error);
}

void LiveSheets::setTitle(const QString& title)
{
    if (title == title_)
        return;
    title_ = title;
    if (open_)
        emit changed();
}

Sheets LiveSheets::sheets() const
{
    return {drawing(), planOf(settings_), *tiling_.value, cutOptions(), title_, settings_.overview};
}

QStringList LiveSheets::files() const
{
    return tiling_ ? filesOf(sheets(), patternOf(settings_, title_)) : QStringList();
}

} // namespace app

#include "moc_live_sheets.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panels.h"

#include "app/base/numbers.h"
#include "app/view/frame_times.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/cut_options.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/exactness_panel.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/layers_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/look/text.h"
#include "ui/properties/properties_panel.h"

namespace ui {

Panels::Panels(app::Session& session, Canvas& canvas)
    : start(new StartPanel), algorithm(new AlgorithmPanel(session)),
      window(new WindowPanel(session)), cutEdges(new CutOptionsBox(session)),
      properties(new PropertiesPanel(session, canvas)), line(new LinePanel(session)),
      layers(new LayersPanel(session)), history(new HistoryPanel(session.history)),
      compare(new ComparePanel(session)), difference(new DifferencePanel(session)),
      costMap(new CostMapPanel(session)), exactness(new ExactnessPanel(session)),
      docks{.start = new Dock("start", Text::tr("Start"), start),
            .narrow = {new Dock("algorithm", Text::tr("Algorithm"), algorithm),
                       new Dock("window", Text::tr("Clip windows"), window),
                       new Dock("cut-edges", Text::tr("Cut edges"), cutEdges),
                       new Dock("properties", Text::tr("Properties"), properties),
                       new Dock("line", Text::tr("Line"), line),
                       new Dock("layers", Text::tr("Layers"), layers),
                       new Dock("history", Text::tr("History"), history)},
            .wide = {new Dock("compare", Text::tr("Compare"), compare),
                     new Dock("difference", Text::tr("Differences"), difference),
                     new Dock("cost-map", Text::tr("Cost map"), costMap),
                     new Dock("exactness", Text::tr("Exactness"), exactness)}}
{
    nameSections();
    QObject::connect(docks.named({"compare"}).front(), &QDockWidget::visibilityChanged, compare,
                     &ComparePanel::setWatched);
}

/// What a panel shows stands in the heading of its dock.
void Panels::nameSections()
{
    const auto dock = [this](const char* key) { return docks.named({key}).front(); };
    const auto remark = [&](auto* panel, auto titled, const char* key) {
        QObject::connect(panel, titled, dock(key), &Dock::setRemark);
        dock(key)->setRemark(panel->title());
    };
    remark(window, &WindowPanel::titled, "window");
    remark(cutEdges, &CutOptionsBox::titled, "cut-edges");
    remark(properties, &PropertiesPanel::titled, "properties");
    remark(history, &HistoryPanel::titled, "history");
    QObject::connect(line, &LinePanel::titled, dock("line"),
                     [line = dock("line")](const QString& name, const QString& where) {
                         line->setRemark(where);
                         line->setName(name);
                     });
    const auto showAlgorithm = [this, shown = dock("algorithm")] {
        shown->setSign(algorithm->sign());
        shown->setName(algorithm->abbreviation());
        shown->setRemark(algorithm->title());
    };
    QObject::connect(algorithm, &AlgorithmPanel::titled, dock("algorithm"), showAlgorithm);
    showAlgorithm();
}

void Panels::showResult(const app::Session& session, const QString& time,
                        std::size_t differing) const
{
    Dock* const dock = docks.named({"algorithm"}).front();
    if (session.windows().list.empty()) // nothing is cut
        return dock->setValue({});
    const bool good = differing == 0;
    const QString many = differing > app::mostDiffering
                             ? Text::tr("over %1 differ").arg(app::countText(app::mostDiffering))
                             : Text::tr("%1 differ").arg(app::countText(differing));
    QStringList said;
    if (!good)
        said << many;
    if (!time.isEmpty())
        said << time;
    dock->setValue({said.join(QStringLiteral(", ")), good ? "tick" : "warning",
                    good ? &Look::good : &Look::differs});
}

} // namespace ui

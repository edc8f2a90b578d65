// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panels.h"

#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/cut_options.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/exactness_panel.h"
#include "ui/docks/history_panel.h"
#include "ui/docks/layers_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/docks/selection_panel.h"
#include "ui/docks/start_panel.h"
#include "ui/docks/window_panel.h"
#include "ui/look/text.h"
#include "ui/style/style_panel.h"

namespace ui {

Panels::Panels(app::Session& session, Canvas& canvas)
    : start(new StartPanel), algorithm(new AlgorithmPanel(session)),
      window(new WindowPanel(session)), selection(new SelectionPanel(session)),
      style(new StylePanel(session, canvas)), line(new LinePanel(session)),
      layers(new LayersPanel(session)), history(new HistoryPanel(session.history)),
      compare(new ComparePanel(session)), difference(new DifferencePanel(session)),
      costMap(new CostMapPanel(session)), exactness(new ExactnessPanel(session)),
      docks{
          .start = new Dock("start", Text::tr("Start"), start),
          .algorithm = new Dock("algorithm", Text::tr("Algorithm"), algorithm),
          .narrow = {new Dock("window", Text::tr("Clip windows"), withCutOptions(*window, session)),
                     new Dock("selection", Text::tr("Selection"), selection),
                     new Dock("style", Text::tr("Style"), style),
                     new Dock("line", Text::tr("Line"), line),
                     new Dock("layers", Text::tr("Layers"), layers),
                     new Dock("history", Text::tr("History"), history)},
          .wide = {new Dock("compare", Text::tr("Compare"), compare),
                   new Dock("difference", Text::tr("Differences"), difference),
                   new Dock("cost-map", Text::tr("Cost map"), costMap),
                   new Dock("exactness", Text::tr("Exactness"), exactness)}}
{
    Dock* const lineDock = docks.named({"line"}).front();
    QObject::connect(line, &LinePanel::titled, lineDock,
                     [dock = lineDock](const QString& title, const QString& remark) {
                         dock->setRemark(remark);
                         dock->setName(title);
                     });
    QObject::connect(selection, &SelectionPanel::titled, docks.named({"selection"}).front(),
                     &Dock::setRemark);
    QObject::connect(style, &StylePanel::titled, docks.named({"style"}).front(), &Dock::setRemark);
    QObject::connect(algorithm, &AlgorithmPanel::titled, docks.algorithm, &Dock::setFoldedRemark);
    docks.algorithm->setFoldedRemark(algorithm->title());
    QObject::connect(algorithm, &AlgorithmPanel::remarked, docks.algorithm, &Dock::setRemark);
    QObject::connect(docks.wide.front(), &QDockWidget::visibilityChanged, compare,
                     &ComparePanel::setWatched);
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/cost_map_panel.h"

#include "app/base/text.h"
#include "app/cost_map/files.h"
#include "app/cost_map/words.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tool_list.h"
#include "ui/widgets/variant_box.h"

#include <QGridLayout>
#include <QMenu>
#include <QToolButton>

#include <array>

namespace ui {

namespace {

constexpr std::array cheapestForms{clipping::Form::Corrected, clipping::Form::Published};

} // namespace

CostMapPanel::CostMapPanel(const app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), plan_(app::usualCostPlan(session.window())),
      algorithm_(
          new VariantBox(Text::tr("Algorithm"), {Text::tr("Cheapest algorithm, corrected"),
                                                 Text::tr("Cheapest algorithm, as published")})),
      measure_(new ToolList),
      end_(new Segments(Text::tr("Fixed end"), {Text::tr("End 1"), Text::tr("End 2")})),
      view_(new CostMapView), words_(new QLabel), notes_(new QLabel),
      questions_(std::make_unique<Questions>(*this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::dockMargin, 6, space::dockMargin, 8);
    column->setSpacing(6);
    addChoosers();
    addMap();
    connect(&live_, &app::LiveCostMap::changed, this, &CostMapPanel::follow);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &CostMapPanel::followWindow);
    connect(&session, &app::Session::previewChanged, &soon_, qOverload<>(&QTimer::start));
    choose();
}

void CostMapPanel::addChoosers()
{
    algorithm_->choose(*plan_.shown);
    for (const app::CostMeasure& measure : app::costMeasures())
        measure_->addItem(measure.name);
    measure_->setAccessibleName(Text::tr("Measure"));
    auto* exports = new QToolButton;
    exports->setObjectName(QStringLiteral("export-cost-map"));
    exports->setIcon(icon("export"));
    exports->setToolTip(Text::tr("Export the cost map"));
    exports->setAccessibleName(exports->toolTip());
    exports->setAutoRaise(true);
    exports->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(exports);
    for (const app::CostMapFormat& format : app::costMapFormats()) {
        const QString key = app::latin(format.key);
        auto* action = menu->addAction(Text::tr("%1…").arg(format.name));
        action->setObjectName(QStringLiteral("export-cost-map-") + key);
        connect(action, &QAction::triggered, this, [this, key] { exportAs(key); });
    }
    exports->setMenu(menu);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    grid->addWidget(quietLabel(Text::tr("Show")), 0, 0);
    grid->addWidget(algorithm_, 0, 1, 1, 2);
    grid->addWidget(exports, 0, 3);
    grid->addWidget(quietLabel(Text::tr("Measure")), 1, 0);
    grid->addWidget(measure_, 1, 1);
    auto* fixed = new QHBoxLayout;
    fixed->setSpacing(space::labelToField);
    fixed->addWidget(quietLabel(Text::tr("Fixed")));
    fixed->addWidget(end_);
    grid->addLayout(fixed, 1, 2, 1, 2, Qt::AlignRight);
    grid->setColumnStretch(1, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    connect(algorithm_, &QComboBox::currentIndexChanged, this, &CostMapPanel::choose);
    connect(measure_, &QComboBox::currentIndexChanged, this, &CostMapPanel::choose);
    connect(end_, &Segments::picked, this, &CostMapPanel::choose);
    for (const ToolList* list : {static_cast<ToolList*>(algorithm_), measure_})
        connect(list, &ToolList::done, this, &CostMapPanel::entered);
}

void CostMapPanel::addMap()
{
    words_->setAccessibleName(Text::tr("Cost under the pointer"));
    words_->setFont(semiBold(font()));
    words_->setWordWrap(true);
    notes_->setWordWrap(true);
    notes_->setFont(captionFont(font()));
    notes_->setForegroundRole(QPalette::PlaceholderText);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addWidget(words_);
    column->addWidget(view_, 1);
    column->addWidget(notes_);
    auto* page = new PageCaption(session_, PageCaption::Elsewhere::AtThePage);
    page->setContentsMargins({});
    column->addWidget(page);
    connect(view_, &CostMapView::fixedEndMoved, this, [this](const app::Point& to) {
        plan_.fixed = to;
        ask();
        point(std::nullopt);
    });
    connect(view_, &CostMapView::dropped, this, [this] { view_->update(); });
    connect(view_, &CostMapView::resized, this, &CostMapPanel::ask);
    connect(view_, &CostMapView::pointed, this, &CostMapPanel::point);
}

void CostMapPanel::choose()
{
    plan_.measure = &app::costMeasures()[std::size_t(measure_->currentIndex())];
    plan_.shown = algorithm_->variant();
    plan_.variants =
        app::costVariants(plan_.shown ? clipping::Form::Corrected
                                      : cheapestForms[std::size_t(algorithm_->currentIndex())]);
    plan_.end = end_->chosen() == 1 ? app::FixedEnd::End2 : app::FixedEnd::End1;
    ask();
    point(std::nullopt);
}

// Moves the fixed end with the window.
void CostMapPanel::followWindow()
{
    soon_.stop();
    const clipping::Window& window = session_.window();
    if (window == plan_.window)
        return;
    const app::Point share = (plan_.fixed - plan_.area.min) / (plan_.area.max - plan_.area.min);
    plan_.window = window;
    plan_.area = app::areaAround(window);
    plan_.fixed = plan_.area.min + (plan_.area.max - plan_.area.min) * share;
    if (!isVisible())
        return; // showEvent() will ask
    ask();
    point(std::nullopt);
}

void CostMapPanel::ask()
{
    const QSize cells = view_->cells(plan_);
    plan_.columns = cells.width();
    plan_.rows = cells.height();
    if (isVisible())
        live_.ask(plan_);
    follow();
}

void CostMapPanel::follow() { view_->show(plan_, live_.map()); }

void CostMapPanel::point(const std::optional<app::Point>& at)
{
    notes_->setText(app::noteOf(*plan_.measure));
    notes_->setVisible(!notes_->text().isEmpty());
    if (at && isVisible())
        words_->setText(app::costWords(plan_, *at));
    else
        words_->setText(
            Text::tr("The dot is the fixed end. Drag it, or move it with the arrow keys."));
}

std::optional<QString> CostMapPanel::exportTo(const QString& path)
{
    followWindow();
    live_.finish();
    const app::CostMap map =
        live_.map() && live_.upToDate() && live_.asked() ? *live_.map() : app::costMap(plan_);
    return app::writeCostMap(map, path, app::costMapLook(groundOf(palette())));
}

void CostMapPanel::setQuestions(std::unique_ptr<Questions> questions)
{
    questions_ = std::move(questions);
}

void CostMapPanel::exportAs(const QString& key)
{
    const auto* format = app::kindOf(app::costMapFormats(), key);
    const QString path = questions_->fileToWrite(
        Text::tr("Export the cost map"), QStringLiteral("cost-map.") + key, format->name, key);
    if (path.isEmpty())
        return;
    if (const auto error = exportTo(path))
        emit told({Message::Kind::Warning, *error});
    else
        emit told({Message::Kind::Done, Text::tr("Wrote %1.").arg(path)});
}

void CostMapPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    followWindow();
    ask();
    point(std::nullopt);
}

void CostMapPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    live_.ask(std::nullopt);
}

} // namespace ui

#include "moc_cost_map_panel.cpp"

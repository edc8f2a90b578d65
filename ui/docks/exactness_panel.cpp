// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/exactness_panel.h"

#include "app/base/numbers.h"
#include "app/comparison/live_differences.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/magnifier_view.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/variant_box.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QToolButton>

namespace ui {

namespace {

QHBoxLayout* within()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    row->setSpacing(space::labelToField);
    return row;
}

} // namespace

ExactnessPanel::ExactnessPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(session),
      algorithm_(new VariantBox(Text::tr("Algorithm"), {Text::tr("The current algorithm")})),
      errorUnit_(new Segments(Text::tr("Ulps of"),
                              {Text::tr("largest coordinate"), Text::tr("own coordinate")})),
      end_(new Segments(Text::tr("End"), {Text::tr("End 1"), Text::tr("End 2")})),
      lattice_(new Segments(Text::tr("Numbers"), {Text::tr("doubles"), Text::tr("floats")})),
      summary_(new LookLabel), heading_(new QLabel), magnified_(new QLabel),
      histogram_(new ErrorHistogram), table_(new DenseTable), magnifier_(new Magnifier),
      pages_(new QStackedWidget)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(6);
    addChoosers();
    pages_->addWidget(listPage());
    pages_->addWidget(magnifierPage());
    column->addWidget(pages_, 1);
    soon_.setSingleShot(true);
    soon_.setInterval(0);
    connect(&soon_, &QTimer::timeout, this, &ExactnessPanel::follow);
    connect(&session.exactness, &app::LiveExactness::changed, &soon_, qOverload<>(&QTimer::start));
    connect(&session.exactness, &app::LiveExactness::progressed, this,
            &ExactnessPanel::paintSummary);
    connect(&session, &app::Session::displayChanged, this, [this] {
        if (isVisible())
            ask();
    });
    follow();
}

void ExactnessPanel::addChoosers()
{
    auto* grid = new QGridLayout;
    grid->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    grid->addWidget(quietLabel(Text::tr("Algorithm")), 0, 0);
    grid->addWidget(algorithm_, 0, 1);
    grid->addWidget(quietLabel(Text::tr("Ulps of")), 1, 0);
    grid->addWidget(errorUnit_, 1, 1, Qt::AlignLeft);
    grid->setColumnStretch(1, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    errorUnit_->setToolTip(
        Text::tr("One ulp is one unit in the last place of a number. The library's contract counts "
                 "those of the largest coordinate of line and clip window. The other choice counts "
                 "those of the wrong coordinate."));
    connect(algorithm_, &VariantBox::currentIndexChanged, this, &ExactnessPanel::ask);
    connect(algorithm_, &VariantBox::done, this, &ExactnessPanel::entered);
    connect(errorUnit_, &Segments::picked, this, &ExactnessPanel::ask);
}

QWidget* ExactnessPanel::listPage()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    summary_->setWordWrap(true);
    summary_->setAccessibleName(Text::tr("Exactness"));
    auto* sentence = within();
    sentence->addWidget(summary_);
    auto* bars = within();
    bars->addWidget(histogram_);
    table_->setModel(&model_);
    keepChoice(*table_);
    table_->setAccessibleName(Text::tr("Lines, the worst first"));
    table_->setSortingEnabled(true);
    table_->sortByColumn(2, Qt::DescendingOrder);
    table_->setMinimumHeight(space::dockTitleHeight + 3 * space::denseRowHeight);
    table_->setColumnWidth(1, 220);
    auto* hint = quietLabel(Text::tr("Double click or Enter: magnify the worse end."));
    hint->setFont(captionFont(font()));
    auto* below = within();
    below->addWidget(hint);
    column->addLayout(sentence);
    column->addWidget(new PageCaption(session_));
    column->addLayout(bars);
    column->addWidget(table_, 1);
    column->addLayout(below);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (!following_ && now.isValid())
                    showRow(now.row());
            });
    connect(table_, &QTableView::activated, this,
            [this](const QModelIndex& index) { magnifyRow(index.row()); });
    connect(table_, &QTableView::doubleClicked, this,
            [this](const QModelIndex& index) { magnifyRow(index.row()); });
    return page;
}

QWidget* ExactnessPanel::magnifierPage()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(space::dockMargin, 0, space::dockMargin, 8);
    column->setSpacing(6);
    auto* back = new QToolButton;
    back->setObjectName(QStringLiteral("leave-magnifier"));
    back->setIcon(icon("step-back"));
    back->setToolTip(Text::tr("Return to the list (Esc)"));
    back->setAccessibleName(back->toolTip());
    back->setAutoRaise(true);
    auto* row = new QHBoxLayout;
    row->setSpacing(space::labelToField);
    row->addWidget(back);
    row->addWidget(heading_);
    row->addWidget(end_);
    row->addStretch();
    row->addWidget(lattice_);
    auto* hint =
        quietLabel(Text::tr("Wheel, +, −, Page Up, Page Down: zoom. Home: reset the zoom."));
    hint->setFont(captionFont(font()));
    magnified_->setWordWrap(true);
    magnified_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addLayout(row);
    column->addWidget(magnifier_, 1);
    column->addWidget(magnified_);
    column->addWidget(hint);
    connect(back, &QToolButton::clicked, this, &ExactnessPanel::leaveMagnifier);
    connect(end_, &Segments::picked, this, &ExactnessPanel::showEnd);
    connect(lattice_, &Segments::picked, this, [this](int index) {
        magnifier_->setLattice(index == 0 ? app::Lattice::Double : app::Lattice::Single);
    });
    return page;
}

app::LiveExactness::Question ExactnessPanel::wanted() const
{
    const app::Display& display = session_.display();
    const app::Variant clipping = usable(display.variant);
    return {algorithm_->variant().value_or(clipping),
            errorUnit_->chosen() == 1 ? app::ErrorUnit::Own : app::ErrorUnit::Largest};
}

void ExactnessPanel::ask()
{
    if (isVisible())
        session_.exactness.ask(wanted());
}

// A timer fires after all posted events, so the pending frame is shown first.
void ExactnessPanel::follow()
{
    const QScopedValueRollback quietly(following_, true);
    soon_.stop();
    model_.follow();
    histogram_->show(session_.exactness.counts());
    paintSummary();
    const auto line = session_.inspected();
    const int row = line ? model_.rowOf(*line) : -1;
    if (row >= 0)
        table_->setCurrentIndex(model_.index(row, 0));
    if (magnifies())
        line_ < session_.scene.lines().size() ? showEnd() : leaveMagnifier();
}

void ExactnessPanel::paintSummary()
{
    const app::LiveExactness& exactness = session_.exactness;
    const bool here = session_.compared().comparable;
    const bool known = here && exactness.asked() && exactness.upToDate();
    const bool wrong = known && exactness.counts().classes.back() > 0;
    summary_->setText(!here   ? Text::tr("Not judged here.")
                      : known ? app::sentence(exactness.asked()->variant, exactness.counts(),
                                              exactness.asked()->errorUnit)
                              : Text::tr("Judging %1… %2")
                                    .arg(app::linesText(session_.scene.lines().size()),
                                         app::percentText(exactness.progress())));
    summary_->setColour(wrong ? &Look::differs : known ? &Look::text : &Look::muted);
}

void ExactnessPanel::showRow(int row)
{
    const app::LineExactness* exactness = model_.exactnessOf(row);
    if (!exactness)
        return;
    const std::size_t line = exactness->source;
    session_.inspect(line);
    emit placeWanted(
        app::placeOf({wanted().variant}, session_.scene.lines()[line], session_.window()));
}

void ExactnessPanel::magnifyRow(int row)
{
    const app::LineExactness* exactness = model_.exactnessOf(row);
    if (exactness)
        magnify(exactness->source, exactness->ends[1].ulps > exactness->ends[0].ulps ? 1 : 0);
}

void ExactnessPanel::magnify(std::size_t line, int end)
{
    line_ = line;
    end_->choose(end);
    heading_->setText(Text::tr("Line %1").arg(app::countText(line + 1)));
    pages_->setCurrentIndex(1);
    showEnd();
    magnifier_->setFocus();
}

void ExactnessPanel::showEnd()
{
    const app::Variant variant = wanted().variant;
    const auto seen =
        app::magnified(variant, session_.scene.lines()[line_], session_.window(), end_->chosen());
    magnifier_->setVisible(seen.has_value());
    if (!seen)
        return magnified_->setText(
            Text::tr("There is nothing to magnify: %1 keeps no part of this line, "
                     "or an end is not a number.")
                .arg(app::nameOf(variant)));
    magnifier_->show(*seen, app::nameOf(variant));
    magnified_->setText(app::magnifiedText(*seen, app::nameOf(variant)));
}

void ExactnessPanel::leaveMagnifier()
{
    pages_->setCurrentIndex(0);
    table_->setFocus();
}

/// Room for about ten rows.
QSize ExactnessPanel::sizeHint() const
{
    return {QWidget::sizeHint().width(), 320 + 10 * space::denseRowHeight};
}

void ExactnessPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    ask();
    follow();
}

void ExactnessPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    session_.exactness.ask(std::nullopt);
}

void ExactnessPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && magnifies())
        return leaveMagnifier();
    QWidget::keyPressEvent(event);
}

} // namespace ui

#include "moc_exactness_panel.cpp"

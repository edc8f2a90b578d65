// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/difference_panel.h"

#include "app/base/numbers.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/variant_box.h"

#include <QGridLayout>
#include <QScopedValueRollback>
#include <QToolButton>

#include <cmath>

namespace ui {

namespace {

constexpr int asInContract = -1; // value of the ulps box for "as in the contract", below all others
constexpr int mostUlps = 1'000'000;
constexpr int mostColumnWidth = 260;

/// Published KWC loses lines, so the first comparison shows differences.
app::Variant firstA()
{
    return {clipping::findAlgorithm("kodituwakku-wijeweera-chamikara"), clipping::Form::Published};
}

} // namespace

DifferencePanel::DifferencePanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), model_(session), a_(new VariantBox(Text::tr("A"))),
      b_(new VariantBox(Text::tr("B"))), ulps_(new QSpinBox), tick_(new IconSign("tick", 16)),
      summary_(new LookLabel), explanation_(new LookLabel), position_(quietLabel({})),
      previous_(iconButton("step-back", Text::tr("Previous difference"))),
      next_(iconButton("step-on", Text::tr("Next difference"))), table_(new DenseTable)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    setKeyTip(*previous_, Text::tr("Previous difference ({previous-difference})"));
    setKeyTip(*next_, Text::tr("Next difference ({next-difference})"));
    column->setSpacing(6);
    setBoth(firstA(), app::exactVariant());
    addChoosers();
    addTable();
    soon_.setSingleShot(true);
    soon_.setInterval(0);
    connect(&soon_, &QTimer::timeout, this, &DifferencePanel::follow);
    connect(&session.differences, &app::LiveDifferences::changed, &soon_,
            qOverload<>(&QTimer::start));
    connect(&session, &app::Session::displayChanged, &soon_, qOverload<>(&QTimer::start));
    connect(&session, &app::Session::inspectedChanged, this, &DifferencePanel::paintPosition);
    connect(&model_, &QAbstractItemModel::modelReset, this, &DifferencePanel::paintPosition);
    connect(&session.differences, &app::LiveDifferences::begun, this,
            &DifferencePanel::paintSummary);
    follow();
}

void DifferencePanel::addChoosers()
{
    ulps_->setRange(asInContract, mostUlps);
    ulps_->setAccessibleName(Text::tr("Ulps by which ends may differ"));
    ulps_->setToolTip(Text::tr(
        "Ends that differ by no more than this count as equal. One ulp is one unit in the last "
        "place of the largest coordinate of the line and the clip window."));
    ulps_->setValue(asInContract);
    auto* exchange = new QToolButton;
    exchange->setObjectName(QStringLiteral("swap-comparison"));
    exchange->setIcon(icon("swap"));
    exchange->setAutoRaise(true);
    exchange->setToolTip(Text::tr("Swap A and B"));
    exchange->setAccessibleName(exchange->toolTip());
    auto* grid = new QGridLayout;
    grid->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    grid->addWidget(quietLabel(Text::tr("A")), 0, 0);
    grid->addWidget(a_, 0, 1, 1, 2);
    grid->addWidget(exchange, 0, 3, 2, 1);
    grid->addWidget(quietLabel(Text::tr("B")), 1, 0);
    grid->addWidget(b_, 1, 1, 1, 2);
    auto* allowed = new QHBoxLayout;
    allowed->setSpacing(space::labelToField);
    allowed->addWidget(quietLabel(Text::tr("Ends may differ by")));
    allowed->addWidget(ulps_);
    allowed->addStretch();
    grid->addLayout(allowed, 2, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    connect(a_, &VariantBox::currentIndexChanged, this, &DifferencePanel::change);
    connect(b_, &VariantBox::currentIndexChanged, this, &DifferencePanel::change);
    for (const VariantBox* list : {a_, b_})
        connect(list, &VariantBox::done, this, &DifferencePanel::entered);
    connect(ulps_, &QSpinBox::valueChanged, this, &DifferencePanel::ask);
    connect(exchange, &QToolButton::clicked, this, &DifferencePanel::swap);
}

void DifferencePanel::addTable()
{
    summary_->setWordWrap(true);
    summary_->setAccessibleName(Text::tr("Differences"));
    explanation_->setWordWrap(true);
    explanation_->setSheet([](const Look& look) {
        return QStringLiteral("color: %1; background: %2; border-radius: 3px")
            .arg(look.warning.name(), look.warningGround.name());
    });
    explanation_->setFont(captionFont(font()));
    explanation_->setContentsMargins(space::labelToField, 6, space::labelToField, 6);
    auto* found = new QHBoxLayout;
    found->setContentsMargins(space::dockMargin, 2, space::dockMargin, 2);
    found->setSpacing(6);
    found->addWidget(tick_, 0, Qt::AlignTop);
    found->addWidget(summary_, 1);
    for (QWidget* part : {static_cast<QWidget*>(position_), static_cast<QWidget*>(previous_),
                          static_cast<QWidget*>(next_)})
        found->addWidget(part, 0, Qt::AlignTop);
    connect(previous_, &QToolButton::clicked, this, [this] { go(-1); });
    connect(next_, &QToolButton::clicked, this, [this] { go(1); });
    auto* margins = new QHBoxLayout;
    margins->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    margins->addWidget(explanation_);
    table_->setModel(&model_);
    keepChoice(*table_);
    table_->setAccessibleName(Text::tr("Lines that differ"));
    table_->setSortingEnabled(true);
    table_->sortByColumn(0, Qt::AscendingOrder);
    table_->setMinimumHeight(space::dockTitleHeight + 3 * space::denseRowHeight);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addLayout(margins);
    column->addLayout(found);
    column->addWidget(new PageCaption(session_));
    column->addWidget(table_, 1);
    column->addStretch();
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (!following_ && now.isValid())
                    showRow(now.row());
            });
    connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
        if (const auto line = model_.lineOf(index.row()))
            emit lineWanted(*line);
    });
    // A click on the current row shows it again, even if the view has moved.
    connect(table_, &QTableView::clicked, this,
            [this](const QModelIndex& index) { showRow(index.row()); });
}

app::Comparison DifferencePanel::wanted() const
{
    app::Comparison comparison{*a_->variant(), *b_->variant()};
    if (ulps_->value() != asInContract)
        comparison.ulps = ulps_->value();
    return comparison;
}

void DifferencePanel::ask()
{
    if (following_)
        return;
    session_.differences.ask(wanted());
    if (soon_.isActive())
        follow(); // the person's own change is answered at once
}

/// Another comparison differs on other lines, so the inspected difference is closed.
void DifferencePanel::change()
{
    if (following_)
        return;
    if (const auto line = session_.inspected(); line && model_.rowOf(*line) >= 0)
        session_.inspect(std::nullopt);
    ask();
}

void DifferencePanel::setBoth(const app::Variant& a, const app::Variant& b)
{
    const QScopedValueRollback together(following_, true);
    a_->choose(a);
    b_->choose(b);
}

void DifferencePanel::compare(const app::Variant& a, const app::Variant& b)
{
    setBoth(a, b);
    change();
}

void DifferencePanel::swap()
{
    setBoth(*b_->variant(), *a_->variant());
    ask();
}

// A timer fires after all posted events, so the pending frame is shown first.
void DifferencePanel::follow()
{
    const QScopedValueRollback quietly(following_, true);
    soon_.stop();
    model_.follow();
    const app::Comparison comparison = wanted();
    const double contract = app::contractUlps(comparison.a, comparison.b);
    const int decimals = contract == std::floor(contract) ? 0 : 1;
    ulps_->setSpecialValueText(
        Text::tr("%1 ulps, as in the contract").arg(app::numberText(contract, decimals)));
    ulps_->setSuffix(ulps_->value() == 1 ? Text::tr(" ulp") : Text::tr(" ulps"));
    QStringList wrong;
    for (const app::Variant& variant : {comparison.a, comparison.b})
        if (variant.misprint && !wrong.contains(variant.misprint->whatIsWrong))
            wrong << variant.misprint->whatIsWrong;
    explanation_->setText(wrong.join(u'\n'));
    explanation_->setVisible(!wrong.isEmpty());
    keepWhole();
    table_->setVisible(model_.rowCount() > 0);
    paintSummary();
    fitColumns();
    const auto line = session_.inspected();
    choose(line ? model_.rowOf(*line) : -1);
}

/// Fits the columns to the first results of a comparison at a window; they then stay, also while
/// the window moves.
void DifferencePanel::fitColumns()
{
    const Fitting shown{wanted(), session_.compared().number, session_.display().unit};
    if (model_.rowCount() == 0 || fittedTo_ == shown)
        return;
    fittedTo_ = shown;
    for (int column = 0; column < model_.columnCount(); ++column) {
        table_->resizeColumnToContents(column);
        table_->setColumnWidth(column, std::min(table_->columnWidth(column), mostColumnWidth));
    }
    // Only the first rows are measured, and the numbers of lines below them are longer.
    constexpr int besideNumber = 16;
    const QString most = app::countText(session_.scene.lines().size());
    table_->setColumnWidth(0, std::max(table_->columnWidth(0),
                                       table_->fontMetrics().horizontalAdvance(most)
                                           + besideNumber));
}

/// In a low panel the table gives way, not a sentence.
void DifferencePanel::keepWhole()
{
    const int across = std::max(1, width() - 2 * space::dockMargin);
    explanation_->setMinimumHeight(std::max(0, explanation_->heightForWidth(across)));
}

void DifferencePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    keepWhole();
}

void DifferencePanel::fitColumnsAnew()
{
    fittedTo_.reset();
    fitColumns();
}

void DifferencePanel::paintSummary()
{
    const app::LiveDifferences& live = session_.differences;
    const app::Comparison comparison = wanted();
    const bool differ = !live.found().list.empty();
    const bool here = session_.compared().comparable;
    const bool known = here && live.asked() && live.upToDate();
    const bool good = known && !differ && live.found().lines > 0 && comparison.a != comparison.b;
    summary_->setText(
        !here    ? Text::tr("Not compared here.")
        : !known ? Text::tr("Comparing %1…").arg(app::linesText(session_.scene.lines().size()))
                 : app::sentence(comparison.a, comparison.b, app::counted(live.found().list),
                                 live.found().lines)
                       + u'.');
    summary_->setFont(known && differ ? semiBold(font()) : font());
    const auto colour = !known || (!good && !differ) ? &Look::muted
                        : good                       ? &Look::good
                                                     : &Look::differs;
    summary_->setColour(colour);
    for (QToolButton* step : {previous_, next_})
        step->setVisible(known && differ);
    paintPosition();
    tick_->setVisible(known && (good || differ));
    tick_->show(good ? "tick" : "warning", colour);
}

/// In the order of the list, as it is sorted.
void DifferencePanel::paintPosition()
{
    const int row = session_.inspected() ? model_.rowOf(*session_.inspected()) : -1;
    position_->setText(row < 0 ? QString()
                               : Text::tr("%1 of %2", "a difference, and how many there are")
                                     .arg(app::countText(std::size_t(row) + 1),
                                          app::countText(std::size_t(model_.rowCount()))));
}

void DifferencePanel::showRow(int row)
{
    const auto line = model_.lineOf(row);
    if (!line)
        return;
    session_.inspect(*line);
    emit placeWanted(app::placeOf(wanted(), session_.scene.lines()[*line], session_.window()));
}

void DifferencePanel::choose(int row)
{
    const QScopedValueRollback quietly(following_, true);
    if (row < 0)
        return table_->selectionModel()->clear();
    table_->setCurrentIndex(model_.index(row, 0));
}

void DifferencePanel::go(int rows)
{
    session_.differences.ask(wanted());
    session_.differences.finish();
    if (soon_.isActive())
        follow();
    const int count = model_.rowCount();
    if (count == 0)
        return;
    const int now = session_.inspected() ? model_.rowOf(*session_.inspected()) : -1;
    const int next = now < 0 ? (rows > 0 ? 0 : count - 1) : ((now + rows) % count + count) % count;
    choose(next);
    showRow(next);
}

/// Room for about twenty rows.
QSize DifferencePanel::sizeHint() const
{
    return {QWidget::sizeHint().width(),
            table_->y() + space::dockTitleHeight + 20 * space::denseRowHeight};
}

void DifferencePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    ask();
    follow();
}

void DifferencePanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    session_.differences.ask(std::nullopt);
}

} // namespace ui

#include "moc_difference_panel.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/charts_page.h"

#include "ui/look/look.h"
#include "ui/widgets/chart_view.h"

#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int widest = 920;

} // namespace

ChartsPage::ChartsPage(QWidget* parent) : QScrollArea(parent)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);                       // its charts have it
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // because heights depend on the width
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setBackgroundRole(QPalette::Base);
    auto* body = new QWidget;
    body->setBackgroundRole(QPalette::Base);
    column_ = new QVBoxLayout(body);
    column_->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                                space::betweenGroups);
    column_->setSpacing(24);
    column_->addStretch();
    setWidget(body);
}

ChartView* ChartsPage::viewOf(app::Chart chart)
{
    auto* view = new ChartView;
    view->setMaximumWidth(widest);
    view->setChart(std::move(chart));
    connect(view, &ChartView::exportWanted, this,
            [this, view] { emit exportWanted(view->chart()); });
    return view;
}

void ChartsPage::show(std::vector<app::Chart> charts)
{
    qDeleteAll(views_);
    views_.clear();
    for (app::Chart& chart : charts) {
        views_ << viewOf(std::move(chart));
        column_->insertWidget(column_->count() - 1, views_.back());
    }
    verticalScrollBar()->setValue(0);
}

const app::Chart* ChartsPage::current() const
{
    const int top = verticalScrollBar()->value();
    const auto shown = std::ranges::find_if(
        views_, [top](const ChartView* view) { return view->geometry().center().y() >= top; });
    return shown == views_.end() ? nullptr : &(*shown)->chart();
}

} // namespace ui

#include "moc_charts_page.cpp"

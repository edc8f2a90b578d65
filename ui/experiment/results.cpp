// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/results.h"

#include "app/charts/study_charts.h"
#include "app/experiment/verdict.h"
#include "ui/experiment/charts_page.h"
#include "ui/experiment/tables_page.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/chart_view.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/segments.h"

#include <QHBoxLayout>
#include <QScrollBar>
#include <QVBoxLayout>

namespace ui {

namespace {

QLabel* sentences()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QStringList namesOf(const std::vector<app::Measure>& measures)
{
    QStringList names;
    for (const app::Measure& measure : measures)
        names << measure.name;
    return names;
}

/// A table of runs in the paper's layout ends with an average; other tables are sortable.
TableView::Rows rowsOf(const app::Table& table)
{
    return table.names.front() == u"algorithm" ? TableView::Rows::Sortable
                                               : TableView::Rows::SumIsLast;
}

} // namespace

Results::Results(const QList<QWidget*>& tools, QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout), trial_(new QComboBox),
      reasons_(new Segments(Text::tr("Explanation"),
                            {Text::tr("By class"), Text::tr("Operations"), Text::tr("Accuracy")})),
      age_(new QLabel(Text::tr("Results of the previous run"))), verdict_(sentences()),
      reason_(sentences()), summary_(new QScrollArea), tabs_(new QTabWidget),
      charts_(new ChartsPage), reasonChart_(new ChartView), tables_(new TablesPage),
      why_(new TablesPage), circumstances_(new TablesPage)
{
    trial_->setAccessibleName(Text::tr("Result"));
    trial_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    verdict_->setAccessibleName(Text::tr("Verdict"));
    row_->setSpacing(space::labelToField);
    row_->addWidget(trial_);
    row_->addStretch();
    row_->addWidget(age_);
    age_->setObjectName(QStringLiteral("age"));
    age_->setFont(semiBold(age_->font()));
    age_->hide();
    summary_->setFrameShape(QFrame::NoFrame);
    summary_->setWidgetResizable(true);
    summary_->setFocusPolicy(Qt::NoFocus); // there is nothing to do in it
    summary_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    summary_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // else lines break by its past
    summary_->setWidget(verdict_);
    verdict_->setTextFormat(Qt::RichText);
    verdict_->setAlignment(Qt::AlignTop);
    reserveRoom();
    addPages(tools);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* top = new QVBoxLayout;
    top->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                            space::dockMargin);
    top->setSpacing(space::labelToField);
    top->addLayout(row_);
    top->addWidget(summary_);
    column->addLayout(top);
    column->addWidget(tabs_, 1);
    new LanguageFollower(*this, [this] {
        if (study_)
            show(study_);
    });
    connect(trial_, &QComboBox::currentIndexChanged, this, &Results::showTrial);
    connect(reasons_, &Segments::picked, this, &Results::showReasons);
    connect(tabs_, &QTabWidget::currentChanged, this, &Results::tabChanged);
    connect(charts_, &ChartsPage::exportWanted, this, &Results::exportWanted);
    connect(reasonChart_, &ChartView::exportWanted, this,
            [this] { emit exportWanted(reasonChart_->chart()); });
}

void Results::addPages(const QList<QWidget*>& tools)
{
    auto* top = new QWidget;
    auto* column = new QVBoxLayout(top);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(space::labelToField);
    column->addWidget(reasons_, 0, Qt::AlignLeft);
    column->addWidget(reason_);
    reasonChart_->setMaximumWidth(920);
    column->addWidget(reasonChart_);
    why_->setTop(top);
    auto* corner = new QWidget;
    auto* row = new QHBoxLayout(corner);
    row->setContentsMargins(0, 0, space::betweenGroups, 4);
    row->setSpacing(space::labelToField);
    for (QWidget* tool : tools)
        row->addWidget(tool);
    tabs_->setCornerWidget(corner);
    tabs_->setDocumentMode(true);
    tabs_->addTab(tables_, Text::tr("&Tables"));
    tabs_->addTab(charts_, Text::tr("C&harts"));
    tabs_->addTab(why_, Text::tr("&Why"));
    tabs_->addTab(circumstances_, Text::tr("C&ircumstances"));
}

void Results::show(std::shared_ptr<const app::Study> study)
{
    study_ = std::move(study);
    age_->hide();
    verdict_->setEnabled(true);
    summary_->verticalScrollBar()->setValue(0);
    const QSignalBlocker quiet(trial_);
    trial_->clear();
    for (const app::Trial& trial : study_->trials)
        trial_->addItem(app::nameOf(trial));
    showMeasures();
    showTrial();
    const int why = tabs_->indexOf(why_);
    tabs_->setTabEnabled(why, study_->explanation.has_value());
    tabs_->setTabToolTip(
        why,
        study_->explanation
            ? QString()
            : Text::tr(
                "There is no explanation of this run. Tick “Explain the times” and run again."));
    if (study_->explanation)
        showReasons();
    circumstances_->show({{app::circumstancesTable(*study_), TableView::Rows::Plain}});
}

/// Recreates the measures' buttons; a study with drawn lines has more measures.
void Results::showMeasures()
{
    const int chosen = measures_ ? measures_->chosen() : 0;
    delete measures_;
    measures_ = new Segments(Text::tr("Measure"), namesOf(study_->measures));
    measures_->choose(std::min(chosen, int(study_->measures.size()) - 1));
    row_->insertWidget(1, measures_);
    setTabOrder(trial_, measures_);
    connect(measures_, &Segments::picked, this, &Results::showTrial);
}

const app::Trial& Results::trial() const
{
    return study_->trials[std::size_t(std::max(0, trial_->currentIndex()))];
}

const app::Measure& Results::measure() const
{
    return study_->measures[std::size_t(measures_->chosen())];
}

void Results::showTrial()
{
    std::vector<TablesPage::Entry> entries;
    for (app::Table& table : app::tablesOf(trial(), measure(), app::Against::Paper))
        entries.push_back({table, rowsOf(table)});
    if (trial().paper) {
        entries.push_back({app::paperLayout(*trial().paper), TableView::Rows::SumIsLast});
        entries.push_back({app::timesTable(trial().record, measure()), TableView::Rows::Sortable});
    }
    showVerdict();
    tables_->show(std::move(entries));
    charts_->show(app::chartsOf(trial(), measure()));
}

/// Shows the verdict sentences of the current measure, which begin with its name.
void Results::showVerdict()
{
    QString text;
    for (const QString& sentence : app::verdict(trial(), study_->measures)) {
        QString marked = sentence.toHtmlEscaped();
        for (const app::Measure& measure : study_->measures)
            if (sentence.startsWith(measure.name + u':'))
                marked.replace(0, measure.name.size() + 1,
                               QStringLiteral("<b>%1:</b>").arg(measure.name));
        text += QStringLiteral("<p style='margin:0 0 4px 0'>%1</p>").arg(marked);
    }
    verdict_->setText(text);
}

void Results::showReasons()
{
    auto tables = app::tablesOf(*study_->explanation);
    const app::Table& table = tables[std::size_t(reasons_->chosen())];
    reason_->setText(app::reasons(*study_->explanation)[reasons_->chosen()]);
    why_->show({{table, TableView::Rows::Sortable}});
    auto charts = app::chartsOf(*study_->explanation);
    const auto chart = std::ranges::find_if( // there is no chart of accuracy
        charts, [&](const app::Chart& one) { return one.key.endsWith(table.key); });
    reasonChart_->setVisible(chart != charts.end());
    if (chart != charts.end())
        reasonChart_->setChart(std::move(*chart));
}

void Results::markOld()
{
    age_->show();
    verdict_->setEnabled(false);
}

/// Gives the summary a fixed height, so that the tabs do not move; longer text scrolls.
void Results::reserveRoom()
{
    constexpr int least = 3, most = 9;
    const int line = verdict_->fontMetrics().lineSpacing();
    summary_->setFixedHeight(std::clamp(height() / 3, least * line, most * line));
}

void Results::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    reserveRoom();
}

const app::Table* Results::shownTable() const
{
    const auto* page = qobject_cast<TablesPage*>(tabs_->currentWidget());
    return study_ && page ? page->current() : nullptr;
}

const app::Chart* Results::shownChart() const
{
    return study_ && tabs_->currentWidget() == charts_ ? charts_->current() : nullptr;
}

void Results::copyTable() const
{
    if (const auto* page = qobject_cast<TablesPage*>(tabs_->currentWidget()))
        page->copy();
}

} // namespace ui

#include "moc_results.cpp"

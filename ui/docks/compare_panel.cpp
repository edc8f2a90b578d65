// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_panel.h"

#include "app/experiment/one_by_one.h"
#include "app/race/race_text.h"
#include "app/session/window_in_hand.h"
#include "app/session/window_words.h"
#include "app/settings/remembered.h"
#include "app/view/frame_times.h"
#include "ui/docks/compare_table.h"
#include "ui/docks/verdict_list.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/segments.h"

#include <QSettings>
#include <QVBoxLayout>

#include <array>

namespace ui {

namespace {

using clipping::Form;

constexpr int bothForms = 2; // else the number of a form, as remembered
constexpr std::array offered{bothForms, int(Form::Corrected), int(Form::Published)};
const char* const setting = "compareForms";
constexpr int updateMilliseconds = 500;
constexpr int usualLines = 8; // of the verdict, in about four paragraphs

std::vector<app::Variant> variantsOf(int forms)
{
    std::vector<const clipping::Algorithm*> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        all.push_back(&algorithm);
    return forms == bothForms ? app::variantsOf(all) : app::variantsOf(all, Form(forms));
}

QLabel* caption(const QFont& font)
{
    auto* label = new QLabel;
    label->setFont(captionFont(font));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

/// A marker and what it stands for.
QWidget* legend(Form form, const QString& words, const QFont& font)
{
    auto* part = new QWidget;
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(new IconSign(markerIcon({&clipping::exactAlgorithm(), form}), 14));
    QLabel* text = caption(font);
    text->setText(words);
    row->addWidget(text);
    return part;
}

/// The name of the one window at which not every algorithm can clip.
QString limitingAmong(std::span<const app::NamedNeeds> windows)
{
    QStringList names;
    for (const app::NamedNeeds& window : windows)
        if (window.needs > app::WindowNeeds::RotatedRectangle)
            names << window.name;
    return names.size() == 1 ? names.front() : QString();
}

} // namespace

ComparePanel::ComparePanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), race_(session.document, session.scene),
      forms_(new Segments(Text::tr("Forms"),
                          {Text::tr("Both forms"), Text::tr("Corrected"), Text::tr("Published")})),
      sort_(new QPushButton(Text::tr("Sort by time"))), table_(new CompareTable(session)),
      state_(caption(font())), field_(caption(font())), place_(caption(font())), page_(new QWidget),
      corrected_(legend(Form::Corrected, Text::tr("corrected"), font())),
      published_(legend(Form::Published, Text::tr("as published"), font())),
      verdict_(new VerdictList), verdictArea_(new VerdictArea(verdict_))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(choiceRow());
    auto* rows = new QHBoxLayout; // the table includes the gap after a text
    rows->setContentsMargins(0, 0, space::dockMargin - DenseTable::gap, 0);
    rows->addWidget(table_);
    column->addLayout(rows);
    column->addLayout(legendRow());
    place_->setContentsMargins(space::dockMargin, 2, space::dockMargin, 0);
    place_->setWordWrap(true);
    column->addWidget(place_);
    auto* page = new QVBoxLayout(page_);
    page->setContentsMargins(0, 2, 0, 0);
    page->addWidget(new PageCaption(session));
    column->addWidget(page_);
    column->addWidget(verdictArea_, 1);

    connect(forms_, &Segments::picked, this, [this](int index) {
        QSettings().setValue(setting, offered[std::size_t(index)]);
        chooseForms(offered[std::size_t(index)]);
    });
    connect(sort_, &QPushButton::clicked, table_, &CompareTable::sortByTime);
    pause_.setSingleShot(true);
    pause_.setInterval(updateMilliseconds);
    connect(&pause_, &QTimer::timeout, this, [this] {
        if (waiting_)
            followRace();
    });
    connect(&race_, &app::LiveRace::advanced, this, &ComparePanel::followRace);
    connect(&session, &app::Session::previewChanged, this, &ComparePanel::followWindows);
    connect(&session, &app::Session::displayChanged, this, &ComparePanel::showAgain);
    followWindows();
    const int forms = app::rememberedNumber(setting, 0, bothForms, bothForms);
    forms_->choose(int(std::ranges::find(offered, forms) - offered.begin()));
    chooseForms(forms);
}

QLayout* ComparePanel::choiceRow()
{
    sort_->setToolTip(Text::tr("Sort the rows once, the fastest first. A second click on a heading "
                               "returns to the order of the list."));
    auto* choice = new QHBoxLayout;
    choice->setContentsMargins(space::dockMargin, 6, space::dockMargin, 2);
    choice->addWidget(forms_);
    choice->addStretch();
    choice->addWidget(state_);
    choice->addSpacing(space::labelToField);
    choice->addWidget(sort_);
    return choice;
}

QLayout* ComparePanel::legendRow()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(space::dockMargin, 4, space::dockMargin, 0);
    row->setSpacing(space::betweenGroups);
    row->addWidget(corrected_);
    row->addWidget(published_);
    row->addStretch();
    row->addWidget(field_);
    return row;
}

void ComparePanel::setWatched(bool watched)
{
    watched ? race_.start() : race_.stop();
    followWindows();
}

void ComparePanel::chooseForms(int forms)
{
    race_.setVariants(variantsOf(forms));
    corrected_->setVisible(forms != int(Form::Published));
    published_->setVisible(forms != int(Form::Corrected));
    showNothingMeasured();
    followWindows();
}

void ComparePanel::followWindows()
{
    race_.setWindow(session_.comparedAt());
    if (!session_.comparedAt())
        showNothingMeasured();
    else if (windows_ != app::needsByName(session_) || where_ != app::comparedName(session_))
        showAgain();
}

void ComparePanel::showAgain() { race_.rows().empty() ? showNothingMeasured() : showRace(); }

/// Which algorithms can clip here, without numbers: those of another place would be taken for this
/// one's.
void ComparePanel::showNothingMeasured()
{
    pause_.stop();
    waiting_ = false;
    std::vector<app::RaceRow> rows;
    for (const app::Variant& variant : race_.variants())
        rows.push_back({.variant = variant});
    show(rows, 0);
    for (QLabel* label : {field_, state_}) {
        label->clear();
        label->setToolTip({});
    }
}

void ComparePanel::followRace()
{
    waiting_ = pause_.isActive();
    if (waiting_)
        return;
    pause_.start();
    showRace();
}

void ComparePanel::showRace()
{
    const auto rows = race_.rows();
    if (rows.empty())
        return;
    const bool timed = race_.lines() >= app::leastLinesToTime;
    show(rows, race_.lines());
    field_->setText(app::fieldText(race_.lines()));
    field_->setToolTip(timed ? app::batchText(race_.variants()) : app::tooFewText(race_.lines()));
    state_->setText(!timed            ? QString()
                    : race_.settled() ? Text::tr("settled")
                                      : Text::tr("measuring…"));
}

void ComparePanel::show(std::span<const app::RaceRow> rows, std::size_t lines)
{
    windows_ = app::needsByName(session_);
    where_ = app::comparedName(session_);
    table_->showRows(rows, lines, app::needsOf(session_.region()), limitingAmong(windows_));
    place_->setText(app::placeText(where_, table_->content().lane()));
    place_->setVisible(!where_.isEmpty());
    page_->setVisible(where_.isEmpty());
    judge(rows, lines);
    sort_->setEnabled(table_->content().timed());
    fitRows();
}

/// Ranking times takes too long for this thread; until that is done the last verdict stays.
void ComparePanel::judge(std::span<const app::RaceRow> rows, std::size_t lines)
{
    ranking_.cancel();
    if (lines < app::leastLinesToTime) {
        verdict_->setToolTip({});
        return verdict_->show(
            app::verdictOf({.rows = rows, .lines = lines, .windows = windows_, .where = where_}));
    }
    ranking_.start(
        [rows = std::vector(rows.begin(), rows.end()), lines, windows = windows_,
         where = where_](const app::Follower&) {
            const app::Ranking ranking = app::rankingOf(std::span(rows));
            return Ranked{app::verdictOf({.rows = rows,
                                          .lines = lines,
                                          .windows = windows,
                                          .ranking = &ranking,
                                          .where = where}),
                          app::groupsText(rows, ranking)};
        },
        [this](const Ranked& ranked) {
            verdict_->show(ranked.statements);
            verdict_->setToolTip(ranked.groups);
        });
}

QString ComparePanel::groups() const { return verdict_->toolTip(); }

int ComparePanel::usualVerdict() const
{
    return usualLines * verdict_->lineHeight() + 4 * space::labelToField;
}

/// Rows are low where high ones leave too little for the usual verdict. What is measured does not
/// change their height.
void ComparePanel::fitRows()
{
    using Rows = CompareTable::Rows;
    const int count = table_->model()->rowCount();
    const int room = table_->height() + verdictArea_->height() - usualVerdict();
    table_->setRows(table_->heightFor(count, Rows::High) <= room ? Rows::High : Rows::Low);
}

void ComparePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitRows();
}

/// Reserves room for all rows and the usual verdict before there are any.
QSize ComparePanel::sizeHint() const
{
    const QSize all = QWidget::sizeHint();
    return {all.width(), all.height() - table_->sizeHint().height() - verdictArea_->minimumHeight()
                             + table_->heightFor(int(clipping::algorithms().size()))
                             + usualVerdict()};
}

} // namespace ui

#include "moc_compare_panel.cpp"

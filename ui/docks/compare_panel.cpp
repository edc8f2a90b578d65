// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_panel.h"

#include "app/experiment/one_by_one.h"
#include "app/race/race_text.h"
#include "app/settings/remembered.h"
#include "app/view/frame_times.h"
#include "ui/docks/compare_table.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/heading.h"
#include "ui/widgets/segments.h"

#include <QSettings>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int bothForms = 2;
const char* const setting = "compareForms";

std::vector<app::Variant> variantsOf(int forms)
{
    std::vector<const clipping::Algorithm*> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        all.push_back(&algorithm);
    return forms == bothForms ? app::variantsOf(all) : app::variantsOf(all, clipping::Form(forms));
}

QLabel* caption(const QFont& font)
{
    auto* label = new QLabel;
    label->setFont(captionFont(font));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

} // namespace

ComparePanel::ComparePanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), race_(session.document, session.scene),
      forms_(new Segments(Text::tr("Forms"),
                          {Text::tr("Corrected"), Text::tr("Published"), Text::tr("Both")})),
      table_(new CompareTable(session)), state_(caption(font())), groups_(caption(font())),
      field_(caption(font()))
{
    auto* choice = new QHBoxLayout;
    choice->setContentsMargins(space::dockMargin, 6, space::dockMargin, 2);
    choice->addWidget(forms_);
    choice->addStretch();
    choice->addWidget(state_);
    auto* footer = new QHBoxLayout;
    footer->setContentsMargins(space::dockMargin, 4, space::dockMargin, space::labelToField);
    footer->addWidget(groups_, 1);
    footer->addSpacing(space::betweenGroups);
    footer->addWidget(field_);
    groups_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(choice);
    auto* rows = new QHBoxLayout; // the table includes the gap after a text
    rows->setContentsMargins(0, 0, space::dockMargin - DenseTable::gap, 0);
    rows->addWidget(table_);
    column->addLayout(rows, 1);
    column->addLayout(footer);
    auto* page = new PageCaption(session); // the panel's last line
    page->setContentsMargins(space::dockMargin, 0, space::dockMargin, space::labelToField);
    column->addWidget(page);

    connect(forms_, &Segments::picked, this, [this](int index) {
        QSettings().setValue(setting, index);
        chooseForms(index);
    });
    connect(&race_, &app::LiveRace::advanced, this, &ComparePanel::showRace);
    connect(&session, &app::Session::previewChanged, this, &ComparePanel::followWindows);
    connect(&session, &app::Session::displayChanged, this, &ComparePanel::showRace);
    followWindows();
    const int forms = app::rememberedNumber(setting, 0, bothForms, bothForms);
    forms_->choose(forms);
    chooseForms(forms);
}

void ComparePanel::setWatched(bool watched)
{
    watched ? race_.start() : race_.stop();
    followWindows();
}

void ComparePanel::chooseForms(int index)
{
    race_.setVariants(variantsOf(index));
    followWindows();
}

void ComparePanel::followWindows()
{
    race_.setWindow(session_.comparedAt());
    if (!session_.comparedAt())
        showNothingMeasured();
}

/// Which algorithms can clip here, without numbers: those of another place would be taken for this
/// one's.
void ComparePanel::showNothingMeasured()
{
    std::vector<app::RaceRow> rows;
    for (const app::Variant& variant : race_.variants())
        rows.push_back({.variant = variant});
    table_->showRows(rows, 0, app::needsOf(session_.region()));
    for (QLabel* label : {groups_, field_, state_}) {
        label->clear();
        label->setToolTip({});
    }
}

void ComparePanel::showRace()
{
    const auto rows = race_.rows();
    if (rows.empty())
        return;
    const bool timed = race_.lines() >= app::leastLinesToTime;
    table_->showRows(rows, race_.lines(), app::needsOf(session_.region()));
    groups_->setToolTip(timed ? app::groupsText(rows) : QString());
    fitGroups();
    field_->setText(app::fieldText(race_.lines()));
    field_->setToolTip(timed ? app::batchText(race_.variants()) : app::tooFewText(race_.lines()));
    state_->setText(!timed            ? QString()
                    : race_.settled() ? Text::tr("settled")
                                      : Text::tr("measuring…"));
}

void ComparePanel::fitGroups()
{
    groups_->setText(groups_->fontMetrics().elidedText(groups(), Qt::ElideRight, groups_->width()));
}

void ComparePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fitGroups();
}

/// Reserves room for all rows before there are any.
QSize ComparePanel::sizeHint() const
{
    const QSize all = QWidget::sizeHint();
    return {all.width(), all.height() - table_->sizeHint().height()
                             + table_->heightFor(int(race_.variants().size()))};
}

} // namespace ui

#include "moc_compare_panel.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hard_cases/hard_cases_window.h"

#include "app/hard_cases/case_use.h"
#include "ui/files/files.h"
#include "ui/hard_cases/case_list.h"
#include "ui/hard_cases/case_view.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/look/window_place.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QShortcut>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr QSize usual(1180, 780), smallest(760, 420);
constexpr int leastLeft = 330;

} // namespace

HardCasesWindow::HardCasesWindow(app::Session& session, Files& files, QWidget& window)
    : QDialog(&window, Qt::Window), session_(session), files_(files), search_(new QLineEdit),
      choice_(new QComboBox), nothing_(new QLabel(Text::tr("No hard case is like that."))),
      list_(new CaseList), view_(new CaseView), choices_(app::caseChoices())
{
    setObjectName(QStringLiteral("hard-cases"));
    setWindowTitle(Text::tr("Hard cases"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(left(), 2);
    row->addWidget(view_, 3);
    connect(search_, &QLineEdit::textChanged, this, &HardCasesWindow::filter);
    connect(choice_, &QComboBox::currentIndexChanged, this, &HardCasesWindow::filter);
    connect(list_, &CaseList::caseChosen, this, [this](const app::HardCase* hard) {
        if (hard)
            view_->show(*hard);
    });
    connect(view_, &CaseView::microscopeWanted, this, &HardCasesWindow::openMicroscope);
    connect(view_, &CaseView::drawingWanted, this, &HardCasesWindow::draw);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_,
            [this] { search_->setFocus(Qt::ShortcutFocusReason); });
    restorePlace(*this, QStringLiteral("zooGeometry"), usual, smallest);
    filter();
    list_->setFocus();
}

QWidget* HardCasesWindow::left()
{
    search_->setPlaceholderText(Text::tr("Search: corner, SDL, infinite …"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(Text::tr("Search"));
    choice_->setAccessibleName(Text::tr("Which cases"));
    for (const app::CaseChoice& choice : choices_)
        choice_->addItem(choice.name);
    nothing_->setForegroundRole(QPalette::PlaceholderText);
    nothing_->hide();
    auto* whole = new QWidget;
    whole->setMinimumWidth(leastLeft);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(space::dockMargin, space::dockMargin, 0, 0);
    column->setSpacing(space::labelToField);
    column->addWidget(search_);
    column->addWidget(choice_);
    column->addWidget(nothing_);
    column->addWidget(list_, 1);
    return whole;
}

void HardCasesWindow::filter()
{
    app::CaseFilter filter = choices_[std::size_t(choice_->currentIndex())].filter;
    filter.words = search_->text();
    list_->setFilter(filter);
    nothing_->setVisible(!list_->chosen());
    if (const app::HardCase* chosen = list_->chosen(); chosen && chosen != view_->hardCase())
        view_->show(*chosen);
}

void HardCasesWindow::choose(const app::HardCase& hard)
{
    search_->clear();
    choice_->setCurrentIndex(0);
    list_->choose(hard);
}

void HardCasesWindow::chooseFailing(const QString& variant)
{
    for (std::size_t i = 0; i < choices_.size(); ++i)
        if (!variant.isEmpty() && choices_[i].filter.variant == variant) {
            search_->clear();
            choice_->setCurrentIndex(int(i));
        }
}

void HardCasesWindow::openMicroscope(const app::HardCase& hard, const app::Variant& variant)
{
    session_.microscope.open(app::tracedLineOf(hard, variant));
    emit editorWanted();
}

/// Opens the case as a drawing with the variant that was viewed, so that the canvas shows its
/// result.
void HardCasesWindow::draw(const app::HardCase& hard, const app::Variant& variant)
{
    const auto document = app::documentOf(hard);
    if (!document)
        return;
    files_.openMade(*document.value, hard.title,
                    [self = QPointer(this), variant](app::Session* shown) {
                        if (!self || !shown)
                            return;
                        shown->changeDisplay([&variant](app::Display& display) {
                            display.variant = {variant.algorithm, variant.form};
                        });
                        self->parentWidget()->window()->raise();
                        self->parentWidget()->window()->activateWindow();
                    });
}

void HardCasesWindow::hideEvent(QHideEvent* event)
{
    rememberPlace(*this, QStringLiteral("zooGeometry"));
    QDialog::hideEvent(event);
}

} // namespace ui

#include "moc_hard_cases_window.cpp"

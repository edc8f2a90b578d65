// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judge/verdict_view.h"

#include "ui/experiment/tables_page.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr double sentenceSize = 1.2; // factor of the text's size

QLabel* text()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

QFont sentenceFont(QFont font)
{
    font.setPointSizeF(font.pointSizeF() * sentenceSize);
    return semiBold(font);
}

/// Small tables need no sorting, and rows of findings must keep their order.
TableView::Rows rowsOf(const app::Table& table)
{
    return table.names.front() == u"algorithm" ? TableView::Rows::Sortable : TableView::Rows::Plain;
}

} // namespace

VerdictView::VerdictView(QWidget* parent)
    : QWidget(parent), sign_(new LookLabel), sentence_(text()), remarks_(text()),
      look_(new QPushButton(Text::tr("Open line in &microscope"))), tables_(new TablesPage)
{
    sentence_->setObjectName(QStringLiteral("verdict"));
    sentence_->setAccessibleName(Text::tr("Verdict"));
    sentence_->setFont(sentenceFont(font()));
    sign_->setFont(sentence_->font());
    sign_->setAlignment(Qt::AlignTop);
    remarks_->setForegroundRole(QPalette::PlaceholderText);
    remarks_->setAccessibleName(Text::tr("Remarks"));
    look_->setAutoDefault(false);
    look_->setToolTip(
        Text::tr("Show how the algorithm “exact” clips the line selected below, step by "
                 "step (or double-click the line)"));
    auto* top = new QHBoxLayout;
    top->setSpacing(space::labelToField);
    top->addWidget(sign_, 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    words->setSpacing(4);
    words->addWidget(sentence_);
    words->addWidget(remarks_);
    top->addLayout(words, 1);
    top->addWidget(look_, 0, Qt::AlignBottom);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    top->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                            space::dockMargin);
    column->addLayout(top);
    column->addWidget(tables_, 1);
    new LanguageFollower(*this, [this] {
        if (verdict_)
            show(verdict_);
    });
    connect(look_, &QPushButton::clicked, this, &VerdictView::want);
}

void VerdictView::show(const std::shared_ptr<const app::plug_in::Verdict>& verdict)
{
    verdict_ = verdict;
    showSentence();
    findings_ = nullptr;
    std::vector<TablesPage::Entry> entries;
    for (app::Table& table : app::plug_in::shownTables(*verdict_)) {
        const auto rows = rowsOf(table);
        entries.push_back({std::move(table), rows});
    }
    tables_->show(std::move(entries));
    if (TableView* findings = tables_->viewOf(u"findings"))
        follow(findings);
    look_->setVisible(findings_ != nullptr);
}

void VerdictView::showSentence()
{
    if (!verdict_)
        return;
    const bool passed = verdict_->passed();
    sign_->setText(passed ? QStringLiteral("✓") : QStringLiteral("✗"));
    sign_->setColour(passed ? &Look::good : &Look::differs);
    sentence_->setText(app::plug_in::sentence(*verdict_));
    const QStringList more = app::plug_in::remarks(*verdict_);
    remarks_->setText(more.join(u'\n'));
    remarks_->setVisible(!more.isEmpty());
}

/// Selects the first line, so that the button works at once.
void VerdictView::follow(TableView* findings)
{
    findings_ = findings;
    findings->setSelectionBehavior(QAbstractItemView::SelectRows);
    findings->setSelectionMode(QAbstractItemView::SingleSelection);
    findings->setCursor(Qt::PointingHandCursor);
    findings->selectRow(0);
    connect(findings, &QAbstractItemView::doubleClicked, this, &VerdictView::want);
    auto* enter = new QAction(findings);
    enter->setShortcuts({Qt::Key_Return, Qt::Key_Enter});
    enter->setShortcutContext(Qt::WidgetShortcut);
    connect(enter, &QAction::triggered, this, &VerdictView::want);
    findings->addAction(enter);
}

void VerdictView::want()
{
    if (!findings_)
        return;
    const int row = findings_->currentIndex().isValid() ? findings_->currentIndex().row() : 0;
    emit wanted(verdict_->findings[std::size_t(row)]);
}

/// Copies the whole table, although a row is selected.
void VerdictView::copy() const
{
    const int row = findings_ ? findings_->currentIndex().row() : -1;
    if (findings_)
        findings_->clearSelection();
    tables_->copy();
    if (findings_)
        findings_->selectRow(row);
}

} // namespace ui

#include "moc_verdict_view.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/tables_page.h"

#include "ui/look/look.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int gap = 32, noteWidth = 620;

/// Text of limited width. It computes its height for that width, because layouts ask for the height
/// in the whole available width.
class Note : public QLabel {
public:
    using QLabel::QLabel;
    int heightForWidth(int width) const override
    {
        return QLabel::heightForWidth(std::min(width, maximumWidth()));
    }
};

} // namespace

TablesPage::TablesPage(QWidget* parent)
    : QScrollArea(parent), body_(new QWidget), grid_(new QGridLayout)
{
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus); // its tables have it
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(true);
    viewport()->setBackgroundRole(QPalette::Base);
    body_->setAutoFillBackground(true);
    body_->setBackgroundRole(QPalette::Base);
    grid_->setHorizontalSpacing(gap);
    grid_->setVerticalSpacing(24);
    auto* column = new QVBoxLayout(body_);
    column->setContentsMargins(space::betweenGroups, space::dockMargin, space::betweenGroups,
                               space::betweenGroups);
    column->setSpacing(space::betweenGroups);
    column->addLayout(grid_);
    column->addStretch();
    setWidget(body_);
}

void TablesPage::setTop(QWidget* top)
{
    top_ = top;
    static_cast<QVBoxLayout*>(body_->layout())->insertWidget(0, top);
}

TablesPage::Block TablesPage::blockOf(Entry entry)
{
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(space::labelToField);
    auto* title = new QLabel(entry.table.title);
    title->setFont(semiBold(title->font()));
    title->setWordWrap(true);
    column->addWidget(title);
    auto* view = new TableView;
    column->addWidget(view);
    const QString notes = entry.table.notes.join(u'\n');
    view->show(std::move(entry.table), entry.rows);
    if (!notes.isEmpty()) {
        auto* label = new Note(notes);
        label->setFont(captionFont(label->font()));
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setWordWrap(true);
        label->setMaximumWidth(std::max(noteWidth, view->sizeHint().width()));
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(label);
    }
    column->addStretch();
    return {whole, view};
}

void TablesPage::show(std::vector<Entry> entries)
{
    for (const Block& block : blocks_)
        delete block.whole;
    blocks_.clear();
    for (Entry& entry : entries)
        blocks_.push_back(blockOf(std::move(entry)));
    for (const Block& block : blocks_) {
        block.whole->setParent(body_);
        block.view->installEventFilter(this);
    }
    last_ = blocks_.empty() ? nullptr : blocks_.front().view;
    verticalScrollBar()->setValue(0);
    place();
}

/// Places the first two tables side by side if both fit, the others below.
void TablesPage::place()
{
    const int room = viewport()->width() - 2 * space::betweenGroups;
    paired_ =
        blocks_.size() > 1
        && blocks_[0].view->sizeHint().width() + gap + blocks_[1].view->sizeHint().width() <= room;
    int row = 0;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const bool beside = paired_ && i < 2;
        grid_->addWidget(blocks_[i].whole, row, beside ? int(i) : 0, 1, beside ? 1 : 2);
        blocks_[i].whole->show();
        row += beside && i == 0 ? 0 : 1;
    }
    for (const int column : {0, 1}) {
        const bool fits = paired_ && column == 0;
        grid_->setColumnMinimumWidth(column, fits ? blocks_[0].view->sizeHint().width() : 0);
        grid_->setColumnStretch(column, paired_ && column == 0 ? 0 : 1);
    }
}

bool TablesPage::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn)
        for (const Block& block : blocks_)
            if (block.view == watched)
                last_ = block.view;
    return QScrollArea::eventFilter(watched, event);
}

void TablesPage::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    place();
}

TableView* TablesPage::viewOf(QStringView key) const
{
    for (const Block& block : blocks_)
        if (block.view->table().key == key)
            return block.view;
    return nullptr;
}

void TablesPage::copy() const
{
    if (last_)
        last_->copy();
}

} // namespace ui

#include "moc_tables_page.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hard_cases/case_list.h"

#include "ui/hard_cases/case_picture_view.h"
#include "ui/look/focus_ring.h"
#include "ui/look/text.h"
#include "ui/widgets/panel_list.h"

#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

#include <algorithm>

namespace ui {

namespace {

constexpr int gap = 10, captionLines = 2, leastWidth = 132;
constexpr double shape = 0.72; // a picture's height divided by its width

/// Paints a picture and up to two lines of its title.
class CasePainter : public QStyledItemDelegate {
public:
    CasePainter(const CaseModel& model, QListView& list)
        : QStyledItemDelegate(&list), model_(model), list_(list)
    {
    }

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return list_.gridSize();
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const QRect cell = option.rect.adjusted(0, 0, -gap, -gap);
        const QFont caption = captionFont(option.font);
        const int captionHeight = captionLines * QFontMetrics(caption).lineSpacing() + 4;
        const QRect box = cell.adjusted(0, 0, 0, -captionHeight);
        painter->setFont(caption);
        paintCasePicture(*painter, box, model_.hardCase(index.row()),
                         {casePictureColours(option.palette)});
        const bool chosen = option.state & QStyle::State_Selected;
        const bool near = option.state & QStyle::State_MouseOver;
        painter->setPen(QPen(chosen || near ? look.selection : look.control, chosen ? 2 : 1));
        painter->drawRect(box.adjusted(0, 0, -1, -1));
        const QFont font = chosen ? semiBold(caption) : caption;
        painter->setFont(font);
        painter->setPen(look.text);
        const QRect text(cell.left(), box.bottom() + 3, cell.width(), captionHeight - 3);
        const int most = 2 * text.width() - QFontMetrics(font).averageCharWidth() * 8;
        painter->drawText(
            text, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
            QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, most));
    }

private:
    const CaseModel& model_;
    QListView& list_;
};

} // namespace

CaseModel::CaseModel(QObject* parent) : CheckedModel(parent), cases_(app::casesFor({})) {}

void CaseModel::setFilter(const app::CaseFilter& filter)
{
    beginResetModel();
    cases_ = app::casesFor(filter);
    endResetModel();
}

QModelIndex CaseModel::indexOf(const app::HardCase& hard) const
{
    const auto found = std::ranges::find(cases_, &hard);
    return found == cases_.end() ? QModelIndex() : index(int(found - cases_.begin()));
}

int CaseModel::rows() const { return int(cases_.size()); }

QVariant CaseModel::cell(int row, int, int role) const
{
    const app::HardCase& hard = hardCase(row);
    switch (role) {
    case Qt::DisplayRole:
        return hard.title;
    case Qt::ToolTipRole:
        return hard.title + u'\n' + hard.origin;
    case Qt::AccessibleTextRole:
        return Text::tr("%1, %2").arg(hard.title, hard.origin);
    default:
        return {};
    }
}

CaseList::CaseList(QWidget* parent) : QListView(parent)
{
    setModel(&model_);
    setItemDelegate(new CasePainter(model_, *this));
    setAccessibleName(Text::tr("Hard cases"));
    keepChoice(*this);
    setViewMode(IconMode);
    setMovement(Static);
    setResizeMode(Adjust);
    setUniformItemSizes(true);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollMode(ScrollPerPixel);
    // So that the pictures do not change their size.
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setAutoFillBackground(false);
}

void CaseList::setFilter(const app::CaseFilter& filter)
{
    const app::HardCase* before = chosen();
    {
        const QSignalBlocker quiet(this);
        model_.setFilter(filter);
        const QModelIndex kept = before ? model_.indexOf(*before) : QModelIndex();
        setCurrentIndex(kept.isValid() ? kept : model_.index(0));
        scrollTo(currentIndex());
    }
    if (chosen() != before)
        emit caseChosen(chosen());
}

void CaseList::choose(const app::HardCase& hard)
{
    if (const QModelIndex index = model_.indexOf(hard); index.isValid()) {
        setCurrentIndex(index);
        scrollTo(index);
    }
}

const app::HardCase* CaseList::chosen() const
{
    return currentIndex().isValid() ? &model_.hardCase(currentIndex().row()) : nullptr;
}

void CaseList::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QListView::currentChanged(current, previous);
    if (current.isValid())
        emit caseChosen(chosen());
}

void CaseList::paintEvent(QPaintEvent* event)
{
    QListView::paintEvent(event);
    if (hasFocus())
        paintFocusRing(*viewport());
}

void CaseList::resizeEvent(QResizeEvent* event)
{
    const int width = viewport()->width() - 1;
    const int columns = std::max(1, width / (leastWidth + gap));
    const int each = width / columns;
    const int caption = captionLines * QFontMetrics(captionFont(font())).lineSpacing() + 4;
    setGridSize({each, int(shape * (each - gap)) + caption + gap});
    QListView::resizeEvent(event);
}

} // namespace ui

#include "moc_case_list.cpp"

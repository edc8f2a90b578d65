// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/algorithm_list.h"

#include "app/base/text.h"
#include "app/session/window_in_hand.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/panel_list.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int aboutWidth = 34; // width of the year, in pixels
constexpr double disabledMarker = 0.4;

class AlgorithmPainter : public QStyledItemDelegate {
public:
    AlgorithmPainter(const app::Session& session, QObject* parent)
        : QStyledItemDelegate(parent), session_(session)
    {
    }

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return {160, space::rowHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const auto& row = clipping::algorithms()[std::size_t(index.row())];
        const Look& look = lookOf(option.palette);
        const QFontMetrics metrics(semiBold(option.font));
        drawRowGround(*painter, option);
        const QString limit = app::limitText(row, app::needsInHand(session_));
        const QColor ink =
            limit.isEmpty() ? look.text : option.palette.color(QPalette::Disabled, QPalette::Text);
        const QRect r = option.rect.adjusted(space::dockMargin, 0, -space::dockMargin, 0);
        const auto text = [&](int x, int width, const QColor& colour, const QFont& font,
                              const QString& words, Qt::Alignment side = Qt::AlignLeft) {
            painter->setPen(colour);
            painter->setFont(font);
            painter->drawText(QRect(x, r.top(), width, r.height()), int(side | Qt::AlignVCenter),
                              QFontMetrics(font).elidedText(words, Qt::ElideRight, width));
        };
        const QString remark = limit.isEmpty() ? QString::number(row.year) : limit;
        const QFontMetrics caption(captionFont(option.font));
        const int right = std::max(caption.horizontalAdvance(QStringLiteral("0000")),
                                   caption.horizontalAdvance(remark))
                          + 2;
        const int abbreviation = metrics.horizontalAdvance(QStringLiteral("Skala")) + 12;
        int x = r.left();
        text(x, 12, look.muted, captionFont(option.font), digitOf(row));
        x += 17;
        const auto form = app::usable({&row, session_.display().variant.form}).form;
        painter->setOpacity(limit.isEmpty() ? 1 : disabledMarker);
        app::paintMarker(*painter, QRectF(x, r.center().y() - 5.5, 12, 12), {&row, form},
                         groundOf(option.palette));
        painter->setOpacity(1);
        x += 20;
        text(x, abbreviation, ink, semiBold(option.font), app::latin(row.abbreviation));
        x += abbreviation;
        text(x, r.right() - right - 8 - x, ink, option.font, app::latin(row.name));
        if (!(option.state & QStyle::State_MouseOver)) // a hovered row shows the "?" instead
            text(r.right() - right, right + 1, look.muted, captionFont(option.font), remark,
                 Qt::AlignRight);
    }

private:
    const app::Session& session_;
};

} // namespace

void drawRowGround(QPainter& painter, const QStyleOptionViewItem& option)
{
    const Look& look = lookOf(option.palette);
    if (option.state & QStyle::State_Selected) {
        painter.fillRect(option.rect, look.tint);
        painter.fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                         look.selection);
    } else if (option.state & QStyle::State_MouseOver) {
        painter.fillRect(option.rect, look.hover);
    }
    if (option.state & QStyle::State_HasFocus) {
        painter.setPen(QPen(look.selection, 1));
        painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
}

int AlgorithmModel::rows() const { return int(clipping::algorithms().size()); }

QString AlgorithmModel::limitOf(const clipping::Algorithm& row) const
{
    return app::limitText(row, app::needsInHand(session_));
}

QVariant AlgorithmModel::cell(int number, int, int role) const
{
    const auto& row = clipping::algorithms()[std::size_t(number)];
    const QString limit = limitOf(row);
    switch (role) {
    case Qt::DisplayRole:
        return app::latin(row.name);
    case Qt::ToolTipRole:
        return QStringLiteral("%1 (%2)\n%3")
                   .arg(app::latin(row.name))
                   .arg(row.year)
                   .arg(app::latin(row.idea))
               + (limit.isEmpty() ? limit : u'\n' + Text::tr("Not at this window: %1").arg(limit));
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2").arg(app::latin(row.abbreviation), app::latin(row.name))
               + (limit.isEmpty() ? limit : QStringLiteral(", ") + limit);
    default:
        return {};
    }
}

AlgorithmList::AlgorithmList(app::Session& session, QWidget* parent)
    : QListView(parent), session_(session), about_(new QToolButton(viewport()))
{
    setModel(new AlgorithmModel(session, this));
    setItemDelegate(new AlgorithmPainter(session, this));
    setAccessibleName(Text::tr("Algorithm"));
    keepChoice(*this);
    setFrameShape(QFrame::NoFrame);
    setUniformItemSizes(true);
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFixedHeight(model()->rowCount() * space::rowHeight);
    viewport()->setAutoFillBackground(false);
    about_->setText(QStringLiteral("?"));
    about_->setFont(semiBold(captionFont(font())));
    about_->setCursor(Qt::ArrowCursor);
    about_->setFocusPolicy(Qt::NoFocus); // keyboard users have F1 and the row's menu
    about_->setFixedSize(aboutWidth, space::rowHeight - 4);
    about_->hide();
    connect(about_, &QToolButton::clicked, this, [this] {
        if (offered_.isValid())
            emit aboutWanted(clipping::algorithms()[std::size_t(offered_.row())]);
    });
    connect(&session, &app::Session::displayChanged, this, &AlgorithmList::follow);
    connect(&session, &app::Session::previewChanged, viewport(), qOverload<>(&QWidget::update));
    follow();
}

void AlgorithmList::offerAbout(const QModelIndex& index)
{
    offered_ = index;
    about_->setVisible(index.isValid());
    if (!index.isValid())
        return;
    const QString name = index.data(Qt::DisplayRole).toString();
    about_->setToolTip(Text::tr("About %1").arg(name));
    about_->setAccessibleName(about_->toolTip());
    const QRect row = visualRect(index);
    about_->move(row.right() - space::dockMargin - aboutWidth + 5, row.top() + 2);
}

bool AlgorithmList::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::MouseMove)
        offerAbout(indexAt(static_cast<QMouseEvent*>(event)->position().toPoint()));
    if (event->type() == QEvent::Leave)
        offerAbout({});
    return QListView::viewportEvent(event);
}

void AlgorithmList::contextMenuEvent(QContextMenuEvent* event)
{
    const QModelIndex index =
        event->reason() == QContextMenuEvent::Keyboard ? currentIndex() : indexAt(event->pos());
    if (!index.isValid())
        return;
    emit menuWanted(clipping::algorithms()[std::size_t(index.row())],
                    event->reason() == QContextMenuEvent::Keyboard
                        ? viewport()->mapToGlobal(visualRect(index).center())
                        : event->globalPos());
}

void AlgorithmList::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QListView::currentChanged(current, previous);
    if (!current.isValid())
        return;
    session_.changeDisplay([&current](app::Display& display) {
        display.variant.algorithm = &clipping::algorithms()[std::size_t(current.row())];
    });
}

void AlgorithmList::follow()
{
    const auto row = session_.display().variant.algorithm - clipping::algorithms().data();
    setCurrentIndex(model()->index(int(row), 0));
    viewport()->update();
}

} // namespace ui

#include "moc_algorithm_list.cpp"

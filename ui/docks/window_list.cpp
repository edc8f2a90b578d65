// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_list.h"

#include "app/base/keys_in_use.h"
#include "app/base/text.h"
#include "app/document/window_operations.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"
#include "ui/docks/algorithm_list.h"
#include "ui/look/text.h"
#include "ui/widgets/panel_list.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

#include <algorithm>
#include <string>
#include <utility>

namespace ui {

namespace {

class WindowPainter : public RowPainter {
public:
    using RowPainter::RowPainter;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        drawRowGround(*painter, option);
        const bool visible = index.data(WindowModel::VisibleRole).toBool();
        const bool counts = index.data(WindowModel::CountsRole).toBool();
        const auto own = index.data(WindowModel::ColourRole).value<QColor>();
        const QColor colour = !counts ? look.muted : own.isValid() ? own : look.accent;
        drawDots(*painter, option.rect, look.muted);
        drawEye(*painter, option.rect, visible);
        painter->setPen(counts ? look.text : look.muted);
        painter->setFont(semiBold(option.font));
        const auto sign = app::WindowOperation(index.data(WindowModel::OperationRole).toInt());
        painter->drawText(operation(option.rect), Qt::AlignCenter, app::infoOf(sign).sign);
        const QRect place = shape(option.rect);
        const std::string key = index.data(WindowModel::IconRole).toString().toStdString();
        painter->drawPixmap(
            place, tinted(icon(key), place.size(), painter->device()->devicePixelRatioF(), colour));
        drawName(*painter, option, nameBox(option.rect), index.data().toString(), !counts);
    }
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override
    {
        editor->setGeometry(nameBox(option.rect));
    }
    static bool isOnEye(const QRect& row, const QPoint& at) { return hits(eye(row), at); }
    static bool isOnSign(const QRect& row, const QPoint& at) { return operation(row).contains(at); }

private:
    static QRect operation(const QRect& row)
    {
        return {eye(row).right() + 7, row.top(), 16, row.height()};
    }
    static QRect shape(const QRect& row)
    {
        return {operation(row).right() + 7, row.center().y() - 7, 16, 16};
    }
    static QRect nameBox(const QRect& row)
    {
        return row.adjusted(shape(row).right() + 9 - row.left(), 0, -space::dockMargin, 0);
    }
    /// Says that the row can be dragged.
    static void drawDots(QPainter& painter, const QRect& row, const QColor& colour)
    {
        for (const int x : {0, 4})
            for (const int y : {-4, 0, 4})
                painter.fillRect(row.left() + 3 + x, row.center().y() + y, 2, 2, colour);
    }
};

} // namespace

WindowList::WindowList(app::Session& session) : session_(session)
{
    auto* model = new WindowModel(session, this);
    setModel(model);
    setItemDelegate(new WindowPainter(this));
    setAccessibleName(Text::tr("Clip windows"));
    setObjectName(QStringLiteral("clip-windows"));
    keepChoice(*this);
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setEditTriggers(DoubleClicked);
    viewport()->setAutoFillBackground(false);
    connect(selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& current) {
                // Only a person's choice counts, not the row that follows the session.
                if (current.isValid() && std::size_t(current.row()) != session_.windowNumber())
                    session_.chooseWindow(std::size_t(current.row()));
            });
    connect(this, &QListView::clicked, this,
            [this](const QModelIndex& row) { session_.chooseWindow(std::size_t(row.row())); });
    // Queued: a press on the row of a hidden window makes it the current row before this.
    connect(&session, &app::Session::previewChanged, this, &WindowList::follow,
            Qt::QueuedConnection);
    follow();
}

// A hidden window is never the current row: what acts on the current row must be seen.
void WindowList::follow()
{
    const auto number = session_.windowNumber();
    const bool shown = number && int(*number) < model()->rowCount();
    const QModelIndex now = shown ? model()->index(int(*number), 0) : QModelIndex();
    if (now != currentIndex())
        setCurrentIndex(now);
}

void WindowList::shift(int rows)
{
    const int from = currentIndex().row(), to = from + rows;
    if (from >= 0 && to >= 0 && to < model()->rowCount())
        app::reorderWindow(session_, std::size_t(from), std::size_t(to));
}

static int rowsOf(const QKeyEvent& event)
{
    if (event.modifiers() != Qt::ControlModifier)
        return 0;
    return int(event.key() == Qt::Key_Down) - int(event.key() == Qt::Key_Up);
}

bool WindowList::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && rowsOf(*static_cast<QKeyEvent*>(event)) != 0) {
        event->accept();
        return true;
    }
    return PanelList::event(event);
}

void WindowList::keyPressEvent(QKeyEvent* event)
{
    if (const int rows = rowsOf(*event))
        return shift(rows);
    if (event->key() == Qt::Key_Delete)
        return app::removeWindow(session_);
    PanelList::keyPressEvent(event);
}

// The base class would choose the window, or open the field for its name.
bool WindowList::pressesEye(const QMouseEvent& event)
{
    const QModelIndex row = indexAt(event.pos());
    if (event.button() == Qt::LeftButton && row.isValid()
        && WindowPainter::isOnEye(visualRect(row), event.pos()))
        eye_ = row.row();
    return eye_.has_value();
}

void WindowList::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (!pressesEye(*event))
        PanelList::mouseDoubleClickEvent(event);
}

void WindowList::mousePressEvent(QMouseEvent* event)
{
    if (pressesEye(*event))
        return;
    const QModelIndex row = indexAt(event->pos());
    if (event->button() == Qt::LeftButton && row.isValid())
        pressed_ = Press{row.row(), event->pos()};
    PanelList::mousePressEvent(event);
}

// The base class would select the rows under the pointer.
void WindowList::mouseMoveEvent(QMouseEvent* event)
{
    if (eye_)
        return;
    if (!pressed_ || !(event->buttons() & Qt::LeftButton))
        return PanelList::mouseMoveEvent(event);
    const int way = (event->pos() - pressed_->at).manhattanLength();
    if (!gap_ && way < QApplication::startDragDistance())
        return;
    gap_ = gapAt(event->pos().y());
    viewport()->update();
}

void WindowList::mouseReleaseEvent(QMouseEvent* event)
{
    if (const auto eye = std::exchange(eye_, std::nullopt)) {
        const QModelIndex row = model()->index(*eye, 0);
        if (WindowPainter::isOnEye(visualRect(row), event->pos()))
            model()->setData(row, !row.data(WindowModel::VisibleRole).toBool(),
                             WindowModel::VisibleRole);
        return;
    }
    const bool drags = gap_.has_value();
    drop();
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (drags) {
        setState(NoState); // the base class would take it for a click, on the eye perhaps
        return;
    }
    PanelList::mouseReleaseEvent(event);
    const QModelIndex row = indexAt(event->pos());
    if (pressed && row.row() == pressed->row
        && WindowPainter::isOnSign(visualRect(row), event->pos()))
        openOperations(row);
}

void WindowList::openOperations(const QModelIndex& row)
{
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("window-operations"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const int now = row.data(WindowModel::OperationRole).toInt();
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        QAction* action = menu->addAction(
            icon(each.icon), each.name + QLatin1Char('\t') + app::keyInUse(app::latin(each.key)),
            [this, operation = each.operation, index = QPersistentModelIndex(row)] {
                if (index.isValid())
                    app::setWindowOperation(session_, std::size_t(index.row()), operation);
            });
        const QString why = app::whyNot(session_.windows(), std::size_t(row.row()), each.operation);
        action->setCheckable(true);
        action->setChecked(int(each.operation) == now);
        action->setEnabled(why.isEmpty());
        action->setToolTip(why);
    }
    menu->popup(viewport()->mapToGlobal(visualRect(row).bottomLeft()));
}

int WindowList::gapAt(int y) const
{
    const int top = y + verticalOffset();
    return std::clamp((top + space::rowHeight / 2) / space::rowHeight, 0, model()->rowCount());
}

void WindowList::drop()
{
    const auto gap = std::exchange(gap_, std::nullopt);
    if (!gap || !pressed_)
        return;
    const int to = *gap > pressed_->row ? *gap - 1 : *gap;
    app::reorderWindow(session_, std::size_t(pressed_->row), std::size_t(to));
    viewport()->update();
}

void WindowList::paintEvent(QPaintEvent* event)
{
    PanelList::paintEvent(event);
    if (!gap_)
        return;
    QPainter painter(viewport());
    const int y =
        std::clamp(*gap_ * space::rowHeight - verticalOffset() - 1, 0, viewport()->height() - 2);
    painter.fillRect(0, y, viewport()->width(), 2, lookOf(palette()).selection);
}

} // namespace ui

#include "moc_window_list.cpp"

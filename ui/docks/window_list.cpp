// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_list.h"

#include "app/session/window_steps.h"
#include "ui/docks/algorithm_list.h"
#include "ui/widgets/keep_choice.h"
#include "ui/widgets/row_painter.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <array>

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
        drawEye(*painter, option.rect, visible);
        painter->setPen(visible ? look.accent : look.muted);
        painter->setFont(semiBold(option.font));
        constexpr std::array<char16_t, 3> signs{u'+', u'\u2212', u'\u2229'};
        const auto sign = std::size_t(index.data(WindowModel::OperationRole).toInt());
        painter->drawText(operation(option.rect), Qt::AlignCenter, QString(QChar(signs[sign])));
        drawName(*painter, option, nameBox(option.rect), index.data().toString(), !visible);
    }
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex&) const override
    {
        editor->setGeometry(nameBox(option.rect));
    }
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override
    {
        if (event->type() != QEvent::MouseButtonRelease)
            return false;
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (mouse.button() != Qt::LeftButton || !hits(eye(option.rect), mouse.position().toPoint()))
            return false;
        return model->setData(index, !index.data(WindowModel::VisibleRole).toBool(),
                              WindowModel::VisibleRole);
    }

private:
    static QRect operation(const QRect& row)
    {
        return {eye(row).right() + 7, row.top(), 16, row.height()};
    }
    static QRect nameBox(const QRect& row)
    {
        return row.adjusted(operation(row).right() + 9 - row.left(), 0, -space::dockMargin, 0);
    }
};

} // namespace

WindowList::WindowList(app::Session& session) : session_(session)
{
    auto* model = new WindowModel(session, this);
    setModel(model);
    setItemDelegate(new WindowPainter(this));
    setAccessibleName(tr("Clip windows"));
    setObjectName(QStringLiteral("clip-windows"));
    keepChoice(*this);
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setEditTriggers(DoubleClicked);
    viewport()->setAutoFillBackground(false);
    constexpr int rows = 4;
    setFixedHeight(rows * space::rowHeight);
    connect(selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& current) {
                if (current.isValid())
                    session_.chooseWindow(std::size_t(current.row()));
            });
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

} // namespace ui

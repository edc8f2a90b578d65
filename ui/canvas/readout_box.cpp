// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/readout_box.h"

#include "ui/look/text.h"
#include "ui/widgets/icon_sign.h"

#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <ranges>

namespace ui {
namespace {

constexpr int besidePointer = 16, belowPointer = 15;
constexpr int cellHeight = 28, fieldHeight = 24, fieldWidth = 84, shortFieldWidth = 52;
constexpr int besideRule = 6;

} // namespace

ReadoutBox::ReadoutBox(Controller& controller, QWidget* parent)
    : QFrame(parent), controller_(controller), typing_(controller.typing()), error_(new QLabel)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(Text::tr("Numbers of the gesture"));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 1, 8, cellHeight - fieldHeight - 1); // the frame, the underline
    row->setSpacing(5);
    for (Cell& cell : cells_) {
        cell = makeCell();
        cell.name->setContentsMargins(&cell == cells_.data() ? 0 : 2 * besideRule, 0, 0, 0);
        row->addWidget(cell.name);
        row->addWidget(cell.lock);
        row->addWidget(cell.field);
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addLayout(row);
    error_->setContentsMargins(8, 0, 8, 5);
    column->addWidget(error_);
    hide();
    connect(&typing_, &Typing::changed, this, &ReadoutBox::follow);
    connect(&controller.navigation(), &Navigation::moved, this, &ReadoutBox::follow);
    connect(&typing_, &Typing::began, this, &ReadoutBox::open);
}

ReadoutBox::Cell ReadoutBox::makeCell()
{
    Cell cell{new IconSign("lock", 14), new QLabel, new QLineEdit};
    cell.name->setForegroundRole(QPalette::PlaceholderText);
    cell.lock->setToolTip(Text::tr("This number is locked"));
    cell.field->setFrame(false);
    cell.field->setFixedSize(fieldWidth, fieldHeight);
    cell.field->setContextMenuPolicy(Qt::NoContextMenu);
    cell.field->setFocusPolicy(Qt::NoFocus); // open() gives it the keyboard
    cell.field->setMaxLength(200);
    cell.field->installEventFilter(this);
    connect(cell.field, &QLineEdit::textEdited, this,
            [this](const QString& text) { typing_.type(text); });
    return cell;
}

void ReadoutBox::setSurface(QWidget* surface)
{
    surface_ = surface;
    follow();
}

void ReadoutBox::follow()
{
    using State = app::Readout::State;
    const auto& readout = typing_.readout();
    const bool shown = surface_ && typing_.shown();
    if (!shown || !typing_.going())
        giveBackKeyboard();
    if (!shown) {
        typing_.place = {};
        return hide();
    }
    const app::Point end = readout->end(typing_.aim());
    for (std::size_t number = 0; number < cells_.size(); ++number) {
        const bool used = number < readout->gauge().measure->fields.size();
        cells_[number].name->setVisible(used);
        cells_[number].field->setVisible(used);
        cells_[number].lock->setVisible(used && readout->state(number) == State::Locked);
        if (used)
            showNumber(number, end);
    }
    error_->setText(readout->error());
    error_->setVisible(!readout->error().isEmpty());
    place();
    show();
    raise();
    update();
}

void ReadoutBox::showNumber(std::size_t number, const app::Point& end)
{
    const app::Readout& readout = *typing_.readout();
    const Cell& cell = cells_[number];
    const app::Quantity quantity = readout.gauge().measure->fields[number].quantity;
    const bool isShort = quantity == app::Quantity::Count || quantity == app::Quantity::Share;
    cell.field->setFixedWidth(isShort ? shortFieldWidth : fieldWidth);
    const bool open = typing_.going() && readout.active() == number;
    cell.name->setText(readout.gauge().measure->fields[number].name);
    if (open && cell.field->text() == readout.typed(number))
        return; // the caret stays where it is
    const QString text = open || !readout.typed(number).isEmpty() ? readout.typed(number)
                                                                  : readout.number(number, end);
    if (cell.field->text() != text)
        cell.field->setText(text);
    cell.field->setAccessibleName(cell.name->text());
}

/// Beside the pointer, inside the surface.
void ReadoutBox::place()
{
    adjustSize();
    const auto& pointer = controller_.pointer();
    const app::Point at = pointer
                              ? pointer->screen
                              : controller_.view().toScreen(typing_.readout()->gauge().start.from);
    QPoint place(int(at.x) + besidePointer, int(at.y) + belowPointer);
    if (place.x() + width() > surface_->width())
        place.setX(int(at.x) - besidePointer - width());
    if (place.y() + height() > surface_->height())
        place.setY(int(at.y) - belowPointer - height());
    place.setX(std::clamp(place.x(), 0, std::max(0, surface_->width() - width())));
    place.setY(std::clamp(place.y(), 0, std::max(0, surface_->height() - height())));
    typing_.place = QRectF(place, size());
    move(surface_->mapTo(parentWidget(), place));
}

void ReadoutBox::open()
{
    follow();
    if (!typing_.readout())
        return;
    QLineEdit* field = cells_[typing_.readout()->active()].field;
    field->setFocus();
    field->end(false);
    update();
}

void ReadoutBox::giveBackKeyboard()
{
    const bool has =
        std::ranges::any_of(cells_, [](const Cell& cell) { return cell.field->hasFocus(); });
    if (has && surface_)
        surface_->setFocus();
}

bool ReadoutBox::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusOut && typing_.going()) {
        const auto is = [](const Cell& cell) { return cell.field->hasFocus(); };
        if (std::ranges::none_of(cells_, is))
            typing_.stop();
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (!(key.modifiers() & Qt::ControlModifier))
            event->accept();
    }
    if (event->type() == QEvent::KeyPress && key(static_cast<const QKeyEvent&>(*event)))
        return true;
    return QFrame::eventFilter(watched, event);
}

/// In the active field, which may be another one by now.
void ReadoutBox::goOn()
{
    const auto& readout = typing_.readout();
    if (!readout)
        return;
    QLineEdit* field = cells_[readout->active()].field;
    field->setFocus();
    if (field->text() != readout->typed(readout->active()))
        field->setText(readout->typed(readout->active()));
}

bool ReadoutBox::key(const QKeyEvent& event)
{
    const auto& readout = typing_.readout();
    if (!readout)
        return false;
    switch (event.key()) {
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        typing_.lock();
        goOn();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        typing_.accept();
        if (typing_.going())
            goOn();
        return true;
    case Qt::Key_Escape:
        typing_.release();
        return true;
    case Qt::Key_Backspace:
        if (!cells_[readout->active()].field->text().isEmpty())
            return false;
        typing_.release();
        return true;
    default:
        return false;
    }
}

/// A line between each two cells, one below the open field.
void ReadoutBox::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Look& look = controller_.look();
    const bool refused = !error_->isHidden();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.border, 1));
    painter.setBrush(look.base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    for (const Cell& cell : cells_ | std::views::drop(1))
        if (!cell.name->isHidden()) {
            const int between = cell.name->x() + besideRule - 1;
            painter.drawLine(QPointF(between + 0.5, 1), QPointF(between + 0.5, cellHeight));
        }
    if (!typing_.going() || !typing_.readout())
        return;
    const QRect field = cells_[typing_.readout()->active()].field->geometry();
    painter.fillRect(QRect(field.left(), field.bottom() + 1, field.width(), 2),
                     refused ? look.differs : look.selection);
}

} // namespace ui

#include "moc_readout_box.cpp"

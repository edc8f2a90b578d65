// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/palette.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/menus/palette_list.h"
#include "ui/widgets/icon_sign.h"
#include "ui/window/main_window.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace ui {
namespace {

constexpr int paletteWidth = 640, fromTop = 44, typedHeight = 46, footHeight = 28;
constexpr int mostRows = 14; // without scrolling
constexpr std::array parts{PaletteRow::Part::Commands, PaletteRow::Part::Drawing,
                           PaletteRow::Part::Help};

QFont enlarged(QFont font)
{
    font.setPointSizeF(font.pointSizeF() * 1.3);
    return font;
}

} // namespace

Palette::Palette(MainWindow& window, OtherWindows& others)
    : QFrame(&window, Qt::Popup), window_(window), others_(others), typed_(new QLineEdit),
      count_(new QLabel), keys_(new QLabel), list_(new QListView), model_(new PaletteModel(this))
{
    setObjectName(QStringLiteral("palette"));
    setAccessibleName(Text::tr("Find a command"));
    typed_->setObjectName(QStringLiteral("palette-typed"));
    typed_->setAccessibleName(Text::tr("Command, thing of the drawing, or page of the manual"));
    typed_->setPlaceholderText(Text::tr("Find a command, a thing of the drawing, a page"));
    typed_->setFrame(false);
    typed_->setFont(enlarged(typed_->font()));
    typed_->setFixedHeight(typedHeight);
    typed_->installEventFilter(this);
    count_->setForegroundRole(QPalette::PlaceholderText);
    keys_->setForegroundRole(QPalette::PlaceholderText);
    keys_->setFixedHeight(footHeight);
    wearCaption(*keys_);
    list_->setObjectName(QStringLiteral("palette-rows"));
    list_->setModel(model_);
    list_->setItemDelegate(new PalettePainter(list_));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMouseTracking(true);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    top->setSpacing(space::labelToField);
    top->addWidget(new IconSign("zoom", 18));
    top->addWidget(typed_, 1);
    top->addWidget(count_);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    foot->addWidget(keys_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1); // the border
    column->setSpacing(0);
    column->addLayout(top);
    column->addSpacing(1); // a rule
    column->addWidget(list_);
    column->addSpacing(1);
    column->addLayout(foot);
    const app::Session& session = window.session();
    connect(&session, &app::Session::loaded, this, &QWidget::close);
    connect(&session.document, &app::EditedDocument::changed, this, [this] {
        if (isVisible())
            search();
    });
    connect(typed_, &QLineEdit::textChanged, this, &Palette::search);
    connect(list_, &QListView::clicked, this, [this](const QModelIndex& row) {
        if (!model_->isRow(row.row())) // a heading
            return choose(model_->bestLine());
        choose(row.row());
        run();
    });
}

void Palette::open()
{
    rows_ = std::make_unique<PaletteRows>(window_, others_);
    only_.reset();
    setFixedWidth(std::min(paletteWidth, window_.width()));
    typed_->clear();
    search();
    const Canvas& canvas = window_.canvas();
    const QPoint middle = canvas.mapTo(&window_, QPoint(canvas.width() / 2, fromTop));
    const int left = std::clamp(middle.x() - width() / 2, 0, window_.width() - width());
    move(window_.mapToGlobal(QPoint(left, middle.y())));
    show();
    typed_->setFocus();
}

void Palette::search()
{
    if (!rows_)
        return;
    std::vector<PaletteRow> found = rows_->matching(typed_->text(), only_);
    count_->setText(app::countText(found.size()));
    keys_->setText(only_ ? Text::tr("Tab: %1 only").arg(partName(*only_))
                         : Text::tr("Enter: run    Tab: only this kind    Esc: close"));
    model_->show(std::move(found), typed_->text());
    choose(model_->bestLine());
    fit();
}

void Palette::fit()
{
    const int top = window_.canvas().mapTo(&window_, QPoint(0, fromTop)).y();
    const int room = window_.height() - top - typedHeight - footHeight - 2 * space::rowHeight;
    int height = 0;
    for (int row = 0, shown = 0; row < model_->rowCount() && shown <= mostRows; ++row) {
        height += model_->heightOf(row);
        shown += model_->isRow(row);
    }
    list_->setFixedHeight(std::min(height, std::max(room, 3 * space::rowHeight)));
    adjustSize();
}

void Palette::choose(int row)
{
    const QModelIndex index = row >= 0 ? model_->index(row) : QModelIndex();
    list_->setCurrentIndex(index);
    list_->scrollTo(index);
    typed_->setAccessibleDescription(index.data(Qt::AccessibleTextRole).toString());
    QAccessibleEvent told(typed_, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&told);
}

void Palette::step(int by)
{
    for (int row = list_->currentIndex().row() + by; row >= 0 && row < model_->rowCount();
         row += by)
        if (model_->isRow(row))
            return choose(row);
}

/// All, then each part alone, in a circle.
void Palette::showNextPart(int by)
{
    constexpr int all = int(parts.size());
    const int now = only_ ? int(std::ranges::find(parts, *only_) - parts.begin()) : all;
    const int next = (now + by + all + 1) % (all + 1);
    only_ = next == all ? std::nullopt : std::optional(parts[std::size_t(next)]);
    search();
}

/// The row runs when the keyboard is back where it was.
void Palette::run()
{
    const PaletteRow* row = model_->row(list_->currentIndex().row());
    if (!row || !row->run)
        return;
    // A thing of the drawing says in a sentence why it is not chosen.
    if (!row->enabled && row->part != PaletteRow::Part::Drawing)
        return emit refused(row->note.isEmpty() ? Text::tr("%1 is not possible now.").arg(row->name)
                                                : row->note);
    rows_->remember(*row);
    QMetaObject::invokeMethod(&window_, row->run, Qt::QueuedConnection);
    close();
}

bool Palette::key(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Down:
        step(+1);
        return true;
    case Qt::Key_Up:
        step(-1);
        return true;
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
        for (int i = 0; i < mostRows; ++i)
            step(event.key() == Qt::Key_PageDown ? +1 : -1);
        return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        showNextPart(event.key() == Qt::Key_Tab ? +1 : -1);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        run();
        return true;
    case Qt::Key_Escape:
        close();
        return true;
    case Qt::Key_K:
        if (!(event.modifiers() & Qt::ControlModifier))
            return false;
        typed_->selectAll();
        return true;
    default:
        return false;
    }
}

bool Palette::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && key(static_cast<const QKeyEvent&>(*event)))
        return true;
    return QFrame::eventFilter(watched, event);
}

void Palette::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setPen(look.border);
    painter.setBrush(look.base);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.fillRect(1, list_->y() - 1, rect().width() - 2, 1, look.rule);
    painter.fillRect(1, list_->geometry().bottom() + 1, rect().width() - 2, 1, look.rule);
}

} // namespace ui

#include "moc_palette.cpp"

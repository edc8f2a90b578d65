// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/keyboard_page.h"

#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/sheets/command_keys.h"
#include "ui/sheets/key_field.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/dense_table.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"

#include <QPainter>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int leastTableHeight = 240, keysWidth = 150; // pixels

/// The name of a menu is bold, and keys that the person gave.
class KeyCells : public QStyledItemDelegate {
public:
    explicit KeyCells(DenseTable& table) : QStyledItemDelegate(&table), table_(table) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        table_.paintGround(*painter, option, index);
        const bool isBold = index.data(Qt::FontRole).isValid();
        const QFont font = isBold ? semiBold(option.font) : option.font;
        painter->setFont(font);
        painter->setPen(look.text);
        const QRect place = option.rect.adjusted(
            index.column() == 0 ? space::dockMargin : DenseTable::gap, 0, -DenseTable::gap, 0);
        painter->drawText(
            place, Qt::AlignLeft | Qt::AlignVCenter,
            QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideRight, place.width()));
    }

private:
    DenseTable& table_;
};

} // namespace

KeyboardPage::KeyboardPage(CommandKeys& keys, QWidget* parent)
    : QWidget(parent), keys_(keys), search_(new QLineEdit), table_(new DenseTable),
      name_(new QLabel), field_(new KeyField), remove_(plainButton(Text::tr("Remove"))),
      reset_(plainButton(Text::tr("Reset"))), takeOver_(plainButton({})), answer_(new LookLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    addTable(*column);
    addFields(*column);
    connect(&KeyNews::get(), &KeyNews::changed, this, &KeyboardPage::follow);
    find({});
}

void KeyboardPage::addTable(QVBoxLayout& column)
{
    auto* above = new QHBoxLayout;
    above->setContentsMargins(space::dockMargin, 0, space::dockMargin, space::labelToField);
    search_->setObjectName(QStringLiteral("find-key"));
    search_->setPlaceholderText(Text::tr("Find a command or a key"));
    search_->setAccessibleName(search_->placeholderText());
    search_->setClearButtonEnabled(true);
    search_->setFixedHeight(space::fieldHeight);
    above->addWidget(search_);
    column.addLayout(above);
    table_->setModel(&model_);
    table_->setItemDelegate(new KeyCells(*table_));
    table_->setObjectName(QStringLiteral("keys"));
    table_->setAccessibleName(Text::tr("Commands and their keys"));
    table_->setMinimumHeight(leastTableHeight);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->horizontalHeader()->setSortIndicatorShown(false);
    table_->horizontalHeader()->setSectionsClickable(false);
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->resizeSection(1, keysWidth);
    column.addWidget(table_, 1);
    connect(search_, &QLineEdit::textChanged, this, &KeyboardPage::find);
    connect(search_, &QLineEdit::returnPressed, this, [this] {
        constexpr int belowItsMenu = 1;
        if (!chosen_)
            table_->selectRow(belowItsMenu);
        table_->setFocus();
    });
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &KeyboardPage::choose);
    connect(table_, &QAbstractItemView::activated, field_, [this] { field_->setFocus(); });
}

void KeyboardPage::addFields(QVBoxLayout& column)
{
    auto* grid = new QVBoxLayout;
    grid->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                             space::labelToField);
    grid->setSpacing(space::labelToField);
    column.addWidget(rule(Qt::Horizontal));
    name_->setFont(semiBold(font()));
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    grid->addWidget(name_);
    name_->setObjectName(QStringLiteral("chosen-command"));
    field_->setObjectName(QStringLiteral("new-key"));
    remove_->setObjectName(QStringLiteral("remove-keys"));
    reset_->setObjectName(QStringLiteral("reset-keys"));
    takeOver_->setObjectName(QStringLiteral("take-key"));
    answer_->setObjectName(QStringLiteral("key-answer"));
    remove_->setToolTip(Text::tr("Leave the command without a key"));
    reset_->setToolTip(Text::tr("Give the command its standard keys"));
    auto* row = new QHBoxLayout;
    row->setSpacing(space::labelToField);
    row->addWidget(field_, 1);
    row->addWidget(remove_);
    row->addWidget(reset_);
    grid->addLayout(row);
    constexpr int lines = 2;
    answer_->setTextFormat(Qt::PlainText);
    answer_->setWordWrap(true);
    answer_->setAlignment(Qt::AlignTop);
    answer_->setMinimumHeight(lines * fontMetrics().lineSpacing());
    grid->addWidget(answer_);
    keepPlaceWhenHidden(*takeOver_);
    takeOver_->hide(); // until a key is offered
    grid->addWidget(takeOver_, 0, Qt::AlignLeft);
    column.addLayout(grid);
    connect(field_, &KeyField::pressed, this, &KeyboardPage::take);
    connect(field_, &KeyField::left, table_, [this] { table_->setFocus(); });
    connect(remove_, &QPushButton::clicked, this, &KeyboardPage::remove);
    connect(reset_, &QPushButton::clicked, this, &KeyboardPage::resetChosen);
    connect(takeOver_, &QPushButton::clicked, this, &KeyboardPage::takeOver);
}

void KeyboardPage::find(const QString& words)
{
    model_.show(keys_.table(), words);
    if (const int row = chosen_ ? model_.rowOf(*chosen_) : -1; row >= 0)
        table_->selectRow(row);
    choose();
}

void KeyboardPage::choose()
{
    const auto before = std::exchange(chosen_, model_.command(table_->currentIndex().row()));
    if (before != chosen_)
        answer({}, false);
    follow();
}

void KeyboardPage::take(const QKeySequence& key)
{
    if (!chosen_)
        return;
    const app::KeyTable& table = keys_.table();
    const QString why = table.refusal(*chosen_, key);
    const auto holder = why.isEmpty() ? table.holder(key, *chosen_) : std::nullopt;
    if (!why.isEmpty())
        return answer(why, true);
    if (holder) {
        const QString text = key.toString(QKeySequence::NativeText);
        answer(Text::tr("%1 belongs to “%2”.").arg(text, table.commands()[*holder].name), true);
        offered_ = key;
        takeOver_->setText(Text::tr("Take %1 over").arg(text));
        takeOver_->show();
        return;
    }
    keys_.change([this, &key](app::KeyTable& all) { all.give(*chosen_, key); });
    answer({}, false);
}

void KeyboardPage::takeOver()
{
    if (!chosen_ || offered_.isEmpty())
        return;
    const QKeySequence key = offered_;
    const auto holder = keys_.table().holder(key, *chosen_);
    field_->setFocus(); // the button is about to be hidden
    keys_.change([this, &key](app::KeyTable& all) { all.give(*chosen_, key); });
    if (holder)
        answer(Text::tr("“%1” no longer has this key.").arg(keys_.table().commands()[*holder].name),
               false);
}

void KeyboardPage::remove()
{
    if (!chosen_)
        return;
    keys_.change([this](app::KeyTable& all) { all.clear(*chosen_); });
    answer({}, false);
}

void KeyboardPage::resetChosen()
{
    if (!chosen_)
        return;
    QStringList said;
    keys_.change([&](app::KeyTable& all) {
        for (const auto& [command, key, isLost] : all.reset(*chosen_))
            said << (isLost ? Text::tr("“%1” no longer has %2.") : Text::tr("“%1” has %2 again."))
                        .arg(all.commands()[command].name, key.toString(QKeySequence::NativeText));
    });
    answer(said.join(u' '), false);
}

void KeyboardPage::reset()
{
    keys_.change([](app::KeyTable& all) { all.reset(); });
    answer({}, false);
}

void KeyboardPage::focusFirst() { search_->setFocus(); }

/// Withdraws the offer.
void KeyboardPage::answer(const QString& sentence, bool refused)
{
    offered_ = {};
    takeOver_->hide();
    answer_->setColour(
        [refused](const Look& look) { return refused ? errorColour(look) : look.muted; });
    answer_->setText(sentence);
}

void KeyboardPage::follow()
{
    const app::KeyTable& table = keys_.table();
    model_.tellKeys(table);
    const QString keys = chosen_ ? app::keysText(table.keys(*chosen_)) : QString();
    name_->setText(!chosen_ ? Text::tr("Choose a command")
                   : keys.isEmpty()
                       ? Text::tr("%1: no key").arg(table.commands()[*chosen_].name)
                       : Text::tr("%1: %2").arg(table.commands()[*chosen_].name, keys));
    field_->setEnabled(chosen_.has_value());
    remove_->setEnabled(chosen_ && !table.keys(*chosen_).isEmpty());
    reset_->setEnabled(chosen_ && !table.isStandard(*chosen_));
}

} // namespace ui

#include "moc_keyboard_page.cpp"

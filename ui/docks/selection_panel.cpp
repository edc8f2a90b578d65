// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/selection_panel.h"

#include "app/base/numbers.h"
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"
#include "app/session/units.h"
#include "ui/docks/node_fields.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/reference_point.h"
#include "ui/widgets/tool_list.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>

namespace ui {
namespace {

constexpr int leastFieldWidth = 56, leastListWidth = 52, betweenRows = 4, buttonsInRow = 6;

/// A check box with the longest of several texts for which there is room.
class ShortenedBox : public QCheckBox {
public:
    explicit ShortenedBox(const QStringList& texts) : texts_(texts)
    {
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        setAccessibleName(texts.first());
    }
    QSize minimumSizeHint() const override { return {0, QCheckBox::minimumSizeHint().height()}; }

protected:
    void resizeEvent(QResizeEvent* event) override
    {
        QCheckBox::resizeEvent(event);
        for (const QString& text : texts_) {
            setText(text);
            if (sizeHint().width() <= width())
                break;
        }
    }

private:
    QStringList texts_;
};

/// "3 objects", "group of 3 objects"
QString remarkOn(const app::Session& session)
{
    if (session.nodes.someSelected())
        return app::nodesText(session);
    const app::ObjectRanges& selection = session.selection();
    if (selection.empty())
        return Text::tr("nothing selected");
    const app::ContainerId group = app::groupAt(session, selection.first());
    const bool isGroup =
        group != 0 && selection == app::ObjectRanges(session.now().containers().rangeOf(group));
    const QString count = app::countText(selection.size());
    return selection.size() == 1 ? isGroup ? Text::tr("group of 1 object") : Text::tr("1 object")
           : isGroup ? Text::tr("group of %1 objects").arg(count)
                                 : Text::tr("%1 objects").arg(count);
}

} // namespace

SelectionPanel::SelectionPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), reference_(new ReferencePoint), chain_(ratioButton()),
      target_(new ToolList),
      strokes_(new ShortenedBox({Text::tr("Scale strokes"), Text::tr("Strokes")})),
      nodes_(new NodeFields(session)), pages_(new QStackedLayout(this))
{
    makeOptions();
    pages_->addWidget(makeObjects());
    pages_->addWidget(nodes_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &SelectionPanel::follow);
    const auto follow = [this] {
        if (isVisible())
            soon_.start(0);
    };
    connect(&session, &app::Session::selectionChanged, this, follow);
    connect(&session.nodes, &app::NodeEditing::changed, this, follow);
    connect(&session, &app::Session::displayChanged, this, follow);
    connect(&session.document, &app::EditedDocument::changed, this, follow);
    connect(reference_, &ReferencePoint::changed, this, follow);
    connect(nodes_, &NodeFields::entered, this, &SelectionPanel::entered);
    connect(nodes_, &NodeFields::refused, this, &SelectionPanel::refused);
    connect(nodes_, &NodeFields::taken, this, &SelectionPanel::taken);
    this->follow();
}

QWidget* SelectionPanel::makeObjects()
{
    auto* objects = new QWidget;
    auto* column = new QVBoxLayout(objects);
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::labelToField);
    column->setSpacing(betweenRows);
    column->addLayout(makeNumbers());
    column->addLayout(makeButtons());
    return objects;
}

void SelectionPanel::makeOptions()
{
    for (const app::AlignmentTarget& target : app::alignmentTargets())
        target_->addItem(target.listed);
    target_->setFixedHeight(space::fieldHeight);
    target_->setMinimumWidth(leastListWidth);
    target_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    target_->setAccessibleName(Text::tr("Align and spread"));
    connect(target_, &QComboBox::activated, this, [this](int index) {
        app::alignTo(session_, app::alignmentTargets()[std::size_t(index)]);
    });
    connect(target_, &ToolList::done, this, &SelectionPanel::entered);
    strokes_->setToolTip(Text::tr("Widths and dashes of strokes are scaled with the objects"));
    strokes_->setFocusPolicy(Qt::TabFocus);
    connect(strokes_, &QCheckBox::clicked, this, [this](bool on) {
        app::scaleStrokes(session_, on ? app::StrokeScaling::Scale : app::StrokeScaling::Keep);
    });
}

std::pair<QLabel*, LengthField*> SelectionPanel::makeField(const app::SelectionNumber& number)
{
    using Range = LengthField::Range;
    const bool isLength = number.quantity == app::Quantity::Length;
    const bool isAngle = number.quantity == app::Quantity::Angle;
    auto* field =
        new LengthField(number.name, isLength ? Range::NotNegative : Range::Any,
                        isAngle ? LengthField::Suffix::Degrees : LengthField::Suffix::None);
    field->setAlignment(Qt::AlignRight);
    field->setToolTip(number.name);
    field->setMinimumWidth(leastFieldWidth);
    auto* label = new QLabel(number.label);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(field);
    label->setToolTip(number.name);
    connect(field, &LengthField::edited, this,
            [this, &number](double value, app::Merging merging) { edit(number, value, merging); });
    connect(field, &LengthField::entered, this, &SelectionPanel::entered);
    connect(field, &LengthField::refused, this, &SelectionPanel::refused);
    connect(field, &LengthField::taken, this, &SelectionPanel::taken);
    fields_.push_back(field);
    needSelection_.insert(needSelection_.end(), {label, field});
    return {label, field};
}

/// X over Y and W over H, with what belongs to them; below, angle, skew and length in one row.
QLayout* SelectionPanel::makeNumbers()
{
    constexpr std::size_t ofBox = 4;
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(betweenRows);
    auto* below = new QHBoxLayout;
    below->setSpacing(space::labelToField);
    for (const app::SelectionNumber& number : app::selectionNumbers()) {
        const std::size_t i = fields_.size();
        const auto [label, field] = makeField(number);
        if (i < ofBox) {
            grid->addWidget(label, int(i % 2), int(i / 2) * 2);
            grid->addWidget(field, int(i % 2), int(i / 2) * 2 + 1);
        } else {
            below->addWidget(label);
            below->addWidget(field, 1);
        }
    }
    needSelection_.insert(needSelection_.end(), {reference_, chain_});
    grid->addWidget(chain_, 0, 4, 2, 1, Qt::AlignCenter);
    grid->addWidget(reference_, 0, 5, 2, 1, Qt::AlignCenter);
    grid->addLayout(below, 2, 0, 1, 6);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return grid;
}

QToolButton* SelectionPanel::makeButton(const app::Arrangement& how)
{
    auto* button = new QToolButton;
    button->setIcon(icon(how.key));
    button->setAutoRaise(true);
    button->setFixedSize(space::fieldHeight, space::fieldHeight);
    button->setAccessibleName(how.name);
    connect(button, &QToolButton::clicked, this, [this, &how] { how.run(session_); });
    return button;
}

QLayout* SelectionPanel::makeButtons()
{
    auto* grid = new QGridLayout;
    grid->setSpacing(2);
    for (const app::Arrangement& how : app::arrangements())
        if (how.button) {
            const int i = int(buttons_.size());
            buttons_.push_back({makeButton(how), &how});
            grid->addWidget(buttons_.back().first, i / buttonsInRow, i % buttonsInRow);
        }
    grid->setColumnMinimumWidth(buttonsInRow, 2);
    grid->addWidget(target_, 0, buttonsInRow + 1, 1, 2);
    grid->addWidget(strokes_, 1, buttonsInRow + 1);
    grid->addWidget(new UnitButton(session_), 1, buttonsInRow + 2);
    grid->setColumnStretch(buttonsInRow + 1, 1);
    return grid;
}

app::SelectionFrame SelectionPanel::frame() const
{
    return {reference_->chosen(), chain_->isChecked()};
}

void SelectionPanel::showEvent(QShowEvent* event)
{
    follow();
    QWidget::showEvent(event);
}

void SelectionPanel::follow()
{
    const bool nodes = session_.nodes.someSelected();
    pages_->setCurrentIndex(nodes ? 1 : 0);
    nodes ? nodes_->follow() : followObjects();
    emit titled(remarkOn(session_));
}

/// The tooltip of a disabled button says why.
void SelectionPanel::followArranging()
{
    for (const auto& [button, how] : buttons_) {
        const QString why = app::refusal(*how, session_);
        const QString name =
            how->shortcut.isEmpty() ? how->name : how->name + " (" + how->shortcut + ")";
        button->setEnabled(why.isEmpty());
        button->setToolTip(why.isEmpty() ? name : name + u'\n' + why);
    }
    const app::AlignmentTarget& target = app::alignmentTarget(session_);
    target_->setCurrentIndex(int(&target - app::alignmentTargets().data()));
    target_->setToolTip(Text::tr("Align and spread %1").arg(target.listed));
    strokes_->setChecked(session_.arrange.strokes == app::StrokeScaling::Scale);
}

void SelectionPanel::followObjects()
{
    for (QWidget* widget : needSelection_)
        widget->setEnabled(!session_.selection().empty());
    followArranging();
    const double size = session_.now().page().millimetresPerUnit();
    const auto numbers = app::selectionNumbers();
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto value = numbers[i].value(session_, frame());
        const bool isAngle = numbers[i].quantity == app::Quantity::Angle;
        const app::Unit unit = isAngle ? app::Unit::User : session_.display().unit;
        fields_[i]->show(value.value_or(0), unit, isAngle ? 1 : size);
        if (!value)
            fields_[i]->showNothing();
    }
}

void SelectionPanel::edit(const app::SelectionNumber& number, double value, app::Merging merging)
{
    if (const auto error = app::setSelectionNumber(session_, number, frame(), value, merging))
        emit session_.refused(*error);
    soon_.start(0);
}

} // namespace ui

#include "moc_selection_panel.cpp"

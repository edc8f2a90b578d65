// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_panel.h"

#include "app/document/window_shape.h"
#include "app/session/window_steps.h"
#include "app/view/place.h"
#include "app/view/which_text.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {

namespace {

enum Field : std::size_t { X, Y, Width, Height };
enum Row { Which, First, Second };

clipping::Window edited(const clipping::Window& window, std::size_t field, double length,
                        bool proportional)
{
    clipping::Window next = window;
    const auto size = window.max - window.min;
    const glm::length_t axis = field == X || field == Width ? 0 : 1;
    if (field == X || field == Y) {
        next.min[axis] = length;
        next.max[axis] = length + size[axis];
        return next;
    }
    next.max[axis] = window.min[axis] + length;
    const glm::length_t other = 1 - axis;
    if (proportional && size[axis] > 0)
        next.max[other] = window.min[other] + size[other] * length / size[axis];
    return next;
}

} // namespace

WindowPanel::WindowPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), which_(new ElidedLabel), chain_(new QToolButton),
      unit_(new UnitBox(session)), pages_(new QStackedLayout(this))
{
    pages_->addWidget(makeFields());
    pages_->addWidget(makeOffer());
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(&session, &app::Session::previewChanged, this, &WindowPanel::follow);
    connect(&session, &app::Session::displayChanged, this, &WindowPanel::follow);
    follow();
}

QWidget* WindowPanel::makeFields()
{
    using Range = LengthField::Range;
    constexpr auto none = LengthField::Suffix::None;
    fields_ = {new LengthField(tr("X"), Range::Any, none),
               new LengthField(tr("Y"), Range::Any, none),
               new LengthField(tr("Width"), Range::NotNegative, none),
               new LengthField(tr("Height"), Range::NotNegative, none)};
    const QStringList labels{tr("X"), tr("Y"), tr("W"), tr("H")};
    which_->setObjectName(QStringLiteral("which-window"));
    which_->setFont(captionFont(font()));
    which_->setForegroundRole(QPalette::PlaceholderText);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        auto* label = new QLabel(labels[qsizetype(i)]);
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setBuddy(fields_[i]);
        const int row = First + int(i % 2);
        grid->addWidget(label, row, i < 2 ? 0 : 2);
        grid->addWidget(fields_[i], row, i < 2 ? 1 : 3);
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double length, app::Merging merging) { edit(i, length, merging); });
        connect(fields_[i], &LengthField::entered, this, &WindowPanel::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowPanel::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowPanel::taken);
    }
    connect(unit_, &UnitBox::done, this, &WindowPanel::entered);
    chain_->setIcon(icon("chain"));
    chain_->setCheckable(true);
    chain_->setAutoRaise(true);
    chain_->setToolTip(tr("Keep the ratio of width to height"));
    chain_->setAccessibleName(chain_->toolTip());
    grid->addWidget(which_, Which, 0, 1, 5);
    grid->addWidget(unit_, First, 4);
    grid->addWidget(chain_, Second, 4, Qt::AlignLeft);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                             space::dockMargin);
    for (LengthField* field : fields_)
        field->setMinimumWidth(72);
    auto* fields = new QWidget;
    fields->setLayout(grid);
    return fields;
}

QWidget* WindowPanel::makeOffer()
{
    auto* text = new QLabel(tr("There is no clip window, so nothing is cut. Draw one (W), or:"));
    text->setWordWrap(true);
    auto* button = new QPushButton(tr("Lay window on page"));
    button->setToolTip(tr("Add a clip window that covers the whole page"));
    connect(button, &QPushButton::clicked, this, [this] { layWindowOnPage(session_); });
    auto* row = new QHBoxLayout;
    row->addWidget(text, 1);
    row->addWidget(button, 0, Qt::AlignVCenter);
    row->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                            space::dockMargin);
    auto* offer = new QWidget;
    offer->setLayout(row);
    return offer;
}

void WindowPanel::sayWhich()
{
    const QString text = app::whichText(session_.windows(), session_.windowNumber());
    which_->setWhole(text);
    which_->setToolTip(tr("%1\nOutlines on the canvas: solid for windows that add, dashed for "
                          "windows that cut out, dotted for windows that intersect.")
                           .arg(text));
    if (which_->isHidden() != text.isEmpty()) {
        which_->setHidden(text.isEmpty());
        emit resized();
    }
}

void WindowPanel::follow()
{
    sayWhich();
    pages_->setCurrentIndex(session_.clipWindow() ? 0 : 1);
    const auto number = session_.windowNumber();
    const clipping::Window window =
        number ? app::frameOf(session_.windows().list[*number].shape).box : session_.window();
    const double size = session_.now().page().millimetresPerUnit();
    const app::Point place =
        window.min - app::originOf(session_.now().page(), session_.display().unit);
    const std::array values{place.x, place.y, window.max.x - window.min.x,
                            window.max.y - window.min.y};
    for (std::size_t i = 0; i < fields_.size(); ++i)
        fields_[i]->show(values[i], session_.display().unit, size);
}

void WindowPanel::edit(std::size_t field, double length, app::Merging merging)
{
    const auto number = session_.windowNumber();
    if (!number)
        return;
    const app::WindowShape& shape = session_.windows().list[*number].shape;
    const app::WindowFrame frame = app::frameOf(shape);
    const clipping::Window& before = frame.box;
    const app::Point origin = app::originOf(session_.now().page(), session_.display().unit);
    const double place = field == X ? origin.x : field == Y ? origin.y : 0;
    const clipping::Window after = edited(before, field, place + length, chain_->isChecked());
    if (after != before)
        app::setWindowShape(
            session_, app::fitted(shape, {after, frame.angle}),
            field == X || field == Y ? tr("Move clip window") : tr("Resize clip window"), merging);
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_panel.h"

#include "app/document/window_shape.h"
#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "app/view/place.h"
#include "ui/docks/window_list.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"
#include "ui/widgets/icon_button.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/tool_list.h"
#include "ui/widgets/unit_box.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

namespace ui {

namespace {

enum Field : std::size_t { X, Y, Width, Height };

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
    : QWidget(parent), session_(session), list_(new WindowList(session)), operation_(new ToolList),
      chain_(ratioButton()), unit_(new UnitBox(session)), pages_(new QStackedLayout(this))
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
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        auto* label = new QLabel(labels[qsizetype(i)]);
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setBuddy(fields_[i]);
        const int row = int(i % 2);
        grid->addWidget(label, row, i < 2 ? 0 : 2);
        grid->addWidget(fields_[i], row, i < 2 ? 1 : 3);
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double length, app::Merging merging) { edit(i, length, merging); });
        connect(fields_[i], &LengthField::entered, this, &WindowPanel::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowPanel::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowPanel::taken);
    }
    connect(unit_, &UnitBox::done, this, &WindowPanel::entered);
    chain_->setObjectName(QStringLiteral("keep-ratio"));
    grid->addWidget(unit_, 0, 4);
    grid->addWidget(chain_, 1, 4, Qt::AlignLeft);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                             space::dockMargin);
    for (LengthField* field : fields_)
        field->setMinimumWidth(72);
    auto* column = new QVBoxLayout;
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    column->addWidget(list_);
    column->addWidget(makeTools());
    column->addLayout(grid);
    auto* fields = new QWidget;
    fields->setLayout(column);
    return fields;
}

QToolButton* WindowPanel::makeAdd()
{
    QToolButton* add = iconButton("plus", tr("Add a clip window"));
    add->setPopupMode(QToolButton::InstantPopup);
    add->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    add->setMenu(makeAddMenu());
    return add;
}

QWidget* WindowPanel::makeTools()
{
    QToolButton* add = makeAdd();
    add->setObjectName(QStringLiteral("add-window"));
    auto* remove = iconButton("bin", tr("Remove the clip window"));
    connect(remove, &QToolButton::clicked, this, [this] { app::removeWindow(session_); });
    for (const auto& name : {tr("Add"), tr("Cut out"), tr("Intersect")})
        operation_->addItem(name);
    operation_->setAccessibleName(tr("Operation"));
    operation_->setToolTip(tr("What the window does with those above it"));
    connect(operation_, &ToolList::done, this, &WindowPanel::entered);
    connect(operation_, &QComboBox::activated, this, [this](int chosen) {
        if (const auto number = session_.windowNumber())
            list_->model()->setData(list_->model()->index(int(*number), 0), chosen,
                                    WindowModel::OperationRole);
    });
    auto* row = new QHBoxLayout;
    row->setContentsMargins(space::dockMargin - 4, 2, space::dockMargin, 2);
    row->addWidget(add);
    row->addWidget(remove);
    row->addStretch();
    row->addWidget(operation_);
    auto* tools = new QWidget;
    tools->setLayout(row);
    return tools;
}

QMenu* WindowPanel::makeAddMenu()
{
    auto* menu = new QMenu(this);
    for (const app::WindowKind& kind : app::windowKinds()) {
        const QString name = QCoreApplication::translate("WindowKinds", kind.name.data());
        menu->addAction(icon(kind.key), name, this, [this, &kind] {
            const clipping::Window page = session_.now().page().rectangle();
            const auto quarter = (page.max - page.min) * 0.25;
            app::addWindow(session_,
                           {.shape = kind.make({page.min + quarter, page.max - quarter})});
        });
    }
    menu->addSeparator();
    QAction* selected = menu->addAction(tr("Selected objects"), this, [this] {
        app::addWindows(session_, app::windowsOfSelection(session_),
                        tr("Make clip windows of selection"));
    });
    connect(menu, &QMenu::aboutToShow, this,
            [this, selected] { selected->setEnabled(!app::windowsOfSelection(session_).empty()); });
    return menu;
}

QWidget* WindowPanel::makeOffer()
{
    auto* text = new QLabel(tr("There is no clip window, so nothing is cut. Draw one (W), or:"));
    text->setWordWrap(true);
    auto* button = new QPushButton(tr("Lay window on page"));
    button->setToolTip(tr("Add a clip window that covers the whole page"));
    connect(button, &QPushButton::clicked, this, [this] {
        layWindowOnPage(session_);
        fields_[X]->setFocus(); // its numbers are typed next
    });
    auto* row = new QHBoxLayout;
    row->addWidget(text, 1);
    row->addWidget(button, 0, Qt::AlignVCenter);
    row->addWidget(makeAdd());
    row->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                            space::dockMargin);
    auto* column = new QVBoxLayout;
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addStretch();
    auto* offer = new QWidget;
    offer->setLayout(column);
    return offer;
}

void WindowPanel::follow()
{
    pages_->setCurrentIndex(session_.windows().list.empty() ? 1 : 0);
    const auto number = session_.windowNumber();
    operation_->setEnabled(number.has_value());
    chain_->setEnabled(number.has_value());
    for (LengthField* field : fields_)
        field->setEnabled(number.has_value());
    if (number)
        operation_->setCurrentIndex(int(session_.windows().list[*number].operation));
    const auto& frame = session_.windowFrame();
    const clipping::Window window = frame ? frame->box : session_.window();
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
    if (!session_.windowFrame())
        return;
    const app::WindowShape& shape = session_.windows().list[*session_.windowNumber()].shape;
    const app::WindowFrame frame = *session_.windowFrame();
    const clipping::Window& before = frame.box;
    const app::Point origin = app::originOf(session_.now().page(), session_.display().unit);
    const double place = field == X ? origin.x : field == Y ? origin.y : 0;
    const clipping::Window after = edited(before, field, place + length, chain_->isChecked());
    if (after != before)
        app::setWindowShape(
            session_,
            app::fitted(shape, field == X || field == Y ? app::WindowFrame{after, frame.angle}
                                                        : app::resized(frame, after)),
            field == X || field == Y ? tr("Move clip window") : tr("Resize clip window"), merging);
}

} // namespace ui

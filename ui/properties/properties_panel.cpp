// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/properties_panel.h"

#include "app/session/units.h"
#include "ui/look/text.h"
#include "ui/properties/selection_panel.h"
#include "ui/properties/style_panel.h"

#include <QVBoxLayout>

namespace ui {

PropertiesPanel::PropertiesPanel(app::Session& session, Canvas& canvas, QWidget* parent)
    : QWidget(parent), session_(session), numbers_(new SelectionPanel(session)),
      style_(new StylePanel(session, canvas))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(style_); // first: it stays in its place when something is selected
    column->addWidget(numbers_);
    column->addStretch(1);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    const auto forward = [this](auto* part) {
        using Part = std::remove_pointer_t<decltype(part)>;
        connect(part, &Part::entered, this, &PropertiesPanel::entered);
        connect(part, &Part::refused, this, &PropertiesPanel::refused);
        connect(part, &Part::taken, this, &PropertiesPanel::taken);
    };
    forward(numbers_);
    forward(style_);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &PropertiesPanel::follow);
    const auto soon = [this] { soon_.start(0); };
    connect(&session, &app::Session::selectionChanged, this, soon);
    connect(&session.nodes, &app::NodeEditing::changed, this, soon);
    connect(&session.document, &app::EditedDocument::changed, this, soon);
    follow();
}

bool PropertiesPanel::isSomethingSelected() const
{
    return !session_.selection().empty() || session_.nodes.someSelected();
}

void PropertiesPanel::follow()
{
    numbers_->setVisible(isSomethingSelected());
    emit titled(title());
}

QString PropertiesPanel::title() const
{
    return isSomethingSelected() ? app::selectionText(session_)
                                 : Text::tr("nothing selected, pen for new objects");
}

QSize PropertiesPanel::sizeHint() const
{
    return {QWidget::sizeHint().width(),
            numbers_->sizeHint().height() + style_->sizeHint().height()};
}

QSize PropertiesPanel::minimumSizeHint() const
{
    return {QWidget::minimumSizeHint().width(), sizeHint().height()};
}

} // namespace ui

#include "moc_properties_panel.cpp"

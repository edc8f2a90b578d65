// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/grid_dialog.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>

#include <cmath>

namespace ui {
namespace {

constexpr double mostDegrees = 360;

} // namespace

GridDialog::GridDialog(app::Session& session, QWidget* parent)
    : QDialog(parent), session_(session),
      along_(makeSpacing(Text::tr("Spacing along the lines"), &app::Grid::spacing)),
      across_(makeSpacing(Text::tr("Spacing across the lines"), &app::Grid::down)),
      angle_(new LengthField(Text::tr("Angle"), LengthField::Range::Any,
                             LengthField::Suffix::Degrees)),
      refusal_(new QLabel)
{
    setWindowTitle(Text::tr("Grid"));
    setObjectName(QStringLiteral("grid-dialog"));
    angle_->setToolTip(Text::tr("Counterclockwise from the right"));
    connect(angle_, &LengthField::edited, this, [this](double degrees) {
        if (std::abs(degrees) <= mostDegrees)
            return change(&app::Grid::angle, degrees);
        follow();
        refusal_->setText(Text::tr("The angle must be between −360° and 360°."));
    });
    connect(angle_, &LengthField::refused, refusal_, &QLabel::setText);
    connect(angle_, &LengthField::taken, refusal_, &QLabel::clear);
    auto* form = new QFormLayout;
    form->addRow(Text::tr("Spacing a&long the lines"), along_);
    form->addRow(Text::tr("Spacing ac&ross the lines"), across_);
    form->addRow(Text::tr("&Angle"), angle_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false); // Enter ends a field only
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refusal_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                               space::betweenGroups);
    column->setSpacing(space::betweenGroups);
    column->addLayout(form);
    column->addWidget(refusal_);
    column->addWidget(buttons);
    connect(&session, &app::Session::displayChanged, this, &GridDialog::follow);
    follow();
}

LengthField* GridDialog::makeSpacing(const QString& name, double app::Grid::*spacing)
{
    auto* field = new LengthField(name, LengthField::Range::NotNegative, LengthField::Suffix::Unit);
    connect(field, &LengthField::edited, this, [this, spacing](double length) {
        const double millimetres = length * session_.now().page().millimetresPerUnit();
        if (millimetres >= app::Grid::least && millimetres <= app::Grid::most)
            return change(spacing, millimetres);
        follow();
        refusal_->setText(
            Text::tr("The spacing must be between %1 mm and %2 mm on paper.")
                .arg(app::numberText(app::Grid::least, 3), app::numberText(app::Grid::most, 0)));
    });
    connect(field, &LengthField::refused, this,
            [this](const QString& sentence) { refusal_->setText(sentence); });
    connect(field, &LengthField::taken, this, [this] { refusal_->clear(); });
    return field;
}

void GridDialog::change(double app::Grid::*number, double value)
{
    refusal_->clear();
    session_.changeDisplay([&](app::Display& display) {
        display.grid.shown = true;
        display.grid.pattern = app::Grid::Pattern::Own;
        display.grid.*number = value;
    });
}

void GridDialog::follow()
{
    const app::Grid& grid = session_.display().grid;
    const app::Page& page = session_.now().page();
    const double unit = page.millimetresPerUnit(), real = page.realMillimetresPerUnit();
    along_->show(grid.spacing / unit, session_.display().unit, real);
    across_->show(grid.down / unit, session_.display().unit, real);
    angle_->show(grid.angle, app::Unit::User, 1);
}

} // namespace ui

#include "moc_grid_dialog.cpp"

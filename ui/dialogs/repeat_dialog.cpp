// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/repeat_dialog.h"

#include "app/base/numbers.h"
#include "app/drawing/typed_entry.h"
#include "app/session/arrange_selection.h"
#include "app/view/ruler.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"

#include <QDialogButtonBox>
#include <QFormLayout>

namespace ui {
namespace {

constexpr double usualGap = 5; // mm on paper

QSpinBox* makeCount(const QString& name, int least, int value)
{
    auto* field = new QSpinBox;
    field->setRange(least, app::mostCopies);
    field->setValue(value);
    field->setAccessibleName(name);
    field->setFixedHeight(space::fieldHeight);
    return field;
}

} // namespace

RepeatDialog::RepeatDialog(app::Session& session, QWidget* parent)
    : QDialog(parent), session_(session),
      box_(session.selectionBounds().value_or(clipping::Window{})),
      kind_(new Segments(Text::tr("Arrangement"),
                         {Text::tr("Rows and columns"), Text::tr("Around a point")})),
      pages_(new QStackedWidget), rows_(makeCount(Text::tr("Rows"), 1, 2)),
      columns_(makeCount(Text::tr("Columns"), 1, 3)), count_(makeCount(Text::tr("Number"), 2, 6)),
      result_(new QLabel), gap_(usualGap / session.now().page().millimetresPerUnit()),
      centre_(session.pivot.at())
{
    setWindowTitle(Text::tr("Repeat selection"));
    setObjectName(QStringLiteral("repeat-dialog"));
    kind_->choose(0);
    connect(kind_, &Segments::picked, pages_, &QStackedWidget::setCurrentIndex);
    connect(kind_, &Segments::picked, this, &RepeatDialog::follow);
    pages_->addWidget(makeGrid());
    pages_->addWidget(makeCircle());
    for (QSpinBox* field : {rows_, columns_, count_})
        connect(field, &QSpinBox::valueChanged, this, &RepeatDialog::follow);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(Text::tr("Cancel"), QDialogButtonBox::RejectRole);
    repeat_ = buttons->addButton(Text::tr("&Repeat"), QDialogButtonBox::AcceptRole);
    repeat_->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    result_->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                               space::betweenGroups);
    column->setSpacing(space::betweenGroups);
    column->addWidget(kind_, 0, Qt::AlignLeft);
    column->addWidget(pages_);
    column->addWidget(result_);
    column->addWidget(buttons);
    follow();
    rows_->setFocus(); // a number that is typed at once replaces the first value
    rows_->selectAll();
}

LengthField* RepeatDialog::makeField(const QString& name, double length)
{
    auto* field = new LengthField(name, LengthField::Range::Any, LengthField::Suffix::Unit);
    field->show(length, session_.display().unit, session_.now().page().realMillimetresPerUnit());
    connect(field, &LengthField::refused, result_, &QLabel::setText);
    connect(field, &LengthField::taken, this, &RepeatDialog::follow);
    return field;
}

QWidget* RepeatDialog::makeGrid()
{
    across_ = makeField(Text::tr("Gap between columns"), gap_.x);
    down_ = makeField(Text::tr("Gap between rows"), gap_.y);
    const auto keep = [this](double& kept) {
        return [this, &kept](double length) {
            kept = length;
            follow();
        };
    };
    connect(across_, &LengthField::edited, this, keep(gap_.x));
    connect(down_, &LengthField::edited, this, keep(gap_.y));
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(Text::tr("&Rows"), rows_);
    form->addRow(Text::tr("&Columns"), columns_);
    form->addRow(Text::tr("Gap between colu&mns"), across_);
    form->addRow(Text::tr("Gap between ro&ws"), down_);
    return page;
}

QWidget* RepeatDialog::makeCircle()
{
    const app::Point origin = app::originOf(session_.now().page(), session_.display().unit);
    x_ = makeField(Text::tr("Centre X"), centre_.x - origin.x);
    y_ = makeField(Text::tr("Centre Y"), centre_.y - origin.y);
    angle_ = new LengthField(Text::tr("Angle"), LengthField::Range::Any, LengthField::Suffix::None);
    angle_->show(degrees_, app::Unit::User, 1);
    connect(x_, &LengthField::edited, this, [this, origin](double x) {
        centre_.x = x + origin.x;
        follow();
    });
    connect(y_, &LengthField::edited, this, [this, origin](double y) {
        centre_.y = y + origin.y;
        follow();
    });
    connect(angle_, &LengthField::edited, this, [this](double degrees) {
        degrees_ = degrees;
        follow();
    });
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(Text::tr("&Number, with the original"), count_);
    form->addRow(Text::tr("&Angle in all, in degrees"), angle_);
    form->addRow(Text::tr("Centre &X"), x_);
    form->addRow(Text::tr("Centre &Y"), y_);
    return page;
}

std::vector<app::AffineMap> RepeatDialog::maps() const
{
    if (kind_->chosen() == 1)
        return app::circle(count_->value(), degrees_, centre_);
    return app::grid(rows_->value(), columns_->value(), box_.max - box_.min + gap_);
}

void RepeatDialog::follow()
{
    const double copies =
        kind_->chosen() == 1 ? count_->value() : double(rows_->value()) * double(columns_->value());
    const bool fits = copies * double(session_.selection().size()) <= 1e6;
    repeat_->setEnabled(fits);
    session_.setPreview({.copies = fits ? maps() : std::vector<app::AffineMap>()});
    result_->setText(fits ? Text::tr("%1 in all, with the original").arg(app::countText(copies))
                          : Text::tr("These would be too many objects. Make fewer copies."));
}

void RepeatDialog::accept()
{
    if (app::repeatSelection(session_, maps(), Text::tr("Repeat selection")))
        QDialog::accept();
}

/// After any answer, also Esc and the button of the window's frame.
void RepeatDialog::done(int result)
{
    session_.setPreview({});
    QDialog::done(result);
}

/// Over the panels at the right, so that it does not cover the copies.
void RepeatDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (event->spontaneous() || !parentWidget())
        return;
    const QRect window = parentWidget()->window()->frameGeometry();
    constexpr int below = 140; // pixels below the upper edge of the window: the bars
    move(window.right() - frameGeometry().width() - space::betweenGroups, window.top() + below);
}

} // namespace ui

#include "moc_repeat_dialog.cpp"

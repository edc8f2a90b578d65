// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/margin_dialog.h"

#include "app/session/window_places.h"
#include "ui/look/look.h"
#include "ui/widgets/length_field.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace ui {

namespace {

constexpr double usualMargin = 10; // mm on paper

} // namespace

MarginDialog::MarginDialog(app::Session& session, QWidget* parent)
    : QDialog(parent), session_(session),
      margin_(usualMargin / session.now().page().millimetresPerUnit())
{
    setWindowTitle(tr("Lay window inside margin"));
    setObjectName(QStringLiteral("margin-dialog"));
    auto* field = new LengthField(tr("Margin"), LengthField::Range::Any, LengthField::Suffix::Unit);
    field->show(margin_, session.display().unit, session.now().page().millimetresPerUnit());
    auto* sentence = new QLabel(tr("On each side of the page. A negative margin is outside it."));
    sentence->setForegroundRole(QPalette::PlaceholderText);
    connect(field, &LengthField::edited, this, [this](double margin) { margin_ = margin; });
    connect(field, &LengthField::refused, sentence, &QLabel::setText);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    QPushButton* lay = buttons->addButton(tr("&Lay window"), QDialogButtonBox::AcceptRole);
    lay->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                             space::betweenGroups);
    form->addRow(tr("&Margin"), field);
    form->addRow(sentence);
    form->addRow(buttons);
}

void MarginDialog::show(app::Session& session, QWidget& parent)
{
    auto* dialog = new MarginDialog(session, parent.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MarginDialog::accept()
{
    app::layWindowInside(session_, margin_);
    QDialog::accept();
}

} // namespace ui

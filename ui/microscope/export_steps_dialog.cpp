// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/export_steps_dialog.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPainter>
#include <QPushButton>

namespace ui {

namespace {

constexpr int previewWidth = 480;

/// A preview of the step as a slide.
QPixmap previewOf(const app::TraceExport& trace, std::size_t step, const QColor& border,
                  double ratio)
{
    const double scale = previewWidth / app::slideWidth;
    QPixmap picture((QSizeF(app::slideWidth, app::slideHeight) * scale * ratio).toSize());
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.scale(scale, scale);
    app::paintSlide(painter, {trace.tracedLine, trace.narration, step}, trace.parts, trace.ground);
    painter.setPen(QPen(border, 2 / scale));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(0, 0, app::slideWidth, app::slideHeight));
    return picture;
}

} // namespace

ExportStepsDialog::ExportStepsDialog(app::TraceExport trace, std::size_t step, QWidget* parent)
    : QDialog(parent), trace_(std::move(trace)), step_(step), preview_(new QLabel),
      format_(new QComboBox), ground_(new QComboBox),
      oneStep_(new QCheckBox(Text::tr("Only &this step (%1 of %2)")
                                 .arg(step + 1)
                                 .arg(std::max<std::size_t>(trace_.narration.steps.size(), 1)))),
      pictureOnly_(new QCheckBox(Text::tr("Only the &picture, without text and tables")))
{
    setWindowTitle(Text::tr("Export steps"));
    setObjectName(QStringLiteral("export-steps-dialog"));
    addFields();
    addButtons();
    refresh();
}

void ExportStepsDialog::addFields()
{
    for (const app::TraceFormat& format : app::traceFormats())
        format_->addItem(format.name);
    ground_->addItems({Text::tr("Light"), Text::tr("Dark")});
    ground_->setCurrentIndex(trace_.ground == app::Ground::Dark ? 1 : 0);
    preview_->setAccessibleName(Text::tr("Preview"));
    auto* form = new QFormLayout(this);
    form->setContentsMargins(space::betweenGroups, space::betweenGroups, space::betweenGroups,
                             space::betweenGroups);
    form->setVerticalSpacing(space::labelToField);
    form->addRow(preview_);
    form->addRow(Text::tr("File &type"), format_);
    form->addRow(Text::tr("&Colours"), ground_);
    form->addRow(QString(), oneStep_);
    form->addRow(QString(), pictureOnly_);
    for (const auto* box : {format_, ground_})
        connect(box, &QComboBox::currentIndexChanged, this, &ExportStepsDialog::refresh);
    connect(pictureOnly_, &QCheckBox::toggled, this, &ExportStepsDialog::refresh);
}

void ExportStepsDialog::addButtons()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* go = buttons->addButton(Text::tr("&Export…"), QDialogButtonBox::AcceptRole);
    go->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    static_cast<QFormLayout*>(layout())->addRow(buttons);
}

const app::TraceFormat& ExportStepsDialog::format() const
{
    return app::traceFormats()[std::size_t(format_->currentIndex())];
}

app::TraceExport ExportStepsDialog::trace() const
{
    app::TraceExport trace = trace_;
    if (oneStep_->isChecked())
        trace.only = step_;
    trace.parts = pictureOnly_->isChecked() ? app::SlideParts::Picture : app::SlideParts::All;
    trace.ground = ground_->currentIndex() == 1 ? app::Ground::Dark : app::Ground::Light;
    return trace;
}

void ExportStepsDialog::refresh()
{
    ground_->setEnabled(format().forPeople);
    pictureOnly_->setEnabled(format().forPeople);
    preview_->setPixmap(previewOf(trace(), step_, lookOf(palette()).border, devicePixelRatioF()));
}

} // namespace ui

#include "moc_export_steps_dialog.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/export_steps.h"

#include "app/base/text.h"
#include "app/settings/remembered.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

namespace ui {

namespace {

const QString folderKey = QStringLiteral("stepsFolder");

QString folder()
{
    const QString usual = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return app::rememberedFolder(folderKey, usual);
}

} // namespace

StepExports::StepExports(QWidget& window, const app::Microscope& microscope)
    : QObject(&window), window_(window), microscope_(microscope),
      questions_(std::make_unique<Questions>(window)), background_(&window)
{
}

void StepExports::ask()
{
    app::TraceExport trace{.tracedLine = microscope_.tracedLine(),
                           .narration = microscope_.narration()};
    if (lookOf(window_.palette()).dark)
        trace.ground = app::Ground::Dark;
    auto* dialog = new ExportStepsDialog(std::move(trace), microscope_.step(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { write(dialog->format(), dialog->trace()); });
    dialog->open();
}

/// The paths to write to, after asking about existing files; empty: cancelled.
QStringList StepExports::pathsFor(const app::TraceFormat& format, const app::TraceExport& trace)
{
    const QString ending = app::latin(format.ending);
    const bool several = format.files == app::TraceFormat::Files::OneAStep && !trace.only;
    const QString inFolder = folder() + u'/';
    const QString path =
        several ? questions_->filesToWrite(Text::tr("Choose how the file names begin"),
                                           inFolder + app::traceStem(trace) + u'.' + ending,
                                           format.name, ending)
                : questions_->fileToWrite(Text::tr("Export steps"),
                                          app::tracePaths(trace, format, inFolder).front(),
                                          format.name, ending);
    if (path.isEmpty())
        return {};
    QSettings().setValue(folderKey, QFileInfo(path).path());
    const QStringList paths = app::tracePaths(trace, format, path);
    const QStringList existing = several ? app::existingOf(paths) : QStringList();
    return existing.isEmpty() || questions_->overwriteFiles(existing, int(paths.size()))
               ? paths
               : QStringList();
}

void StepExports::write(const app::TraceFormat& format, const app::TraceExport& trace)
{
    const QStringList paths = pathsFor(format, trace);
    if (paths.isEmpty())
        return;
    using Painted = std::optional<std::vector<QByteArray>>; // empty: not enough memory
    background_.run(
        Text::tr("Painting %n steps…", nullptr, int(trace.steps().size())),
        [&format, trace](const app::Follower&) { return app::traceBytes(trace, format); },
        [this, paths](const std::optional<Painted>& painted) {
            if (painted) // otherwise cancelled before anything is written
                writePainted(paths, *painted);
        },
        InBackground::Cancel::Drops);
}

void StepExports::writePainted(const QStringList& paths,
                               const std::optional<std::vector<QByteArray>>& bytes)
{
    const auto error =
        bytes ? app::writeTrace(paths, *bytes)
              : std::optional(
                  Text::tr("There is not enough memory for the pictures. Export fewer steps."));
    if (error)
        emit told({Message::Kind::Warning, *error});
    else
        emit told({Message::Kind::Done, paths.size() == 1
                                            ? Text::tr("Wrote %1.").arg(paths.front())
                                            : Text::tr("Wrote %n files, the first of them %1.",
                                                       nullptr, int(paths.size()))
                                                  .arg(paths.front())});
}

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

#include "moc_export_steps.cpp"

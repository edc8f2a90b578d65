// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_sheet.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/export/export_path.h"
#include "ui/export/area_section.h"
#include "ui/export/export_preview.h"
#include "ui/export/format_tiles.h"
#include "ui/export/options_section.h"
#include "ui/export/result_section.h"
#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/look_label.h"

#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QVBoxLayout>

namespace ui {

ExportSheet::ExportSheet(app::Session& session, Files& files)
    : Sheet(QStringLiteral("export"), Text::tr("Export"), Width::Wide), session_(session),
      files_(files), live_(std::make_shared<app::LiveExport>(session)),
      preview_(new ExportPreview(session, live_)), formats_(new FormatTiles),
      area_(new AreaSection(session, *live_)), options_(new OptionsSection(*live_)),
      result_(new ResultSection(session, *live_)), file_(new QLineEdit), remark_(new LookLabel),
      copy_(plainButton(Text::tr("Copy"))), export_(plainButton(Text::tr("Export")))
{
    for (QWidget* section : std::initializer_list<QWidget*>{formats_, area_, options_, result_})
        body().addWidget(section);
    body().addStretch();
    addFile();
    addButtons();
    setPreview(preview_);
    connect(preview_, &ExportPreview::closeWanted, this, &Sheet::closeWanted);
    connect(preview_, &ExportPreview::entered, this, &ExportSheet::write);
    connect(formats_, &FormatTiles::picked, this, &ExportSheet::takeFormat);
    connect(live_.get(), &app::LiveExport::changed, this, &ExportSheet::follow);
    connect(&session, &app::Session::loaded, this, &Sheet::closeWanted);
    begin();
}

void ExportSheet::addFile()
{
    file_->setObjectName(QStringLiteral("export-file"));
    file_->setAccessibleName(Text::tr("File to write"));
    file_->setFixedHeight(space::fieldHeight);
    auto* choose = iconButton("folder", Text::tr("Choose where to write…"));
    choose->setObjectName(QStringLiteral("choose-export-file"));
    choose->setFocusPolicy(Qt::TabFocus);
    auto* row = new QHBoxLayout;
    row->setSpacing(space::labelToField);
    row->addWidget(file_, 1);
    row->addWidget(choose);
    aboveButtons().addLayout(row);
    remark_->setObjectName(QStringLiteral("export-file-remark"));
    remark_->setWordWrap(true);
    wearCaption(*remark_);
    aboveButtons().addWidget(remark_);
    connect(choose, &QToolButton::clicked, this, &ExportSheet::chooseFile);
    connect(file_, &QLineEdit::textChanged, this, &ExportSheet::showFile);
}

void ExportSheet::addButtons()
{
    auto* print = plainButton(Text::tr("Print…"));
    print->setObjectName(QStringLiteral("print-export"));
    print->setToolTip(Text::tr("Print the same area"));
    addToFoot(print, Side::Left);
    copy_->setObjectName(QStringLiteral("copy-export"));
    copy_->setToolTip(Text::tr("Put on the clipboard what would be written"));
    addToFoot(copy_, Side::Left);
    auto* cancel = plainButton(Text::tr("Cancel"));
    cancel->setObjectName(QStringLiteral("cancel-export"));
    addToFoot(cancel);
    connect(print, &QPushButton::clicked, this,
            [this] { emit printWanted(live_->job().choice.area); });
    export_->setObjectName(QStringLiteral("write-export"));
    wearFont(*export_, 1, QFont::DemiBold); // Enter presses it
    addToFoot(export_);
    connect(copy_, &QPushButton::clicked, this, [this] { files_.copyExport(live_->job()); });
    connect(cancel, &QPushButton::clicked, this, &Sheet::closeWanted);
    connect(export_, &QPushButton::clicked, this, &ExportSheet::write);
}

/// As at the last export of this drawing, or of any other in the last format.
void ExportSheet::begin()
{
    const auto last = files_.lastExport();
    app::ExportChoice choice = last ? last->choice : files_.usualExport();
    choice.area.window = session_.windowNumber().value_or(0);
    choice.area.layer = session_.pen.layer;
    if (last)
        setRemark(Text::tr("as last time for %1").arg(files_.name()));
    live_->change(std::move(choice));
    named_ = live_->job().choice.area;
    propose(last ? last->file : files_.exportProposal(live_->job().choice));
    formats_->choose(app::formatOf(live_->choice()));
    follow();
}

/// As long as the person has not given the file another name.
void ExportSheet::propose(const QString& path)
{
    proposed_ = app::shownPath(path);
    file_->setText(proposed_);
}

void ExportSheet::follow()
{
    // The name says what is in the file, so that no part of a drawing replaces another one.
    if (const app::ExportChoice choice = live_->job().choice; choice.area != named_) {
        named_ = choice.area;
        if (file_->text() == proposed_)
            propose(QFileInfo(path()).dir().filePath(
                QFileInfo(files_.exportProposal(choice)).fileName()));
    }
    area_->follow();
    options_->follow();
    result_->follow();
    showFile();
    for (QPushButton* button : {export_, copy_})
        button->setEnabled(live_->error().isEmpty());
    const auto& made = live_->made();
    const QString name = app::formatOf(live_->choice()).shortName();
    const std::size_t paths = made ? made->facts.paths : 0;
    const QString written = paths == 1 ? Text::tr("%1, 1 path").arg(name)
                                       : Text::tr("%1, %2 paths").arg(name, app::countText(paths));
    emit summed(made ? written : name);
}

/// What was last chosen for this format; the area stays.
void ExportSheet::takeFormat(const app::Format& format)
{
    app::ExportChoice choice = files_.usualExport(format);
    choice.area = live_->choice().area;
    const QString renamed = app::withEnding(path(), format);
    file_->text() == proposed_ ? propose(renamed) : file_->setText(app::shownPath(renamed));
    live_->change(std::move(choice));
}

QString ExportSheet::path() const
{
    return app::writtenPath(file_->text(), app::formatOf(live_->choice()));
}

void ExportSheet::chooseFile()
{
    const app::Format& format = app::formatOf(live_->choice());
    const QString chosen = files_.questions().fileToWrite(Text::tr("Export"), path(), format.name,
                                                          app::latin(format.key));
    if (!chosen.isEmpty())
        file_->setText(app::shownPath(chosen));
}

void ExportSheet::showFile()
{
    app::PathRemark remark = app::remarkOn(path());
    if (const QString why = files_.refusalToWrite(path()); !why.isEmpty())
        remark = {why, true};
    remark_->setText(remark.text);
    remark_->setVisible(!remark.text.isEmpty());
    remark_->setColour([impossible = remark.isFault](const Look& look) {
        return impossible ? errorColour(look) : look.muted;
    });
}

/// The sheet stays if nothing was written, so that nothing that was chosen is lost.
void ExportSheet::write()
{
    if (!live_->error().isEmpty())
        return;
    files_.exportTo(live_->job(), path(), [sheet = QPointer(this)](bool written) {
        if (written && sheet)
            emit sheet->closeWanted();
    });
}

/// What no field took. Enter in a field with a number only takes the number.
void ExportSheet::keyPressEvent(QKeyEvent* event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && options_->isAncestorOf(focusWidget()))
        return;
    if (enter)
        return write();
    Sheet::keyPressEvent(event);
}

} // namespace ui

#include "moc_export_sheet.cpp"

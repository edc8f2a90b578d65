// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/sheets_section.h"

#include "app/base/numbers.h"
#include "app/tiles/sheet_names.h"
#include "app/tiles/sheet_settings.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/refusal_frame.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tool_list.h"

#include <QScopedValueRollback>
#include <QSpinBox>

namespace ui {
namespace {

constexpr int numberWidth = 72, lengthWidth = 104;

QSpinBox* countField(const QString& name)
{
    auto* field = new QSpinBox;
    field->setRange(1, app::mostTiles);
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    field->setFixedHeight(space::fieldHeight);
    field->setMinimumWidth(numberWidth);
    return field;
}

} // namespace

SheetsSection::SheetsSection(app::Session& session, app::LiveSheets& sheets, QWidget* parent)
    : Section(Text::tr("Sheets"), parent), session_(session), sheets_(sheets), paper_(new ToolList),
      turn_(new Segments(Text::tr("Orientation"), {Text::tr("Portrait"), Text::tr("Landscape")})),
      by_(new Segments(Text::tr("Cut by"), {Text::tr("Paper size"), Text::tr("Number")})),
      columns_(countField(Text::tr("Columns"))), rows_(countField(Text::tr("Rows"))),
      scale_(new QDoubleSpinBox), size_(new ElidedLabel), remark_(new LookLabel)
{
    addPaper();
    addNumbers();
    addLengths();
    remark_->setWordWrap(true);
    remark_->setFont(captionFont(font()));
    remark_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    remark_->setFixedHeight(2 * QFontMetrics(remark_->font()).lineSpacing());
    remark_->setObjectName(QStringLiteral("sheets-remark"));
    addWide(remark_);
    connect(&sheets, &app::LiveSheets::changed, this, &SheetsSection::follow);
    connect(&sheets, &app::LiveSheets::openChanged, this, &SheetsSection::follow);
    connect(&session, &app::Session::displayChanged, this, &SheetsSection::follow); // the unit
    follow();
}

void SheetsSection::addPaper()
{
    paper_->addItems(app::papers());
    paper_->setAccessibleName(Text::tr("Paper"));
    paper_->setObjectName(QStringLiteral("sheets-paper"));
    paper_->setFixedHeight(space::fieldHeight);
    turn_->setIcons({"portrait", "landscape"});
    turn_->setObjectName(QStringLiteral("sheets-orientation"));
    by_->setObjectName(QStringLiteral("sheets-by"));
    addRow(Text::tr("Paper"), {paper_, turn_});
    addRow(Text::tr("Cut by"), {by_});
    connect(paper_, &ToolList::done, this, &SheetsSection::entered);
    connect(paper_, &QComboBox::currentTextChanged, this, [this](const QString& paper) {
        change(paper_, [&](app::SheetSettings& next) { next.paper = paper; });
    });
    connect(turn_, &Segments::picked, this, [this](int chosen) {
        change(turn_, [&](app::SheetSettings& next) { next.landscape = chosen == 1; });
    });
    // By number, what there is now is the beginning.
    connect(by_, &Segments::picked, this, [this](int chosen) {
        change(by_, [&](app::SheetSettings& next) {
            next.byNumber = chosen == 1;
            next.plan.shift = app::Point(0);
            if (next.byNumber && sheets_.tiling()) {
                next.plan.columns = sheets_.tiling().value->pageColumns();
                next.plan.rows = sheets_.tiling().value->pageRows();
            }
        });
    });
}

void SheetsSection::addNumbers()
{
    columns_->setObjectName(QStringLiteral("sheets-columns"));
    rows_->setObjectName(QStringLiteral("sheets-rows"));
    auto* beside = addRow(Text::tr("Columns"), {columns_});
    auto* label = quietLabel(Text::tr("Rows"));
    label->setBuddy(rows_);
    beside->insertWidget(1, label);
    beside->insertWidget(2, rows_);
    for (const auto& [field, member] :
         {std::pair(columns_, &app::TilePlan::columns), std::pair(rows_, &app::TilePlan::rows)})
        connect(field, &QSpinBox::valueChanged, this,
                [this, field = field, member = member](int n) {
                    change(field, [&](app::SheetSettings& next) { next.plan.*member = n; });
                });
}

LengthField* SheetsSection::addLength(const QString& name, double app::TilePlan::*member,
                                      const QString& remark)
{
    auto* field = new LengthField(name, LengthField::Range::NotNegative, LengthField::Suffix::Unit);
    field->setFixedWidth(lengthWidth);
    addRow(name, {field, quietLabel(remark)});
    connect(field, &LengthField::edited, this, [this, field, member](double length) {
        change(field, [&](app::SheetSettings& next) { next.plan.*member = length; });
    });
    connect(field, &LengthField::refused, this,
            [this, field](const QString& sentence) { refuse(field, sentence); });
    connect(field, &LengthField::entered, this, &SheetsSection::entered);
    return field;
}

void SheetsSection::addLengths()
{
    overlap_ = addLength(Text::tr("Overlap"), &app::TilePlan::overlap, {});
    margin_ = addLength(Text::tr("Margins"), &app::TilePlan::margin, Text::tr("all four"));
    overlap_->setObjectName(QStringLiteral("sheets-overlap"));
    margin_->setObjectName(QStringLiteral("sheets-margin"));
    scale_->setRange(0.1, 100'000);
    scale_->setDecimals(1);
    scale_->setSingleStep(10);
    scale_->setSuffix(Text::tr(" %"));
    scale_->setKeyboardTracking(false);
    scale_->setAccessibleName(Text::tr("Scale"));
    scale_->setToolTip(Text::tr("The size of the drawing on the sheets"));
    scale_->setObjectName(QStringLiteral("sheets-scale"));
    scale_->setFixedHeight(space::fieldHeight);
    scale_->setFixedWidth(lengthWidth);
    size_->setForegroundRole(QPalette::PlaceholderText); // its width is no reason for a wider sheet
    addRow(Text::tr("Scale"), {scale_, size_});
    connect(scale_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
        change(scale_, [&](app::SheetSettings& next) { next.plan.scale = percent / 100; });
    });
}

void SheetsSection::change(QWidget* field, const std::function<void(app::SheetSettings&)>& edit)
{
    if (following_)
        return;
    app::SheetSettings next = sheets_.settings();
    edit(next);
    withdraw();
    const auto refusal = sheets_.change(std::move(next));
    follow(); // the old value stays
    if (refusal)
        refuse(field, *refusal);
}

void SheetsSection::refuse(QWidget* field, const QString& sentence)
{
    withdraw();
    RefusalFrame*& frame = frames_[field];
    if (!frame) {
        frame = new RefusalFrame(*field);
        connect(frame, &RefusalFrame::typed, this, &SheetsSection::withdraw);
    }
    frame->show();
    frame->raise();
    say(sentence);
}

void SheetsSection::say(const QString& sentence)
{
    refused_ = sentence;
    showRemark();
}

/// A refusal, or else which sheets lie beyond the page.
void SheetsSection::showRemark()
{
    const auto& tiling = sheets_.tiling();
    const QString beyond = tiling ? app::beyondText(*tiling.value) : QString();
    remark_->setColour([refused = !refused_.isEmpty()](const Look& look) {
        return refused ? errorColour(look) : look.muted;
    });
    remark_->setText(refused_.isEmpty() ? beyond : refused_);
}

void SheetsSection::withdraw()
{
    for (RefusalFrame* frame : frames_)
        frame->hide();
    say({});
}

void SheetsSection::follow()
{
    if (!sheets_.isOpen())
        return;
    const QScopedValueRollback quiet(following_, true);
    const app::SheetSettings& now = sheets_.settings();
    const app::Unit unit = session_.now().page().paperUnit(session_.display().unit);
    const bool byNumber = now.byNumber;
    paper_->setCurrentText(now.paper);
    paper_->setEnabled(!byNumber);
    turn_->choose(now.landscape ? 1 : 0);
    turn_->setEnabled(!byNumber);
    by_->choose(byNumber ? 1 : 0);
    overlap_->show(now.plan.overlap, unit, 1);
    margin_->show(now.plan.margin, unit, 1);
    scale_->setValue(now.plan.scale * 100);
    columns_->setEnabled(byNumber);
    rows_->setEnabled(byNumber);
    const QString why = byNumber
                            ? Text::tr("For the page. Sheets are added for what lies beyond it.")
                            : Text::tr("Choose “Number” to set it.");
    columns_->setToolTip(why);
    rows_->setToolTip(why);
    const QString whyNoPaper = byNumber ? Text::tr("Choose “Paper size” to set it.") : QString();
    paper_->setToolTip(whyNoPaper);
    turn_->setToolTip(whyNoPaper);
    showRemark();
    const auto& tiling = sheets_.tiling();
    columns_->setValue(byNumber || !tiling ? now.plan.columns : tiling.value->columns);
    rows_->setValue(byNumber || !tiling ? now.plan.rows : tiling.value->rows);
    if (!tiling) {
        setRemark({});
        return size_->setWhole({});
    }
    setRemark(app::gridText(*tiling.value));
    size_->setWhole(Text::tr("%1 × %2 mm")
                        .arg(app::numberText(tiling.value->drawing.x, 0),
                             app::numberText(tiling.value->drawing.y, 0)));
}

} // namespace ui

#include "moc_sheets_section.cpp"

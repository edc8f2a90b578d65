// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/arrange_row.h"

#include "app/base/text.h"
#include "app/session/arrange_selection.h"
#include "app/session/arrangements.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/tool_list.h"

#include <QHBoxLayout>

#include <array>

namespace ui {
namespace {

constexpr int betweenGroups = 8;

using Kind = app::Arrangement::Kind;
/// The groups of buttons, from left to right.
constexpr std::array shownKinds{Kind::Turn, Kind::Align, Kind::Spread};

} // namespace

ArrangeRow::ArrangeRow(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), target_(new ToolList),
      strokes_(new QCheckBox(Text::tr("Scale strokes")))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    addButtons(*row);
    addOptions(*row);
    connect(&session, &app::Session::selectionChanged, this, &ArrangeRow::follow);
    connect(&session, &app::Session::displayChanged, this, &ArrangeRow::follow);
    connect(&KeyNews::get(), &KeyNews::changed, this, &ArrangeRow::follow);
    connect(&session.document, &app::EditedDocument::changed, this, &ArrangeRow::follow,
            Qt::QueuedConnection); // the selection may not be updated yet
}

void ArrangeRow::addButtons(QHBoxLayout& row)
{
    for (const Kind kind : shownKinds) {
        for (const app::Arrangement& how : app::arrangements())
            if (how.button && how.kind == kind) {
                buttons_.push_back({makeButton(how), &how});
                row.addWidget(buttons_.back().first);
            }
        row.addSpacing(betweenGroups);
    }
}

QToolButton* ArrangeRow::makeButton(const app::Arrangement& how)
{
    auto* button = new QToolButton;
    button->setIcon(icon(how.key));
    button->setIconSize({18, 18});
    button->setAutoRaise(true);
    button->setFixedSize(space::toolButton, space::toolButton);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(how.name);
    connect(button, &QToolButton::clicked, this, [this, &how] { how.run(session_); });
    return button;
}

void ArrangeRow::addOptions(QHBoxLayout& row)
{
    for (const app::AlignmentTarget& target : app::alignmentTargets())
        target_->addItem(target.listed);
    target_->setObjectName(QStringLiteral("align-to"));
    target_->setFixedHeight(space::fieldHeight);
    target_->setAccessibleName(Text::tr("Align and spread"));
    connect(target_, &QComboBox::activated, this, [this](int index) {
        app::alignTo(session_, app::alignmentTargets()[std::size_t(index)]);
    });
    connect(target_, &ToolList::done, this, &ArrangeRow::done);
    strokes_->setObjectName(QStringLiteral("scale-strokes"));
    strokes_->setToolTip(Text::tr("Widths and dashes of strokes are scaled with the objects"));
    strokes_->setFocusPolicy(Qt::TabFocus);
    connect(strokes_, &QCheckBox::clicked, this, [this](bool on) {
        app::scaleStrokes(session_, on ? app::StrokeScaling::Scale : app::StrokeScaling::Keep);
    });
    row.addWidget(target_);
    row.addSpacing(betweenGroups);
    row.addWidget(strokes_);
}

void ArrangeRow::showOptions(bool shown)
{
    target_->setVisible(shown);
    strokes_->setVisible(shown);
    layout()->invalidate(); // or its size is that of before, until events are handled
}

void ArrangeRow::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    follow();
}

/// The tooltip of a disabled button says why. Asks nothing while it is hidden.
void ArrangeRow::follow()
{
    if (!isVisible())
        return;
    for (const auto& [button, how] : buttons_) {
        const QString why = app::refusal(*how, session_);
        const QString name = app::withKeys(how->name + " ({" + app::latin(how->key) + "})");
        button->setEnabled(why.isEmpty());
        button->setToolTip(why.isEmpty() ? name : name + u'\n' + why);
        button->setAccessibleDescription(why);
    }
    const app::AlignmentTarget& target = app::alignmentTarget(session_);
    target_->setCurrentIndex(int(&target - app::alignmentTargets().data()));
    target_->setToolTip(Text::tr("Align and spread %1").arg(target.listed));
    strokes_->setChecked(session_.arrange.strokes == app::StrokeScaling::Scale);
}

} // namespace ui

#include "moc_arrange_row.cpp"

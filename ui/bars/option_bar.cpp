// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"

#include "app/commands/set_style.h"
#include "ui/bars/grid_choice.h"
#include "ui/bars/snap_choice.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/widgets/dash_icon.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tool_list.h"

#include <QAction>
#include <QColorDialog>
#include <QPainter>
#include <QResizeEvent>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int steps = 5;

/// A square in the stroke's own colour; struck through for no stroke.
QIcon strokeColourIcon(const std::optional<app::Colour>& colour, const Look& look)
{
    QPixmap picture(32, 32);
    picture.setDevicePixelRatio(2);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    const QRect square(1, 1, 14, 14);
    painter.fillRect(square, colour
                                 ? QColor(colour->red, colour->green, colour->blue, colour->alpha)
                                 : look.base);
    painter.setPen(look.control); // black on a dark bar, too
    painter.drawRect(square.adjusted(0, 0, -1, -1));
    if (!colour)
        painter.drawLine(square.bottomLeft(), square.topRight());
    return picture;
}

/// Shows the action's first shortcut in its tooltip, also after its text has changed.
void showKeyInTip(QAction& action)
{
    const auto refresh = [&action] {
        const QString text = action.iconText().remove(u'…');
        action.setToolTip(OptionBar::tr("%1 (%2)").arg(
            text, action.shortcut().toString(QKeySequence::NativeText)));
    };
    QObject::connect(&action, &QAction::changed, &action, refresh);
    refresh();
}

} // namespace

OptionBar::OptionBar(app::Session& session, Canvas& canvas)
    : QToolBar(tr("Tool options")), session_(session), strokeColour_(new QToolButton),
      width_(new LengthField(tr("Stroke width"), LengthField::Range::NotNegative,
                             LengthField::Suffix::Unit)),
      dashes_(new ToolList), snapping_(new SnapChoice(canvas)), grid_(new GridChoice(session)),
      keep_(new Segments(tr("Keep"), {tr("Inside"), tr("Outside")})),
      removed_(new Segments(tr("Removed part"), {tr("Ghosted"), tr("Hidden"), tr("Shown")})),
      panes_(new Segments(tr("Panes"), {tr("1"), tr("2"), tr("4"), tr("All")})),
      export_(new QToolButton)
{
    setObjectName(QStringLiteral("options"));
    setIconSize({18, 18});
    setFixedHeight(space::optionsHeight);
    setContentsMargins(6, 0, 8, 0);
    addSeparator();
    addStroke();
    const auto focusCanvas = [&canvas] { canvas.setFocus(); };
    connect(dashes_, &ToolList::done, &canvas, focusCanvas);
    addSeparator();
    addWidget(snapping_);
    addWidget(grid_);
    for (LengthField* field : {width_, &grid_->spacing()}) {
        connect(field, &LengthField::entered, &canvas, focusCanvas);
        connect(field, &LengthField::refused, this, &OptionBar::refused);
        connect(field, &LengthField::taken, this, &OptionBar::taken);
    }
    addSeparator();
    addClipping();
    addSeparator();
    addPanes(canvas);
    auto* room = new QWidget;
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(room);
    addExport();
    connect(&session, &app::Session::displayChanged, this, &OptionBar::followDisplay);
    connect(&session, &app::Session::selectionChanged, this, &OptionBar::followStyle);
    connect(&session, &app::Session::loaded, this, &OptionBar::followStyle, Qt::QueuedConnection);
    connect(&session.document, &app::EditedDocument::changed, this, &OptionBar::followDisplay);
    followDisplay();
    paintIcons();
}

void OptionBar::addStroke()
{
    strokeColour_->setToolTip(tr("Stroke colour"));
    strokeColour_->setAccessibleName(tr("Stroke colour"));
    strokeColour_->setAutoRaise(true);
    addWidget(strokeColour_);
    addCaption(tr("Stroke"))->setForegroundRole(QPalette::WindowText);
    width_->setToolTip(tr("Stroke width"));
    width_->setFixedWidth(width_->fontMetrics().horizontalAdvance(QStringLiteral("00.000 mm"))
                          + 28);
    addWidget(width_);
    dashes_->setToolTip(tr("Dashes"));
    dashes_->setAccessibleName(tr("Dashes"));
    dashes_->setIconSize({36, 12});
    dashes_->setFixedSize(72, space::fieldHeight);
    for (std::size_t i = 0; i < dashPatterns().size(); ++i)
        dashes_->addItem(QString());
    for (int i = 0; i < dashes_->count(); ++i)
        dashes_->setItemData(i, dashPatterns()[std::size_t(i)].name, Qt::AccessibleTextRole);
    addWidget(dashes_);

    connect(strokeColour_, &QToolButton::clicked, this, &OptionBar::chooseStrokeColour);
    connect(width_, &LengthField::edited, this, [this](double width, app::Merging merging) {
        restyle([width](app::Style& style) { style.width = width; }, tr("Stroke width"), merging);
    });
    connect(dashes_, &QComboBox::activated, this, [this](int index) {
        const auto& pattern = dashPatterns()[std::size_t(index)];
        restyle([&](app::Style& style) { style.dashes = scaled(pattern, style.width); },
                tr("Dashes"), app::Merging::WithLast);
    });
}

void OptionBar::addClipping()
{
    addCaption(tr("Keep"));
    addWidget(keep_);
    addSeparator();
    addCaption(tr("Removed part"));
    addWidget(removed_);
    connect(keep_, &Segments::picked, this,
            [this](int index) { setKeep(session_, app::Keep(index)); });
    connect(removed_, &Segments::picked, this, [this](int index) {
        session_.changeDisplay(
            [index](app::Display& display) { display.removed = app::RemovedPart(index); });
    });
}

void OptionBar::addPanes(Canvas& canvas)
{
    // Pane counts; the last choice is all.
    static constexpr std::array<std::size_t, 3> counts{1, 2, 4};
    addCaption(tr("Panes"));
    panes_->setObjectName(QStringLiteral("panes"));
    addWidget(panes_);
    panes_->setToolTip(tr("Show the drawing in several panes, each with its own algorithm (Ctrl+1, "
                          "Ctrl+2, Ctrl+4, Ctrl+9)"));
    connect(panes_, &Segments::picked, this, [&canvas](int index) {
        app::Panes panes = canvas.panes();
        std::size_t(index) < counts.size() ? panes.show(counts[std::size_t(index)])
                                           : panes.showAll();
        canvas.setPanes(panes);
        canvas.setFocus();
    });
    const auto follow = [this, &canvas] {
        const app::Panes& panes = canvas.panes();
        const auto count = std::ranges::find(counts, panes.size());
        if (panes.showsAll())
            panes_->choose(int(counts.size()));
        else if (count != counts.end())
            panes_->choose(int(count - counts.begin()));
        else
            panes_->chooseNone();
    };
    connect(&canvas, &Canvas::panesChanged, this, follow);
    follow();
}

void OptionBar::addSteps(QAction& undo, QAction& redo)
{
    showKeyInTip(undo);
    showKeyInTip(redo);
    insertActions(actions().front(), {&undo, &redo});
}

void OptionBar::setExport(QAction& exportCut)
{
    showKeyInTip(exportCut);
    export_->setDefaultAction(&exportCut);
}

void OptionBar::addExport()
{
    export_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    export_->setFixedHeight(space::fieldHeight + 2);
    export_->setProperty("framed", true);
    addWidget(export_);
    export_->setAutoRaise(false); // which tool bars set
}

QLabel* OptionBar::addCaption(const QString& text)
{
    auto* caption = new QLabel(text);
    caption->setForegroundRole(QPalette::PlaceholderText);
    caption->setContentsMargins(2, 0, 4, 0);
    addWidget(caption);
    captions_ << caption;
    return caption;
}

void OptionBar::resizeEvent(QResizeEvent* event)
{
    for (int step = 0; step < steps; ++step) {
        arrange(step);
        if (sizeHint().width() <= event->size().width())
            break;
    }
    QToolBar::resizeEvent(event);
}

/// Step 0 shows everything; each further step takes less room.
void OptionBar::arrange(int step)
{
    export_->setToolButtonStyle(step < 1 ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    for (QAction* action : actions())
        if (captions_.contains(qobject_cast<QLabel*>(widgetForAction(action))))
            action->setVisible(step < 2);
    grid_->showSpacing(step < 3);
    snapping_->showKinds(step < 4);
}

void OptionBar::changeEvent(QEvent* event)
{
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paintIcons();
}

/// Repaints the icons that are pixmaps, which do not follow the palette like other icons.
void OptionBar::paintIcons()
{
    const Look& look = lookOf(palette());
    for (int i = 0; i < dashes_->count(); ++i)
        dashes_->setItemIcon(i, dashIcon(dashPatterns()[std::size_t(i)], look.text));
    followStyle();
}

void OptionBar::followDisplay()
{
    keep_->choose(int(session_.now().windows().keep));
    removed_->choose(int(session_.display().removed));
    followStyle();
}

const app::Style& OptionBar::style() const
{
    const auto& selection = session_.selection();
    return selection.empty() ? session_.pen.style
                             : session_.now().objects()[selection.first()].style();
}

void OptionBar::followStyle()
{
    const app::Style& now = style();
    strokeColour_->setIcon(strokeColourIcon(now.stroke, lookOf(palette())));
    width_->show(now.width, session_.display().unit, session_.now().page().millimetresPerUnit());
    dashes_->setCurrentIndex(patternOf(now));
}

void OptionBar::restyle(const std::function<void(app::Style&)>& change, const QString& text,
                        app::Merging merging)
{
    change(session_.pen.style);
    if (!session_.selection().empty())
        session_.history.push(
            new app::SetStyle(session_.document, session_.selection(), change, text, merging));
    followStyle();
}

void OptionBar::chooseStrokeColour()
{
    const app::Colour now = style().stroke.value_or(app::Colour{});
    const QColor chosen =
        QColorDialog::getColor(QColor(now.red, now.green, now.blue, now.alpha), window(),
                               tr("Stroke colour"), QColorDialog::ShowAlphaChannel);
    if (!chosen.isValid())
        return;
    const app::Colour colour{std::uint8_t(chosen.red()), std::uint8_t(chosen.green()),
                             std::uint8_t(chosen.blue()), std::uint8_t(chosen.alpha())};
    restyle([colour](app::Style& style) { style.stroke = colour; }, tr("Stroke colour"),
            app::Merging::Never);
}

} // namespace ui

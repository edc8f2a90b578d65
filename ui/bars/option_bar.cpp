// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"

#include "app/drawing/dash_patterns.h"
#include "ui/bars/grid_choice.h"
#include "ui/bars/node_row.h"
#include "ui/bars/snap_choice.h"
#include "ui/bars/window_options.h"
#include "ui/editing/keeping.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/style/style_popup.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/tool_list.h"

#include <QAction>
#include <QLayout>
#include <QResizeEvent>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int steps = 6;

/// Shows the action's first shortcut in its tooltip, also after its text has changed.
void showKeyInTip(QAction& action)
{
    const auto refresh = [&action] {
        const QString text = action.text().remove(u'&').remove(u'…');
        action.setToolTip(
            Text::tr("%1 (%2)").arg(text, action.shortcut().toString(QKeySequence::NativeText)));
    };
    QObject::connect(&action, &QAction::changed, &action, refresh);
    refresh();
}

} // namespace

OptionBar::OptionBar(app::Session& session, Canvas& canvas)
    : QToolBar(Text::tr("Tool options")), session_(session),
      strokeColour_(new ColourChoice(session, canvas, &app::Style::stroke)),
      width_(new LengthField(Text::tr("Stroke width"), LengthField::Range::NotNegative,
                             LengthField::Suffix::Unit)),
      dashes_(new ToolList), style_(new QToolButton),
      stylePopup_(new StylePopup(session, canvas, *style_)), snapping_(new SnapChoice(canvas)),
      grid_(new GridChoice(session)),
      keep_(new Segments(Text::tr("Keep"), {Text::tr("Inside"), Text::tr("Outside")})),
      removed_(new Segments(Text::tr("Removed part"),
                            {Text::tr("Ghosted"), Text::tr("Hidden"), Text::tr("Shown")})),
      panes_(new Segments(Text::tr("Panes"),
                          {Text::tr("1"), Text::tr("2"), Text::tr("4"), Text::tr("All")})),
      window_(new WindowOptions(session, canvas)), nodes_(new NodeRow), tiles_(new QToolButton),
      export_(new QToolButton)
{
    setObjectName(QStringLiteral("options"));
    setIconSize({18, 18});
    setFixedHeight(space::optionsHeight);
    setContentsMargins(6, 0, 8, 0);
    addSeparator();
    const qsizetype before = actions().size();
    addStroke();
    ofOthers_ = actions().mid(before);
    windowShown_ = addWidget(window_);
    const auto focusCanvas = [&canvas] { canvas.setFocus(); };
    connect(dashes_, &ToolList::done, &canvas, focusCanvas);
    for (LengthField* field : {width_, &grid_->spacing()}) {
        connect(field, &LengthField::entered, &canvas, focusCanvas);
        connect(field, &LengthField::refused, this, &OptionBar::refused);
        connect(field, &LengthField::taken, this, &OptionBar::taken);
    }
    addClipping();
    addPanes(canvas);
    instead_ = actions().mid(1); // after the separator behind undo and redo
    nodesShown_ = addWidget(nodes_);
    auto* room = new QWidget;
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(room);
    addWidget(snapping_);
    addWidget(grid_);
    addSeparator();
    tilesPlace_ = addWidget(tiles_);
    addExport();
    connect(&session, &app::Session::displayChanged, this, &OptionBar::followDisplay);
    connect(&session, &app::Session::selectionChanged, this, &OptionBar::followStyle);
    connect(&session, &app::Session::loaded, this, &OptionBar::followDisplay, Qt::QueuedConnection);
    connect(&session.document, &app::EditedDocument::changed, this, &OptionBar::followDisplay);
    connect(&canvas, &Canvas::toolChanged, this, [this, &canvas] { showOptionsOf(canvas.tool()); });
    showOptionsOf(canvas.tool());
    followDisplay();
}

void OptionBar::showOptionsOf(std::string_view tool)
{
    tool_ = tool;
    nodesShown_->setVisible(tool_ == "nodes");
    for (QAction* action : instead_)
        action->setVisible(isOffered(action));
    fitInto(width());
}

bool OptionBar::isOffered(QAction* action) const
{
    if (tool_ == "nodes")
        return !instead_.contains(action);
    if ((ofWindows_.contains(action) && !hasWindows_)
        || (ofPanes_.contains(action) && !panesOffered_ && !hasPanes_))
        return false;
    return tool_ == "window" ? !ofOthers_.contains(action) : action != windowShown_;
}

void OptionBar::addStroke()
{
    addWidget(strokeColour_);
    addCaption(Text::tr("Stroke"))->setForegroundRole(QPalette::WindowText);
    width_->setToolTip(Text::tr("Stroke width"));
    new RoomForText(*width_, QStringLiteral("00.000 mm"), 28);
    addWidget(width_);
    dashes_->setToolTip(Text::tr("Dashes"));
    dashes_->setAccessibleName(Text::tr("Dashes"));
    dashes_->setIconSize({36, 12});
    dashes_->setFixedSize(72, space::fieldHeight);
    for (const app::DashPattern& pattern : app::dashPatterns()) {
        dashes_->addItem(dashIcon(pattern), QString());
        dashes_->setItemData(dashes_->count() - 1, pattern.name, Qt::AccessibleTextRole);
    }
    addWidget(dashes_);
    style_->setIcon(icon("style"));
    style_->setObjectName(QStringLiteral("style"));
    addWidget(style_);
    connect(style_, &QToolButton::clicked, stylePopup_, &StylePopup::open);
    connect(&stylePopup_->panel(), &StylePanel::refused, this, &OptionBar::refused);
    connect(&stylePopup_->panel(), &StylePanel::taken, this, &OptionBar::taken);
    connect(width_, &LengthField::edited, this, [this](double width, app::Merging merging) {
        app::restyle(
            session_, [width](app::Style& style) { app::setWidth(style, width); },
            Text::tr("Stroke width"), merging);
        followStyle();
    });
    connect(dashes_, &QComboBox::activated, this, [this](int index) {
        const auto& pattern = app::dashPatterns()[std::size_t(index)];
        app::restyle(
            session_, [&](app::Style& style) { style.dashes = app::scaled(pattern, style.width); },
            Text::tr("Dashes"), app::Merging::WithLast);
        followStyle();
    });
}

void OptionBar::setStyleCommand(QAction& style)
{
    showKeyInTip(style);
    style_->setToolTip(style.toolTip());
    style_->setAccessibleName(style.iconText().remove(u'…'));
}

void OptionBar::openStyle() { stylePopup_->open(); }

void OptionBar::takeColour(app::PaintPart part)
{
    const app::PaintPart shown = strokeColour_->part();
    strokeColour_->setPart(part);
    strokeColour_->startEyedropper();
    strokeColour_->setPart(shown);
}

void OptionBar::addClipping()
{
    const qsizetype before = actions().size();
    addSeparator();
    addCaption(Text::tr("Keep"));
    addWidget(keep_);
    ofOthers_ += actions().mid(before);
    addSeparator();
    addCaption(Text::tr("Removed part"));
    addWidget(removed_);
    ofWindows_ = actions().mid(before);
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
    const qsizetype before = actions().size();
    addSeparator();
    addCaption(Text::tr("Panes"));
    panes_->setObjectName(QStringLiteral("panes"));
    addWidget(panes_);
    ofPanes_ = actions().mid(before);
    panes_->setToolTip(
        Text::tr("Show the drawing in several panes, each with its own algorithm (Ctrl+1, "
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
        hasPanes_ = panes.size() > 1;
    };
    connect(&canvas, &Canvas::panesChanged, this, [this, follow] {
        follow();
        showOptionsOf(tool_);
    });
    follow();
}

void OptionBar::addNodeStep(QAction& step) { nodes_->add(step); }

void OptionBar::addSteps(QAction& undo, QAction& redo)
{
    showKeyInTip(undo);
    showKeyInTip(redo);
    insertActions(actions().front(), {&undo, &redo});
}

void OptionBar::setExport(QAction& exportCut)
{
    showKeyInTip(exportCut);
    exportCut.setIconText(Text::tr("Export…"));
    export_->setDefaultAction(&exportCut);
}

void OptionBar::setTiles(QAction& tiles)
{
    showKeyInTip(tiles);
    tiles_->setDefaultAction(&tiles);
    tiles_->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void OptionBar::offerTiles(bool offered)
{
    tilesOffered_ = offered;
    fitInto(width());
}

void OptionBar::offerPanes(bool offered)
{
    panesOffered_ = offered;
    showOptionsOf(tool_);
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
    fitInto(event->size().width());
    QToolBar::resizeEvent(event);
}

void OptionBar::fitInto(int width)
{
    for (int step = 0; step < steps; ++step) {
        arrange(step);
        if (sizeHint().width() <= width)
            break;
    }
}

/// Step 0 shows everything; each further step takes less room.
void OptionBar::arrange(int step)
{
    tilesPlace_->setVisible(step < 1 && tilesOffered_);
    export_->setToolButtonStyle(step < 5 ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    for (QAction* action : actions())
        if (captions_.contains(qobject_cast<QLabel*>(widgetForAction(action))))
            action->setVisible(step < 2 && isOffered(action));
    grid_->showSpacing(step < 3);
    snapping_->showKinds(step < 4);
    // Or the sizes are those of before, until events are handled.
    grid_->layout()->invalidate();
    snapping_->layout()->invalidate();
    layout()->invalidate();
}

void OptionBar::changeEvent(QEvent* event)
{
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::FontChange) // when its fields have followed, too
        QMetaObject::invokeMethod(
            this, [this] { fitInto(width()); }, Qt::QueuedConnection);
}

void OptionBar::followDisplay()
{
    keep_->choose(int(session_.now().windows().keep));
    removed_->choose(int(session_.display().removed));
    if (const bool has = !session_.now().windows().list.empty(); has != hasWindows_) {
        hasWindows_ = has;
        showOptionsOf(tool_);
    }
    followStyle();
}

void OptionBar::followStyle()
{
    const std::vector<app::Style> styles = app::shownStyles(session_);
    const app::Unit unit = session_.display().unit;
    const double size = session_.now().page().millimetresPerUnit();
    if (app::common(styles, &app::Style::width))
        width_->show(styles.front().width, unit, size);
    else
        width_->showMixed(styles.front().width, unit, size);
    const auto pattern = app::common(styles, app::patternOf).value_or(std::nullopt);
    dashes_->setCurrentIndex(pattern ? int(*pattern) : -1);
}

} // namespace ui

#include "moc_option_bar.cpp"

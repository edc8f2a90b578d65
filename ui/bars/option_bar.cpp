// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"

#include "app/base/text.h"
#include "ui/bars/arrange_row.h"
#include "ui/bars/grid_choice.h"
#include "ui/bars/node_row.h"
#include "ui/bars/shape_options.h"
#include "ui/bars/snap_choice.h"
#include "ui/bars/window_options.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/properties/stroke_row.h"
#include "ui/properties/style_popup.h"
#include "ui/tools/tool.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QAction>
#include <QHBoxLayout>
#include <QResizeEvent>
#include <QScopedValueRollback>

#include <algorithm>
#include <array>

namespace ui {

namespace {

constexpr int steps = 8;

/// Shows the action's first shortcut in its tooltip, also after its text has changed.
void showKeyInTip(QAction& action)
{
    const auto refresh = [&action] {
        action.setToolTip(nameWithKey(action.text().remove(u'&').remove(u'…'), action));
    };
    QObject::connect(&action, &QAction::changed, &action, refresh);
    refresh();
}

QWidget* emptyRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(space::labelToField);
    return row;
}

} // namespace

OptionBar::OptionBar(app::Session& session, Canvas& canvas)
    : QToolBar(Text::tr("Tool options")), session_(session), canvas_(canvas),
      tool_(new QToolButton), stroke_(new StrokeRow(session, canvas, StrokeRow::Frame::Fields)),
      style_(new QToolButton), arranging_(new ArrangeRow(session)),
      stylePopup_(new StylePopup(session, canvas, this)), grid_(new GridChoice(session)),
      shape_(new ShapeOptions(session, canvas)), capsule_(emptyRow()),
      removed_(new Segments(Text::tr("Removed part"),
                            {Text::tr("Ghosted"), Text::tr("Hidden"), Text::tr("Shown")})),
      panes_(new Segments(Text::tr("Panes"),
                          {Text::tr("1"), Text::tr("2"), Text::tr("4"), Text::tr("All")})),
      nodes_(new NodeRow), view_(emptyRow()), export_(new QToolButton)
{
    setObjectName(QStringLiteral("options"));
    setIconSize({18, 18});
    setFixedHeight(space::optionsHeight);
    setContentsMargins(6, 0, 8, 0);
    addSeparator();
    addTool();
    connect(arranging_, &ArrangeRow::done, &canvas, [&canvas] { canvas.setFocus(); });
    addGroup([&] { addWidget(new WindowOptions(session_, canvas_)); },
             [this] { return has(ToolInfo::Options::Window); });
    addCapsule();
    const auto draws = [this] { return has(ToolInfo::Options::Stroke); };
    addGroup([this] { addStroke(); },
             [this, draws] { return draws() || (arranges() && !canvas_.hasWholeCapsule()); });
    addGroup([this] { addStyle(); }, [this, draws] { return draws() || arranges(); });
    addGroup([this] { addWidget(arranging_); }, [this] { return arranges(); }, 7);
    addGroup([this] { addWidget(nodes_); }, [this] { return has(ToolInfo::Options::Nodes); });
    addGroup([this] { addWidget(view_); }, [this] { return has(ToolInfo::Options::View); });
    addGroup([this] { addWidget(shape_); }, [this] { return shape_->offersSome(); });
    connect(shape_, &ShapeOptions::refused, this, &OptionBar::refused);
    connect(shape_, &ShapeOptions::taken, this, &OptionBar::taken);
    addClipping();
    addPanes();
    addFixed();
    for (const auto signal : {&app::Session::displayChanged, &app::Session::selectionChanged})
        connect(&session, signal, this, &OptionBar::follow);
    connect(&session, &app::Session::loaded, this, &OptionBar::follow, Qt::QueuedConnection);
    connect(&session.document, &app::EditedDocument::changed, this, &OptionBar::follow);
    connect(&canvas, &Canvas::toolChanged, this, &OptionBar::follow);
    connect(&canvas, &Canvas::capsuleSwitched, this, &OptionBar::follow);
    follow();
}

void OptionBar::addGroup(const std::function<void()>& add, std::function<bool()> offered, int until)
{
    const qsizetype before = actions().size();
    add();
    groups_.push_back({actions().mid(before), std::move(offered), until});
}

bool OptionBar::has(ToolInfo::Options options) const
{
    return findTool(canvas_.tool())->options == options;
}

bool OptionBar::arranges() const
{
    return has(ToolInfo::Options::Arranging) && !session_.selection().empty();
}

/// With Select and nothing chosen, what is drawn next is in hand.
bool OptionBar::drawsOrRests() const
{
    return has(ToolInfo::Options::Stroke) || (rests() && !canvas_.hasCapsuleInBar());
}

bool OptionBar::rests() const
{
    return has(ToolInfo::Options::Arranging) && session_.selection().empty();
}

/// The capsule of a chosen clip window or of selected objects, if the person wants it in the bar.
void OptionBar::addCapsule()
{
    canvas_.setCapsuleBar(*capsule_);
    const auto shown = [this] { return canvas_.hasCapsuleInBar(); };
    addGroup([this] { addSeparator(); },
             [this, shown] { return shown() && has(ToolInfo::Options::Window); });
    addGroup([this] { addWidget(capsule_); }, shown);
    addGroup([this] { addSeparator(); }, [this, shown] { return shown() && arranges(); });
    connect(&canvas_, &Canvas::capsuleBarOutdated, this, [this] {
        if (fitting_)
            return;
        follow();
        fitInto(width());
    });
}

/// Only says what is in hand: the tools are at the side.
void OptionBar::addTool()
{
    tool_->setObjectName(QStringLiteral("tool-in-hand"));
    tool_->setAutoRaise(true);
    tool_->setFocusPolicy(Qt::NoFocus);
    tool_->setFont(semiBold(font()));
    tool_->setAttribute(Qt::WA_TransparentForMouseEvents);
    addWidget(tool_);
}

void OptionBar::addStroke()
{
    addWidget(stroke_);
    connect(&stroke_->width(), &LengthField::refused, this, &OptionBar::refused);
    connect(&stroke_->width(), &LengthField::taken, this, &OptionBar::taken);
}

void OptionBar::addStyle()
{
    style_->setIcon(icon("style"));
    style_->setObjectName(QStringLiteral("style"));
    style_->setAccessibleName(Text::tr("Style"));
    addWidget(style_);
    connect(style_, &QToolButton::clicked, this, &OptionBar::openStyle);
    connect(&stylePopup_->panel(), &StylePanel::refused, this, &OptionBar::refused);
    connect(&stylePopup_->panel(), &StylePanel::taken, this, &OptionBar::taken);
}

void OptionBar::setStyleCommand(QAction& style)
{
    showKeyInTip(style);
    style_->setToolTip(style.toolTip());
}

void OptionBar::openStyle() { stylePopup_->open(style_->isVisible() ? *style_ : *tool_); }

void OptionBar::takeColour(app::PaintPart part)
{
    ColourChoice& colour = stroke_->colour();
    const app::PaintPart shown = colour.part();
    colour.setPart(part);
    colour.startEyedropper();
    colour.setPart(shown);
}

void OptionBar::addClipping()
{
    const auto hasWindows = [this] { return !session_.now().windows().list.empty(); };
    addGroup(
        [this] {
            addSeparator();
            addCaption(Text::tr("Removed part"));
            addWidget(removed_);
        },
        [this, hasWindows] {
            return hasWindows() && (drawsOrRests() || rests() || has(ToolInfo::Options::Window));
        },
        3);
    connect(removed_, &Segments::picked, this, [this](int index) {
        session_.changeDisplay(
            [index](app::Display& display) { display.removed = app::RemovedPart(index); });
    });
}

void OptionBar::addPanes()
{
    // Pane counts; the last choice is all.
    static constexpr std::array<std::size_t, 3> counts{1, 2, 4};
    panes_->setObjectName(QStringLiteral("panes"));
    setKeyTip(*panes_, Text::tr("Show the drawing in several panes, each with its own algorithm "
                                "({panes-1}, {panes-2}, {panes-4}, {panes-all})"));
    addGroup(
        [this] {
            addSeparator();
            addCaption(Text::tr("Panes"));
            addWidget(panes_);
        },
        [this] {
            return !has(ToolInfo::Options::Nodes) && (panesOffered_ || canvas_.panes().size() > 1);
        });
    connect(panes_, &Segments::picked, this, [this](int index) {
        app::Panes panes = canvas_.panes();
        std::size_t(index) < counts.size() ? panes.show(counts[std::size_t(index)])
                                           : panes.showAll();
        canvas_.setPanes(panes);
        canvas_.setFocus();
    });
    const auto showCount = [this] {
        const app::Panes& panes = canvas_.panes();
        const auto count = std::ranges::find(counts, panes.size());
        if (panes.showsAll())
            panes_->choose(int(counts.size()));
        else if (count != counts.end())
            panes_->choose(int(count - counts.begin()));
        else
            panes_->chooseNone();
    };
    connect(&canvas_, &Canvas::panesChanged, this, [this, showCount] {
        showCount();
        follow();
    });
    showCount();
}

/// What has the same place with every tool.
void OptionBar::addFixed()
{
    auto* room = new QWidget;
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(room);
    addWidget(new SnapChoice(canvas_));
    addWidget(grid_);
    addSeparator();
    addExport();
    LengthField& spacing = grid_->spacing();
    connect(&spacing, &LengthField::entered, &canvas_, [this] { canvas_.setFocus(); });
    connect(&spacing, &LengthField::refused, this, &OptionBar::refused);
    connect(&spacing, &LengthField::taken, this, &OptionBar::taken);
}

void OptionBar::addNodeStep(QAction& step) { nodes_->add(step); }

void OptionBar::addViewStep(QAction& step)
{
    auto* button = new QToolButton;
    button->setProperty("framed", true);
    button->setFixedHeight(space::fieldHeight);
    button->setDefaultAction(&step);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    showKeyInTip(step);
    view_->layout()->addWidget(button);
}

void OptionBar::addSteps(QAction& undo, QAction& redo)
{
    showKeyInTip(undo);
    showKeyInTip(redo);
    insertActions(actions().front(), {&undo, &redo});
}

void OptionBar::setExport(QAction& exportSheet)
{
    showKeyInTip(exportSheet);
    exportSheet.setIconText(Text::tr("Export…"));
    export_->setDefaultAction(&exportSheet);
}

void OptionBar::offerPanes(bool offered)
{
    panesOffered_ = offered;
    follow();
}

void OptionBar::addExport()
{
    export_->setObjectName(QStringLiteral("export-button"));
    export_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    export_->setFixedHeight(space::fieldHeight + 2);
    export_->setProperty("framed", true);
    addWidget(export_);
    export_->setAutoRaise(false); // which tool bars set
}

QLabel* OptionBar::addCaption(const QString& text)
{
    QLabel* caption = quietLabel(text);
    caption->setContentsMargins(2, 0, 4, 0);
    captions_ << addWidget(caption);
    return caption;
}

void OptionBar::resizeEvent(QResizeEvent* event)
{
    fitInto(event->size().width());
    QToolBar::resizeEvent(event);
}

void OptionBar::fitInto(int width)
{
    const QScopedValueRollback guard(fitting_, true);
    for (int step = 0; step < steps; ++step) {
        arrange(step);
        if (sizeHint().width() <= width)
            break;
    }
}

/// Step 0 shows everything; each further step takes less room.
void OptionBar::arrange(int step)
{
    for (const Group& group : groups_) {
        const bool offered = step < group.until && group.offered();
        for (QAction* part : group.parts)
            part->setVisible(offered && (step < 1 || !captions_.contains(part)));
    }
    tool_->setToolButtonStyle(step < 2 ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    arranging_->showOptions(step < 3);
    canvas_.narrowCapsuleInBar(step >= 4);
    grid_->showSpacing(step < 5);
    export_->setToolButtonStyle(step < 6 ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    capsule_->layout()->invalidate();
    grid_->layout()->invalidate(); // or the sizes are those of before, until events are handled
    layout()->invalidate();
}

void OptionBar::changeEvent(QEvent* event)
{
    QToolBar::changeEvent(event);
    if (event->type() == QEvent::FontChange) { // when its fields have followed, too
        tool_->setFont(semiBold(font()));
        QMetaObject::invokeMethod(
            this, [this] { fitInto(width()); }, Qt::QueuedConnection);
    }
}

void OptionBar::follow()
{
    removed_->choose(int(session_.display().removed));
    const ToolInfo& tool = *findTool(canvas_.tool());
    tool_->setIcon(icon(tool.key));
    tool_->setText(tool.name);
    std::vector<bool> now;
    for (const Group& group : groups_)
        now.push_back(group.offered());
    const QString named = tool_->text() + app::latin(session_.nextWindow); // its options
    if (std::exchange(shown_, now) != now || std::exchange(named_, named) != named)
        fitInto(width());
}

} // namespace ui

#include "moc_option_bar.cpp"

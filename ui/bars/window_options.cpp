// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/window_options.h"

#include "app/document/window_operations.h"
#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "ui/canvas/canvas.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/segments.h"

#include <QHBoxLayout>

#include <algorithm>

namespace ui {

namespace {

QStringList shapeNames()
{
    QStringList names;
    for (const app::WindowKind& kind : app::windowKinds())
        names << Text::tr(kind.name.data());
    return names;
}

std::vector<std::string_view> shapeIcons()
{
    std::vector<std::string_view> keys;
    for (const app::WindowKind& kind : app::windowKinds())
        keys.push_back(kind.key);
    return keys;
}

Segments* useSegments()
{
    QStringList names, tips;
    std::vector<std::string_view> icons;
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        names << each.name;
        tips << Text::tr("The next window: %1").arg(each.name);
        icons.push_back(each.icon);
    }
    auto* segments = new Segments(Text::tr("What the next window does"), names);
    segments->setIcons(icons);
    segments->setTips(tips);
    return segments;
}

} // namespace

WindowOptions::WindowOptions(app::Session& session, Canvas& canvas)
    : session_(session), shape_(new Segments(Text::tr("Shape of the next window"), shapeNames())),
      use_(useSegments()), fromSelection_(new QToolButton)
{
    shape_->setObjectName(QStringLiteral("window-shapes"));
    shape_->setIcons(shapeIcons());
    use_->setObjectName(QStringLiteral("window-use"));
    fromSelection_->setText(Text::tr("From selection"));
    fromSelection_->setObjectName(QStringLiteral("window-from-selection"));
    fromSelection_->setProperty("framed", true);
    fromSelection_->setFixedHeight(space::fieldHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    for (QWidget* part : {static_cast<QWidget*>(shape_), static_cast<QWidget*>(use_),
                          static_cast<QWidget*>(fromSelection_)})
        row->addWidget(part);
    const auto focusCanvas = [&canvas] { canvas.setFocus(); };
    connect(shape_, &Segments::picked, this, [this, focusCanvas](int index) {
        app::WindowPen pen = session_.windowPen;
        pen.kind = app::windowKinds()[std::size_t(index)].key;
        app::setWindowPen(session_, pen);
        focusCanvas();
    });
    connect(use_, &Segments::picked, this, [this, focusCanvas](int index) {
        app::WindowPen pen = session_.windowPen;
        pen.operation = app::WindowOperation(index);
        app::setWindowPen(session_, pen);
        focusCanvas();
    });
    connect(fromSelection_, &QToolButton::clicked, this, [this, focusCanvas] {
        app::addWindowsOfSelection(session_, session_.windowPen.operation);
        app::setWindowPen(session_, app::penAfter(session_.windowPen));
        focusCanvas();
    });
    connect(&session, &app::Session::displayChanged, this, &WindowOptions::follow);
    connect(&session, &app::Session::selectionChanged, this, &WindowOptions::followSelection);
    follow();
    followSelection();
}

void WindowOptions::follow()
{
    const auto kinds = app::windowKinds();
    const auto kind = std::ranges::find(kinds, session_.windowPen.kind, &app::WindowKind::key);
    shape_->choose(int(kind - kinds.begin()));
    use_->choose(int(session_.windowPen.operation));
}

void WindowOptions::followSelection()
{
    const bool some = !session_.selection().empty();
    fromSelection_->setEnabled(some);
    fromSelection_->setToolTip(some ? Text::tr("Make clip windows of the selected objects")
                                    : Text::tr("Nothing is selected. Select closed shapes first."));
}

} // namespace ui

#include "moc_window_options.cpp"

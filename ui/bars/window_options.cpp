// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/window_options.h"

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

} // namespace

WindowOptions::WindowOptions(app::Session& session, Canvas& canvas)
    : session_(session), shape_(new Segments(Text::tr("Shape of the next window"), shapeNames())),
      fromSelection_(new QToolButton)
{
    shape_->setObjectName(QStringLiteral("window-shapes"));
    shape_->setIcons(shapeIcons());
    fromSelection_->setText(Text::tr("From selection"));
    fromSelection_->setObjectName(QStringLiteral("window-from-selection"));
    fromSelection_->setProperty("framed", true);
    fromSelection_->setFixedHeight(space::fieldHeight);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    row->addWidget(shape_);
    row->addWidget(fromSelection_);
    const auto focusCanvas = [&canvas] { canvas.setFocus(); };
    connect(shape_, &Segments::picked, this, [this, focusCanvas](int index) {
        app::setNextWindow(session_, app::windowKinds()[std::size_t(index)].key);
        focusCanvas();
    });
    connect(fromSelection_, &QToolButton::clicked, this, [this, focusCanvas] {
        app::addWindowsOfSelection(session_);
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
    const auto kind = std::ranges::find(kinds, session_.nextWindow, &app::WindowKind::key);
    shape_->choose(int(kind - kinds.begin()));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QToolButton;

namespace ui {

/// A button that looks like a link, for headings.
QToolButton* linkButton();

} // namespace ui

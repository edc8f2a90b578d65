// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/questions.h"

namespace ui {

/// Shows the drawings that earlier runs left unsaved, with their times and a picture of the current
/// one, and the buttons Recover, Discard and Keep for later.
Questions::LeftoverAnswer askAboutLeftovers(QWidget& window,
                                            const std::vector<app::Leftover>& leftovers);

} // namespace ui

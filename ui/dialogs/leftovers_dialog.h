// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/questions.h"

namespace ui {

/// Shows a list of the drawings that earlier runs left unsaved, with the buttons Recover, Discard
/// and Not Now.
Questions::LeftoverAnswer askAboutLeftovers(QWidget& window,
                                            const std::vector<app::Leftover>& leftovers);

} // namespace ui

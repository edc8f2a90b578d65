// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"

#include <cstdint>
#include <string>

namespace app::svg {

/// Appends an image with its file in it, and before it the clip path of one that is cut, whose id
/// ends with `number`. What the image is cut at is also said in `clearcut:clip`, in the coordinates
/// around it, so that it is read again bit for bit.
void appendImage(std::string& text, const Underlay& image, std::uint32_t number);

} // namespace app::svg

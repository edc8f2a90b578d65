// SPDX-License-Identifier: MIT
#pragma once

/// One header to clip: clearcut::clip, clearcut::clipAll (clipping/clip.h) and the version.

#include "clipping/clip.h"
#include "clipping/version.h"

namespace clearcut = clipping;

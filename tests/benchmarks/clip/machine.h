// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Prints the processor, its instruction sets, the compiler and its flags, and which peers are
/// here.
void printMachine();

/// \file
/// What the replay wants of the machine that it runs on.
#pragma once

/// Prints `text` as it is.
void platform_print(const char* text);

/// Around the work of one record, for machines that count what it costs.
void platform_begin_work(void);
void platform_end_work(void);

#include <scrubjay/localization/localizer.hpp>

// The localizers of today are header-only; this gives the room a library to link.

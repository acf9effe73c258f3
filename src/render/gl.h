#pragma once

// The library that makes the context exports every function of the core profile: no loader stands between.
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/glcorearb.h>

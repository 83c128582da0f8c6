#include "io/images.h"

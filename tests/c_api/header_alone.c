/* tagmint.h includes all that it needs, and is C11. */
#include "tagmint/tagmint.h"

/* The sizes of what is passed through arrays must not change by accident. */
_Static_assert(sizeof(tagmint_match) == 12, "tagmint_match");
_Static_assert(TAGMINT_OK == 0, "success is zero");

int main(void) { return tagmint_c_version() == TAGMINT_C_VERSION ? 0 : 1; }

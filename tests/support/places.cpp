#include "support/places.h"

namespace tagmint::test {

std::filesystem::path source_folder() { return TAGMINT_SOURCE_FOLDER; }

std::string program_path() { return TAGMINT_PROGRAM; }

}  // namespace tagmint::test

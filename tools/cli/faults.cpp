#include "cli/faults.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "cli/command.h"
#include "cli/process.h"
#include "cli/standard_output.h"
#include "cli/terminal.h"

namespace tagmint::cli {
namespace {

int fail(int exit_code, const std::string& line) {
  print_error(line);
  return exit_code;
}

}  // namespace

int report_faults(const std::function<int()>& body) {
  try {
    return body();
  } catch (const BrokenPipe&) {
    return kNoOutput;
  } catch (const UsageError& fault) {
    return fail(kUsage, fault.what());
  } catch (const codec::InputError& fault) {
    return fail(kBadInput, fault.what());
  } catch (const codec::OutputError& fault) {
    return fail(kNoOutput, fault.what());
  } catch (const Interrupted& fault) {
    return fail(kInterrupted, fault.what());
  } catch (const std::invalid_argument& error) {
    return fail(kUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kNoOutput, "out of memory; ask for less at once");
  } catch (const std::length_error&) {
    return fail(kNoOutput, "out of memory; ask for less at once");
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string what = error.code().message() + " (" + error.path1().string() + ")";
    return fail(kNoOutput, what + "; choose another place");
  } catch (const std::system_error& error) {
    return fail(kNoOutput, std::string(error.what()) + "; the system gave no more of it");
  } catch (const std::exception& error) {
    return fail(kNoOutput, "internal fault: " + std::string(error.what()) +
                               "; please report it with the command line");
  }
}

}  // namespace tagmint::cli

#include "program/exit_code.hpp"

#include "program/signals.hpp"

#include <floe/numeric/error.hpp>

#include <csignal>
#include <new>

namespace floe::program {

Failure describe(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const UsageError& e) {
    return {kCommandLine, e.what()};
  } catch (const MeshError& e) {
    return {kMesh, e.what()};
  } catch (const DataError& e) {
    return {kData, e.what()};
  } catch (const InputError& e) {
    return {kCase, e.what()};
  } catch (const BudgetError& e) {
    return {kBudget, e.what()};
  } catch (const FileError& e) {
    return {kFile, e.what()};
  } catch (const ConvergenceError& e) {
    return {kConvergence, e.what()};
  } catch (const StoreError& e) {
    return {kStore, e.what()};
  } catch (const BusyError& e) {
    return {kBusy, e.what()};
  } catch (const Interrupted& e) {
    return {kSignal + e.signal, e.signal == SIGINT   ? "interrupted"
                                : e.signal == SIGHUP ? "hung up"
                                                     : "terminated"};
  } catch (const TimeUp& e) {
    return {kTimeUp, std::string("stopped by ") + e.by + " (give --resume to go on)"};
  } catch (const std::bad_alloc&) {
    return {kBudget, "out of memory (give fewer nodes or modes, or run floe check for the need)"};
  } catch (const std::exception& e) {
    return {kBug, std::string("internal error: ") + e.what() +
                      " (floe " FLOE_VERSION
                      "; please report this line with "
                      "the case file)"};
  } catch (...) {
    return {kBug, "internal error (floe " FLOE_VERSION "; please report this with the case file)"};
  }
}

}  // namespace floe::program

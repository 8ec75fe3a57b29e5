#include "bindings.hpp"

#include <floe/numeric/error.hpp>

#include <new>

namespace floe::python {
namespace {

void raise(const char* name, const char* text) {
  const py::object type = py::module_::import("floe._errors").attr(name);
  PyErr_SetString(type.ptr(), text);
}

}  // namespace

void bind_errors() {
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const MeshError& e) {
      raise("MeshError", e.what());
    } catch (const DataError& e) {
      raise("SeaError", e.what());
    } catch (const InputError& e) {
      raise("CaseError", e.what());
    } catch (const BudgetError& e) {
      raise("BudgetError", e.what());
    } catch (const FileError& e) {
      raise("FileError", e.what());
    } catch (const ConvergenceError& e) {
      raise("ConvergenceError", e.what());
    } catch (const StoreError& e) {
      raise("StoreError", e.what());
    } catch (const BusyError& e) {
      raise("BusyError", e.what());
    } catch (const std::bad_alloc&) {
      raise("BudgetError", "out of memory (give fewer nodes or modes)");
    }
  });
}

}  // namespace floe::python

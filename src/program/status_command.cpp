#include "program/commands.hpp"

#include <floe/io/run_state.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace floe::program {
namespace {

using Json = nlohmann::ordered_json;
using Part = io::RunState::Part;

const char* name_of(Part part) {
  return part == Part::kDone      ? "done"
         : part == Part::kDamaged ? "damaged"
         : part == Part::kFailed  ? "failed"
                                  : "open";
}

std::string state_of(const io::RunState& state) {
  if (!state.holder.empty()) return "running (" + state.holder + ")";
  if (!state.complete() || state.status == "complete") return state.status;
  return state.status + ", but all is solved (floe export makes the tables)";
}

Json json_of(const io::RunState& state) {
  Json frequencies = Json::array();
  for (const io::RunState::Frequency& one : state.frequencies) {
    Json entry = {{"omega", one.omega}, {"state", name_of(one.part)}};
    if (one.part == Part::kDone) {
      entry["seconds"] = one.seconds;
      entry["true_residual"] = one.true_residual;
    }
    if (one.part == Part::kFailed) entry["failure"] = one.failure;
    frequencies.push_back(entry);
  }
  Json seas = nullptr;
  if (state.seas_asked)
    seas = {{"done", state.seas_done},
            {"transfer_functions", state.transfers},
            {"transfer_functions_done", state.transfers_done}};
  return {{"title", state.title},
          {"status", state.status},
          {"running", !state.holder.empty()},
          {"holder", state.holder},
          {"shard", {{"index", state.shard.index}, {"count", state.shard.count}}},
          {"done", state.count(Part::kDone)},
          {"total", state.frequencies.size()},
          {"complete", state.complete()},
          {"seconds_left", state.seconds_left},
          {"seas", seas},
          {"frequencies", frequencies}};
}

void tell_frequencies(const io::RunState& state, Account& account) {
  account.info("\n   omega    state    time  residual");
  for (const io::RunState::Frequency& one : state.frequencies)
    account.info(one.part == Part::kDone
                     ? fmt::format("{:8.4g}  {:>7}  {:>6}  {:8.1e}", one.omega, name_of(one.part),
                                   format_duration(one.seconds), one.true_residual)
                     : fmt::format("{:8.4g}  {:>7}{}{}", one.omega, name_of(one.part),
                                   one.failure.empty() ? "" : "  ", one.failure));
  account.info("");
}

}  // namespace

void tell_status(const StatusOptions& options) {
  const io::RunState state = io::look_at_run(options.directory);
  if (options.json) {
    print(json_of(state).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return;
  }
  Account account(ProgressStyle::kPlain);
  account.fact("run",
               options.directory.string() + (state.title.empty() ? "" : " · " + state.title));
  account.fact("state", state_of(state));
  if (state.shard.count > 1)
    account.fact("shard", fmt::format("{} of {}", state.shard.index, state.shard.count));
  tell_frequencies(state, account);
  account.fact("done", fmt::format("{} of {} frequencies", state.count(Part::kDone),
                                   state.frequencies.size()));
  if (state.seas_asked)
    account.fact("seas", state.seas_done       ? "done"
                         : state.transfers > 0 ? fmt::format("{} of {} transfer functions",
                                                             state.transfers_done, state.transfers)
                                               : "not begun");
  if (!state.complete()) account.fact("left", "about " + format_duration(state.seconds_left));
}

}  // namespace floe::program

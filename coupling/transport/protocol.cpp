#include "coupling/transport/protocol.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

namespace gasgrain {
namespace {

template <class T>
void send_to_leader(MPI_Comm partner, const T& message, int tag) {
  static_assert(std::is_trivially_copyable_v<T>);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(&message, sizeof(T), MPI_BYTE, 0, tag, partner, &request);
  wait_sleeping(request);
}

template <class T>
T receive_from_leader(MPI_Comm partner, int tag) {
  T message;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Irecv(&message, sizeof(T), MPI_BYTE, 0, tag, partner, &request);
  wait_sleeping(request);
  return message;
}

template <class T>
void spread(const Communicator& local, T& message) {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&message, sizeof(T), MPI_BYTE, 0, local.handle(), &request);
  wait_sleeping(request);
}

template <class Mine, class Theirs>
Theirs greet(const Communicator& local, MPI_Comm partner, const Mine& mine) {
  Theirs theirs;
  if (local.is_root()) {
    send_to_leader(partner, mine, hello_tag);
    theirs = receive_from_leader<Theirs>(partner, hello_tag);
  }
  spread(local, theirs);
  return theirs;
}

}  // namespace

GasHello greet_gas(const Communicator& local, MPI_Comm partner, const DemHello& mine) {
  return greet<DemHello, GasHello>(local, partner, mine);
}

DemHello greet_dem(const Communicator& local, MPI_Comm partner, const GasHello& mine) {
  return greet<GasHello, DemHello>(local, partner, mine);
}

std::string pairing_faults(const DemHello& dem, const GasHello& gas) {
  std::string faults;
  const auto add = [&](const std::string& text) { faults += (faults.empty() ? "" : "\n") + text; };
  const std::string file = gas.input_file.data();
  if (dem.protocol != gas.protocol) {
    add(fmt::format(
        "gasgrain-liggghts {} and gasgrain-gas {} speak different protocols ({} and {}): "
        "build both from one source.",
        dem.version.data(), gas.version.data(), dem.protocol, gas.protocol));
    return faults;
  }
  constexpr double tolerance = 1e-9;  // of the box length: what printing and reading may lose
  constexpr const char* axes = "xyz";
  for (int d = 0; d < 3; ++d) {
    if (gas.plane_of_spheres != 0 && d == 1) continue;
    const double length = gas.grid_hi[d] - gas.grid_lo[d];
    if (std::abs(dem.box_lo[d] - gas.grid_lo[d]) > tolerance * length ||
        std::abs(dem.box_hi[d] - gas.grid_hi[d]) > tolerance * length)
      add(
          fmt::format("the DEM box spans {} = {} to {} m, the gas grid of {} spans {} to {} m "
                      "([grid] lo, hi): make both the same (with 'boundary f' in the script).",
                      axes[d], dem.box_lo[d], dem.box_hi[d], file, gas.grid_lo[d], gas.grid_hi[d]));
    if (dem.periodic[d] != gas.periodic[d])
      add(
          fmt::format("{} is {}periodic in the script ('boundary'), and {}periodic in {} "
                      "([boundary] {}_lo, {}_hi): make both the same.",
                      axes[d], dem.periodic[d] != 0 ? "" : "not ",
                      gas.periodic[d] != 0 ? "" : "not ", file, axes[d], axes[d]));
  }
  for (const auto& field : gas_field_list) {
    const auto bit = FieldSet().add(field.field).bits();
    const std::uint32_t offered = field.lent ? gas.lends : gas.takes;
    const std::uint32_t wanted = field.lent ? dem.lent : dem.taken;
    if ((wanted & bit) != 0 && (offered & bit) == 0)
      add(
          fmt::format("an effect of the couple/gas line needs the field {}, which this gas "
                      "solver does not have.",
                      field.name));
  }
  if (std::abs(dem.time - gas.time) > 1e-3 * dem.interval)
    add(
        fmt::format("the gas state is of time {} s, the DEM state of {} s: restart both from "
                    "checkpoints of one step, or neither.",
                    gas.time, dem.time));
  return faults;
}

void send_command(const Communicator& local, MPI_Comm partner, const Command& command) {
  if (local.is_root()) send_to_leader(partner, command, command_tag);
}

Command receive_command(const Communicator& local, MPI_Comm partner) {
  Command command;
  if (local.is_root()) command = receive_from_leader<Command>(partner, command_tag);
  spread(local, command);
  return command;
}

void send_report(const Communicator& local, MPI_Comm partner, const Report& report) {
  if (local.is_root()) send_to_leader(partner, report, report_tag);
}

Report receive_report(const Communicator& local, MPI_Comm partner) {
  return local.is_root() ? receive_from_leader<Report>(partner, report_tag) : Report{};
}

void send_text(const Communicator& local, MPI_Comm partner, const std::string& text) {
  if (!local.is_root()) return;
  send_to_leader(partner, text.size(), text_tag);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Isend(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, text_tag, partner, &request);
  wait_sleeping(request);
}

std::string receive_text(const Communicator& local, MPI_Comm partner) {
  if (!local.is_root()) return "";
  std::string text(receive_from_leader<std::size_t>(partner, text_tag), '\0');
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Irecv(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, text_tag, partner, &request);
  wait_sleeping(request);
  return text;
}

std::vector<IndexBox> swap_boxes(MPI_Comm partner, const IndexBox& mine) {
  static_assert(sizeof(IndexBox) == 6 * sizeof(int));
  int partners = 0;
  MPI_Comm_remote_size(partner, &partners);
  std::vector<IndexBox> boxes(partners);
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallgather(&mine, 6, MPI_INT, boxes.data(), 6, MPI_INT, partner, &request);
  wait_sleeping(request);
  return boxes;
}

}  // namespace gasgrain

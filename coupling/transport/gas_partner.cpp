#include "coupling/transport/gas_partner.h"

namespace gasgrain {
namespace {

class RemoteGas : public GasPartner {
 public:
  RemoteGas(const Communicator& local, MPI_Comm partner) : local_(local), partner_(partner) {}

  GasHello greet(const DemHello& mine) override { return greet_gas(local_, partner_, mine); }
  void send_command(const Command& command) override {
    gasgrain::send_command(local_, partner_, command);
  }
  RouteTransport connect(const BoxGrid& grid, const IndexBox& tile) override {
    return {partner_, make_routes(grid, tile, swap_boxes(partner_, tile), false), false};
  }
  Report receive_report() override { return gasgrain::receive_report(local_, partner_); }
  std::string finish() override {
    send_command(Command{});
    return receive_text(local_, partner_);
  }

 private:
  Communicator local_;
  MPI_Comm partner_;
};

}  // namespace

std::unique_ptr<GasPartner> make_remote_gas(const Communicator& local, MPI_Comm partner) {
  return std::make_unique<RemoteGas>(local, partner);
}

}  // namespace gasgrain

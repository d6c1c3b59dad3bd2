#include "gas_solver/input/named_choice.h"
#include "gas_solver/input/readers.h"

namespace gasgrain {

void read_gas(InputTable table, GasInput& input) {
  input.law = named_choice(
      table, "law", input.law,
      {{"constant_density", GasLaw::constant_density}, {"ideal_gas", GasLaw::ideal_gas}});
  const bool ideal = input.law == GasLaw::ideal_gas;
  input.density =
      table
          .when(!ideal, "law = \"constant_density\"",
                "an ideal gas' density follows from pressure, temperature and molar_mass; leave "
                "the key out")
          .number("density", input.density, Range::positive(), "kg/m3");
  InputTable of_ideal = table.when(ideal, "law = \"ideal_gas\"",
                                   "set that, or leave the key out and give the density");
  input.reference_pressure =
      of_ideal.number("pressure", input.reference_pressure, Range::positive(), "Pa");
  input.temperature = of_ideal.number("temperature", input.temperature, Range::positive(), "K");
  input.molar_mass = of_ideal.number("molar_mass", input.molar_mass, Range::positive(), "kg/mol");
  if (ideal)
    input.density =
        input.reference_pressure * input.molar_mass / (gas_constant * input.temperature);
  input.viscosity = table.number("viscosity", input.viscosity, Range::not_negative(), "Pa s");
  input.gravity = table.vec3("gravity", input.gravity, Range::any(), "m/s2");
  input.model = named_choice(table, "model", input.model, {{"A", GasModel::a}, {"B", GasModel::b}});
}

void read_turbulence(InputTable table, GasInput& input) {
  TurbulenceInput& turbulence = input.turbulence;
  turbulence.model = named_choice(table, "model", turbulence.model,
                                  {{"none", TurbulenceModel::none},
                                   {"smagorinsky", TurbulenceModel::smagorinsky},
                                   {"k_epsilon", TurbulenceModel::k_epsilon}});
  turbulence.smagorinsky_constant =
      table.when(turbulence.model == TurbulenceModel::smagorinsky, "model = \"smagorinsky\"")
          .number("smagorinsky_constant", turbulence.smagorinsky_constant, Range::within(0, 1),
                  "1");
  InputTable of_k_epsilon =
      table.when(turbulence.model == TurbulenceModel::k_epsilon, "model = \"k_epsilon\"");
  turbulence.intensity =
      of_k_epsilon.number("intensity", turbulence.intensity, Range::positive_up_to(1), "1");
  turbulence.length_scale =
      of_k_epsilon.number("length_scale", turbulence.length_scale, Range::not_negative(), "m");
  if (turbulence.model == TurbulenceModel::k_epsilon && input.viscosity == 0)
    table.fault("model",
                "turbulence.model = \"k_epsilon\" needs a [gas] viscosity above 0: its wall law is "
                "one of the distance from the wall in viscous lengths.");
}

}  // namespace gasgrain

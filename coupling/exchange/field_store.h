// The fields of a FieldSet over one box of cells, by name. What is not in the set is not there.
#pragma once

#include <array>
#include <vector>

#include "coupling/base/array3.h"
#include "coupling/base/error.h"
#include "coupling/exchange/gas_fields.h"
#include "coupling/exchange/particle_weights.h"

namespace gasgrain {

class FieldStore {
 public:
  FieldStore() = default;
  FieldStore(FieldSet set, const IndexBox& box) : set_(set) {
    for (const GasFieldInfo& field : gas_field_list)
      if (set.has(field.field))
        for (int d = 0; d < field.components; ++d) place(field.field)[d] = Array3<double>(box);
  }

  [[nodiscard]] bool has(GasField field) const { return set_.has(field); }
  // Throws Error when the field is not in the set.
  VectorField& vector(GasField field) { return present(field); }
  [[nodiscard]] const VectorField& vector(GasField field) const {
    return const_cast<FieldStore*>(this)->present(field);
  }
  Array3<double>& scalar(GasField field) { return present(field)[0]; }
  [[nodiscard]] const Array3<double>& scalar(GasField field) const {
    return const_cast<FieldStore*>(this)->present(field)[0];
  }
  // Every component of the fields of both sets, in the order of the LIST.
  std::vector<Array3<double>*> components(FieldSet which) {
    std::vector<Array3<double>*> list;
    for (const GasFieldInfo& field : gas_field_list)
      if (set_.has(field.field) && which.has(field.field))
        for (int d = 0; d < field.components; ++d) list.push_back(&place(field.field)[d]);
    return list;
  }

 private:
  VectorField& place(GasField field) { return fields_[static_cast<std::size_t>(field)]; }
  VectorField& present(GasField field) {
    if (!has(field))
      fail("the field {} is not there although an effect of the scene needs it", info(field).name);
    return place(field);
  }

  FieldSet set_;
  std::array<VectorField, gas_field_list.size()> fields_;
};

}  // namespace gasgrain

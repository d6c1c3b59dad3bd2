#include "coupling/exchange/effects.h"

#include <gtest/gtest.h>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

std::string faults_of(const std::vector<std::string>& words) {
  try {
    parse_effects(words, "in.liggghts:12");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(effects, are_read_from_the_words_of_a_line) {
  const Effects effects =
      parse_effects({"drag", "koch_hill", "void_fraction", "offset", "pressure_gradient"}, "test");
  EXPECT_EQ(effects.text(), "void_fraction offset drag koch_hill pressure_gradient");
  EXPECT_TRUE(effects.lent().has(GasField::velocity));
  EXPECT_TRUE(effects.lent().has(GasField::void_fraction));
  EXPECT_TRUE(effects.lent().has(GasField::pressure_gradient));
  EXPECT_TRUE(effects.taken().has(GasField::drag_source));
}

TEST(effects, read_their_own_text) {
  for (const auto& drag : choice_names<DragModel>())
    for (const auto& method : choice_names<VoidFractionMethod>()) {
      const std::string text =
          parse_effects({"drag", drag, "void_fraction", method}, "test").text();
      EXPECT_EQ(text, "void_fraction " + method + " drag " + drag);
    }
}

TEST(effects, that_are_absent_ask_for_no_fields) {
  const Effects none = parse_effects({}, "test");
  EXPECT_EQ(none.text(), "void_fraction trilinear");
  EXPECT_EQ(none.lent().bits(), 0U);
  EXPECT_EQ(none.taken().bits(), FieldSet().add(GasField::solid_volume).bits());
  const Effects drag = parse_effects({"drag", "di_felice"}, "test");
  EXPECT_FALSE(drag.lent().has(GasField::pressure_gradient));
  const Effects pressure = parse_effects({"pressure_gradient"}, "test");
  EXPECT_EQ(pressure.lent().bits(), FieldSet().add(GasField::pressure_gradient).bits());
  EXPECT_FALSE(pressure.taken().has(GasField::drag_coefficient));
}

TEST(effects, with_faults_are_refused_with_all_of_them_and_the_nearest_names) {
  const std::string text =
      faults_of({"drag", "koch_hil", "void_fraction", "ofset", "presure_gradient"});
  EXPECT_EQ(text,
            "in.liggghts:12: drag \"koch_hil\" is unknown. Did you mean \"koch_hill\"?\n"
            "in.liggghts:12: void_fraction \"ofset\" is unknown. Did you mean \"offset\"?\n"
            "in.liggghts:12: the effect \"presure_gradient\" is unknown. Did you mean "
            "\"pressure_gradient\"?");
}

TEST(effects, without_the_name_they_need_say_which_there_are) {
  EXPECT_EQ(faults_of({"drag", "pressure_gradient"}),
            "in.liggghts:12: \"drag\" must be followed by one of: ergun_wen_yu, koch_hill, "
            "di_felice, gidaspow, gidaspow_blend, hill_koch_ladd, beetstra, tenneti, tang, "
            "schiller_naumann.");
  EXPECT_NE(faults_of({"void_fraction"}).find("centre, offset, trilinear"), std::string::npos);
}

TEST(effects, named_twice_are_refused) {
  EXPECT_EQ(faults_of({"drag", "koch_hill", "drag", "di_felice"}),
            "in.liggghts:12: \"drag\" is named twice. Remove one of them.");
  EXPECT_NE(faults_of({"pressure_gradient", "pressure_gradient"}).find("twice"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain

// A contact law (dem_physics/contact) as a sub-model of the host's contact models: shows it each
// contact as a ContactView, and gives the host what the law answers. No physics; all of it is
// inlined into the host's loop.
#pragma once

#include <cmath>
#include <string>

#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_law.h"
#include "fix_cfd_coupling/liggghts/contact_host_liggghts.h"
#include "fix_cfd_coupling/liggghts/contact_styles_words.h"
// The host's headers lean on each other's order.
#include "fix_insert_stream.h"
// --
#include "contact_models.h"
// --
#include "atom.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "tri_mesh.h"
#include "update.h"

namespace gasgrain {

using CloseData = LIGGGHTS::ContactModels::SurfacesCloseData;
using IntersectData = LIGGGHTS::ContactModels::SurfacesIntersectData;
using HostForces = LIGGGHTS::ContactModels::ForceData;
using HostSettings = ::Settings;

class WordsOfSettings final : public contact::LawWords {
 public:
  explicit WordsOfSettings(HostSettings& settings) : settings_(settings) {}
  void number(const char* word, double& value, double otherwise) override {
    know_contact_word(word);
    settings_.registerDoubleSetting(word, value, otherwise);
  }
  void on_off(const char* word, bool& value, bool otherwise) override {
    know_contact_word(word);
    settings_.registerOnOff(word, value, otherwise);
  }

 private:
  HostSettings& settings_;
};

// Triangles have numbers of their own in each mesh of a wall; a primitive wall is one place.
class MeshPlaces final : public contact::WallParts {
 public:
  explicit MeshPlaces(LAMMPS_NS::TriMesh* mesh) : mesh_(mesh) {}

  static double of(const CloseData& data, LAMMPS_NS::FixWallGran& wall) {
    if (!wall.is_mesh_wall()) return 0.0;
    int mesh = 0;
    while (mesh < wall.n_meshes() && wall.mesh_list()[mesh] != data.fix_mesh) ++mesh;
    return meshes * (1.0 + data.mesh->id(data.j)) + mesh;
  }
  [[nodiscard]] bool goes_on(double from, double to) const override {
    if (from < meshes) return false;
    const auto triangle = [](double at) { return static_cast<int>(std::floor(at / meshes)) - 1; };
    return std::fmod(from, meshes) == std::fmod(to, meshes) && mesh_->map(triangle(from), 0) >= 0 &&
           mesh_->areCoplanarNodeNeighs(triangle(from), triangle(to));
  }

 private:
  static constexpr double meshes = 1024.0;  // of one wall, at most
  LAMMPS_NS::TriMesh* mesh_;
};

// What the adaptors of both kinds of laws share.
template <class Law>
class LawOfHost {
 public:
  // `name`: with the script's word before it, for messages.
  LawOfHost(LAMMPS_NS::LAMMPS* host, LIGGGHTS::IContactHistorySetup* place,
            LIGGGHTS::ContactModels::ContactModelBase* model, const std::string& name)
      : asked(*host, *place, name) {
    for (const auto& value : Law::history(model->is_wall())) {
      const int at = place->add_history_value(value.name, value.changes_sign ? "1" : "0");
      if (remembers_) continue;
      remembers_ = true;
      offset_ = at;
      asked.set_history_offset(at);
      model->add_history_offset(value.name, at);
    }
  }

  // Once for each law that acts: a law may warn, or count what it asks for.
  void connect() {
    if (!asked.has_own_loop()) law.connect(asked);
  }

  contact::ContactView view(const CloseData& data, LAMMPS_NS::Atom& atom,
                            LAMMPS_NS::Update& update) const {
    contact::ContactView c;
    c.i = data.i;
    c.j = data.j;
    c.itype = data.itype;
    c.jtype = data.jtype;
    c.is_wall = data.is_wall;
    c.owns_j = data.j < atom.nlocal;
    c.radi = data.radi;
    c.radj = data.radj;
    c.radsum = data.radsum;
    c.rsq = data.rsq;
    c.delta = data.delta;
    c.v_i = data.v_i;
    c.v_j = data.v_j;
    c.omega_i = data.omega_i;
    c.omega_j = data.omega_j;
    c.updates = data.computeflag != 0 && data.shearupdate != 0;
    c.history = data.contact_history == nullptr ? nullptr : data.contact_history + offset_;
    c.dt = update.dt;
    c.step = update.ntimestep;
    c.area_ratio = data.area_ratio;
    c.place = 0.0;
    c.parts = nullptr;
    c.keep = false;
    c.acts = false;
    return c;
  }
  contact::ContactView view_of_gap(const CloseData& data, LAMMPS_NS::Atom& atom,
                                   LAMMPS_NS::Update& update) const {
    contact::ContactView c = view(data, atom, update);
    // The data have those of the last pair that touched.
    c.omega_i = atom.omega[data.i];
    if (!data.is_wall) c.omega_j = atom.omega[data.j];
    return c;
  }
  contact::ContactView view_of_touch(const IntersectData& data, LAMMPS_NS::Atom& atom,
                                     LAMMPS_NS::Update& update) const {
    contact::ContactView c = view(data, atom, update);
    c.en = data.en;
    c.overlap = data.deltan;
    c.vn = data.vn;
    c.meff = data.meff;
    c.kn = data.kn;
    c.kt = data.kt;
    c.Fn = data.Fn;
    return c;
  }
  // What the host keeps of a contact when it makes its lists anew.
  void keep(const contact::ContactView& c, const CloseData& data) const {
    if (!c.updates || !remembers_ || data.contact_flags == nullptr) return;
    if (c.keep)
      *data.contact_flags |= LIGGGHTS::ContactModels::CONTACT_COHESION_MODEL;
    else
      *data.contact_flags &= ~LIGGGHTS::ContactModels::CONTACT_COHESION_MODEL;
  }
  static contact::ContactForces forces(HostForces& i, HostForces& j) {
    return {i.delta_F, i.delta_torque, j.delta_F, j.delta_torque};
  }

  Law law;
  ContactHostLiggghts asked;

 private:
  bool remembers_ = false;
  int offset_ = 0;  // of the law's values in a contact's row, where it remembers any
};

template <class Law>
class CohesionAdaptor : public LIGGGHTS::ContactModels::CohesionModelBase {
 public:
  CohesionAdaptor(LAMMPS_NS::LAMMPS* host, LIGGGHTS::IContactHistorySetup* place,
                  LIGGGHTS::ContactModels::ContactModelBase* model, const char* name)
      : CohesionModelBase(host, place, model),
        own_(host, place, model, std::string("cohesion ") + name) {}

  void registerSettings(HostSettings& settings) override {
    WordsOfSettings words(settings);
    own_.law.words(words);
  }
  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {}
  void connectToProperties(::PropertyRegistry&) override { own_.connect(); }
  void beginPass(IntersectData&, HostForces&, HostForces&) override { own_.law.begin_pass(); }
  void endPass(IntersectData&, HostForces&, HostForces&) override {}

  [[gnu::flatten]] void surfacesIntersect(IntersectData& data, HostForces& i,
                                          HostForces& j) override {
    auto c = own_.view_of_touch(data, *atom, *update);
    at_place(c, data, [&] { own_.law.touching(c, own_.forces(i, j)); });
    own_.keep(c, data);
    data.Fn = c.Fn;
  }
  [[gnu::flatten]] void endSurfacesIntersect(IntersectData& data, HostForces& i,
                                             HostForces& j) override {
    auto c = own_.view_of_touch(data, *atom, *update);
    own_.law.after_all(c, own_.forces(i, j));
  }
  [[gnu::flatten]] void surfacesClose(CloseData& data, HostForces& i, HostForces& j) override {
    auto c = own_.view_of_gap(data, *atom, *update);
    at_place(c, data, [&] { own_.law.apart(c, own_.forces(i, j)); });
    own_.keep(c, data);
    data.has_force_update = data.has_force_update || c.acts;
  }

 private:
  template <class Act>
  void at_place(contact::ContactView& c, const CloseData& data, const Act& act) {
    if constexpr (Law::at_places) {
      if (c.is_wall) {
        const MeshPlaces parts(data.mesh);
        c.place = MeshPlaces::of(data, *own_.asked.wall());
        c.parts = data.mesh != nullptr ? &parts : nullptr;
        act();
        return;
      }
    }
    act();
  }

  LawOfHost<Law> own_;
};

template <class Law>
class RollingAdaptor : public LIGGGHTS::ContactModels::RollingModelBase {
 public:
  RollingAdaptor(LAMMPS_NS::LAMMPS* host, LIGGGHTS::IContactHistorySetup* place,
                 LIGGGHTS::ContactModels::ContactModelBase* model, const char* name)
      : RollingModelBase(host, place, model),
        own_(host, place, model, std::string("rolling_friction ") + name) {}

  void registerSettings(HostSettings& settings) override {
    WordsOfSettings words(settings);
    own_.law.words(words);
  }
  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {}
  void connectToProperties(::PropertyRegistry&) override { own_.connect(); }
  void beginPass(IntersectData&, HostForces&, HostForces&) override {}
  void endPass(IntersectData&, HostForces&, HostForces&) override {}

  [[gnu::flatten]] void surfacesIntersect(IntersectData& data, HostForces& i,
                                          HostForces& j) override {
    auto c = own_.view_of_touch(data, *atom, *update);
    own_.law.touching(c, own_.forces(i, j));
  }
  [[gnu::flatten]] void surfacesClose(CloseData& data, HostForces& i, HostForces& j) override {
    auto c = own_.view_of_gap(data, *atom, *update);
    own_.law.apart(c, own_.forces(i, j));
  }

 private:
  LawOfHost<Law> own_;
};

}  // namespace gasgrain

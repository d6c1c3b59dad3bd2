// Contacts of one pair of types that were found but not yet computed, in the order in which they
// were found (contact_batch.h).
#pragma once

namespace gasgrain::contact {

struct alignas(64) ContactQueue {
  static constexpr int capacity = 64;
  alignas(64) double delta[capacity][4];  // x_i - x_j, R_i + R_j
  double* row[capacity];                  // of the history
  int i[capacity], j[capacity];
  int count = 0;
};

}  // namespace gasgrain::contact

// Ctrl-C (SIGINT), SIGTERM and SIGHUP as a count that the waiting loops look at.
#pragma once

namespace gasgrain {

// From here on these signals no longer end this program.
void catch_stop_requests();

// How often a stop was asked for so far.
int stop_requests();

}  // namespace gasgrain

// The LIST of our models of rolling friction, as that of the cohesion models:
// ROLLING_MODEL(CONSTANT, name, id). Ids are below 64; the host has 1 to 4 and 6.

/** Flights of drones: waypoints, approaches over the ground, dives, swarms, steered and recorded flights. */
package org.dronewatch.flight;

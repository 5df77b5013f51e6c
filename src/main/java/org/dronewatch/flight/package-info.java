/** Flight paths: waypoints, approaches over the ground, dives, swarms. */
package org.dronewatch.flight;

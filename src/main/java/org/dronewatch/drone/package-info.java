/** Drones: a mesh with an attitude, its sound, radar, thermal and radio signatures, and its intent. */
package org.dronewatch.drone;

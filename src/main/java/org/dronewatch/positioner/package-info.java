/** Positioners, which turn sensors: they search, and follow a drone once another sensor cues them. */
package org.dronewatch.positioner;

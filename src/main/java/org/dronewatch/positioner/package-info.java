/** Positioners, which turn sensors: they search, and follow once another sensor cues them. */
package org.dronewatch.positioner;

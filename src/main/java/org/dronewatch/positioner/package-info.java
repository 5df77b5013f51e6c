/** Motorised mounts: they search, and follow once another sensor cues them. */
package org.dronewatch.positioner;

/**
 * The association of measurements with contacts. Only {@link org.dronewatch.tracking.PerfectAssociation} reads the
 * truth; results hold no reference to it.
 */
package org.dronewatch.tracking;

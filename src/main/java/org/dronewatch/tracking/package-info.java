/**
 * The association of measurements with contacts. Only {@link org.dronewatch.tracking.PerfectAssociation} reads the
 * truth; it cannot be reached from the results.
 */
package org.dronewatch.tracking;

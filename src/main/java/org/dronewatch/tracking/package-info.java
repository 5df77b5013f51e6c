/**
 * The association of measurements with contacts. In this package, only
 * {@link org.dronewatch.tracking.PerfectAssociation} reads the truth; contacts and their looks contain none of it.
 */
package org.dronewatch.tracking;

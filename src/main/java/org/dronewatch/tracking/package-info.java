/**
 * From measurements to contacts: which measurements belong together. Only
 * {@link org.dronewatch.tracking.PerfectAssociation} reads the truth; nothing of it can be reached from what it gives.
 */
package org.dronewatch.tracking;

/** Pictures of cameras with the drones in them marked, for those who train and test detectors. */
package org.dronewatch.report.labels;

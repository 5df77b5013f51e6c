/** Pictures taken by cameras, with the drones in them labelled, for training and testing detectors. */
package org.dronewatch.report.labels;

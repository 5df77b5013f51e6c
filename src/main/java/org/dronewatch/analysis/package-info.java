/** Analysis of a sensor layout without simulating flights: coverage of a site, calibration of a sensor. */
package org.dronewatch.analysis;

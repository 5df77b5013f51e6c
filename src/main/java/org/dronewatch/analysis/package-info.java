/** Analysis of a sensor layout without simulating flights: coverage. */
package org.dronewatch.analysis;

/** Propagation of radio waves in a site: diffraction at its edges, and reflection from the ground. */
package org.dronewatch.sensor.radio;

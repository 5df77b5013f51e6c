/** The exposure of a drone along a leg: the rate at which it is detected, integrated over the time of flight. */
package org.dronewatch.route.exposure;

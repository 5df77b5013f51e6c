/** The exposure of a drone along a leg, which is integrated over the time of its flight. */
package org.dronewatch.route.exposure;
